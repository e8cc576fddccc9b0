#include "ui/browse/thumbnail_maker.h"

#include <sys/prctl.h>
#include <sys/resource.h>

#include <csignal>

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>
#include <utility>

namespace dermis {
namespace {

constexpr int kSamples = 8;

/// What shows a material best: a face, an eye from near, a ball.
QStringList lookFor(const PresetEntry& entry) {
  switch (entry.material.model) {
    case ShadingModel::Skin:
    case ShadingModel::Thesis:
      return {QStringLiteral("--material"), QStringLiteral("face=") + entry.path, QStringLiteral("--camera"),
              QStringLiteral(R"({"position":[0.17,0.02,0.62],"target":[0.0,-0.04,0.0],"vertical_fov_degrees":24})")};
    case ShadingModel::Eye:
      return {QStringLiteral("--material"), QStringLiteral("eye=") + entry.path, QStringLiteral("--camera"),
              QStringLiteral(R"({"position":[0.034,0.0,0.16],"target":[0.032,0,0],"vertical_fov_degrees":22})")};
    default:
      return {QStringLiteral("--model"), QStringLiteral("builtin:sphere"), QStringLiteral("--material"),
              QStringLiteral("*=") + entry.path};
  }
}

}  // namespace

ThumbnailMaker::ThumbnailMaker(QObject* parent)
    : QObject(parent),
      m_folder(QStandardPaths::writableLocation(QStandardPaths::CacheLocation) + QStringLiteral("/thumbnails")),
      m_program(QCoreApplication::applicationDirPath() + QStringLiteral("/dermis")) {
  QDir().mkpath(m_folder);
  m_process.setStandardOutputFile(QProcess::nullDevice());
  m_process.setStandardErrorFile(QProcess::nullDevice());
  m_process.setChildProcessModifier([] {
    setpriority(PRIO_PROCESS, 0, 19);
    prctl(PR_SET_PDEATHSIG, SIGKILL);  // one that stands still must not outlive an editor that crashed
  });
  connect(&m_process, &QProcess::finished, this, [this](int code) { finished(code == 0); });
  connect(&m_process, &QProcess::errorOccurred, this, [this](QProcess::ProcessError error) {
    if (error == QProcess::FailedToStart) finished(false);
  });
  m_later.setSingleShot(true);
  m_later.setInterval(kWaitMs);
  connect(&m_later, &QTimer::timeout, this, &ThumbnailMaker::next);
  m_yielding.setSingleShot(true);
  m_yielding.setInterval(kYieldMs);
  connect(&m_yielding, &QTimer::timeout, this, [this] {
    signalProcess(SIGCONT);
    if (!m_later.isActive()) next();
  });
}

ThumbnailMaker::~ThumbnailMaker() { cancel(); }

QImage ThumbnailMaker::find(const PresetEntry& entry) const {
  const QString file = m_folder + QLatin1Char('/') + entry.key + QStringLiteral(".png");
  return QFileInfo::exists(file) ? QImage(file) : QImage();
}

void ThumbnailMaker::want(const std::vector<PresetEntry>& entries) {
  m_queue.clear();
  if (!m_enabled || !QFileInfo(m_program).isExecutable()) return;
  for (const PresetEntry& entry : entries) {
    if (entry.key == m_current || m_failed.contains(entry.key)) continue;
    if (QFileInfo::exists(m_folder + QLatin1Char('/') + entry.key + QStringLiteral(".png"))) continue;
    m_queue.push_back({entry.key, lookFor(entry)});
  }
  if (m_queue.empty() && m_current.isEmpty()) return;
  m_later.start();
  Q_EMIT progressed(m_done, waiting());
}

void ThumbnailMaker::next() {
  if (m_held || m_yielding.isActive() || !m_current.isEmpty() || m_queue.empty()) return;
  const Order order = std::move(m_queue.front());
  m_queue.pop_front();
  m_current = order.key;
  const QString size = QString::number(kSide);
  m_process.start(m_program,
                  QStringList{QStringLiteral("render")} + order.look +
                      QStringList{QStringLiteral("--size"), size + QLatin1Char('x') + size, QStringLiteral("--samples"),
                                  QString::number(kSamples), QStringLiteral("--no-metadata"), QStringLiteral("-o"),
                                  m_folder + QLatin1Char('/') + order.key + QStringLiteral(".png")});
}

void ThumbnailMaker::finished(bool well) {
  const QString key = std::exchange(m_current, QString());
  if (key.isEmpty()) return;
  ++m_done;
  if (well)
    Q_EMIT made(key);
  else
    m_failed.insert(key);
  Q_EMIT progressed(m_done, waiting());
  if (m_queue.empty()) m_done = 0;
  next();
}

void ThumbnailMaker::hold(bool held) {
  if (std::exchange(m_held, held) && !held && !m_queue.empty()) m_later.start();
}

void ThumbnailMaker::yield() {
  if (!m_yielding.isActive()) signalProcess(SIGSTOP);
  m_yielding.start();
}

void ThumbnailMaker::signalProcess(int signal) {
  if (m_process.processId() > 0) kill(static_cast<pid_t>(m_process.processId()), signal);
}

void ThumbnailMaker::setEnabled(bool enabled) {
  m_enabled = enabled;
  if (!enabled) cancel();
}

void ThumbnailMaker::cancel() {
  m_later.stop();
  m_queue.clear();
  m_current.clear();
  m_done = 0;
  if (m_process.state() != QProcess::NotRunning) {
    m_process.kill();
    m_process.waitForFinished(1000);
  }
  Q_EMIT progressed(0, 0);
}

}  // namespace dermis
