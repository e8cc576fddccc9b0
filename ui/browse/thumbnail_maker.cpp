#include "ui/browse/thumbnail_maker.h"

#include <sys/prctl.h>
#include <sys/resource.h>

#include <algorithm>
#include <csignal>

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>
#include <utility>

namespace dermis {
namespace {

constexpr int kSamples = 8;

/// In one process: enough that they share its start, few enough that what comes into view next needn't wait long.
constexpr std::size_t kTogether = 8;

}  // namespace

ThumbnailMaker::ThumbnailMaker(QObject* parent)
    : QObject(parent),
      m_folder(QStandardPaths::writableLocation(QStandardPaths::CacheLocation) + QStringLiteral("/thumbnails")),
      m_program(QCoreApplication::applicationDirPath() + QStringLiteral("/dermis")) {
  QDir().mkpath(m_folder);
  m_process.setStandardErrorFile(QProcess::nullDevice());
  m_process.setChildProcessModifier([] {
    setpriority(PRIO_PROCESS, 0, 19);
    prctl(PR_SET_PDEATHSIG, SIGKILL);  // one that stands still must not outlive an editor that crashed
  });
  connect(&m_process, &QProcess::readyReadStandardOutput, this, &ThumbnailMaker::readMade);
  connect(&m_process, &QProcess::finished, this, [this](int, QProcess::ExitStatus status) {
    readMade();
    finished(status == QProcess::CrashExit);
  });
  connect(&m_process, &QProcess::errorOccurred, this, [this](QProcess::ProcessError error) {
    if (error == QProcess::FailedToStart) finished(false);
  });
  m_later.setSingleShot(true);
  m_later.setInterval(kWaitMs);
  connect(&m_later, &QTimer::timeout, this, &ThumbnailMaker::next);
  m_yielding.setSingleShot(true);
  m_yielding.setInterval(kYieldMs);
  connect(&m_yielding, &QTimer::timeout, this, [this] {
    if (m_held) return;
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
    if (isBeingDrawn(entry.key) || m_failed.contains(entry.key)) continue;
    if (QFileInfo::exists(m_folder + QLatin1Char('/') + entry.key + QStringLiteral(".png"))) continue;
    m_queue.push_back({entry.key, entry.path});
  }
  if (waiting() == 0) return;
  m_later.start();
  Q_EMIT progressed(m_done, waiting());
}

void ThumbnailMaker::next() {
  if (m_held || m_yielding.isActive() || !m_current.empty() || m_queue.empty()) return;
  if (m_shown)
    std::stable_partition(m_queue.begin(), m_queue.end(),
                          [shown = m_shown()](const Order& order) { return shown.contains(order.key); });
  QStringList arguments{QStringLiteral("thumbnails")};
  for (std::size_t i = std::min(kTogether, m_queue.size()); i > 0; --i) {
    arguments << m_queue.front().key + QLatin1Char('=') + m_queue.front().path;
    m_current.push_back(std::move(m_queue.front()));
    m_queue.pop_front();
  }
  const QString size = QString::number(kSide);
  arguments << QStringLiteral("--size") << size + QLatin1Char('x') + size << QStringLiteral("--samples")
            << QString::number(kSamples) << QStringLiteral("-o") << m_folder;
  m_process.start(m_program, arguments);
}

void ThumbnailMaker::readMade() {
  while (m_process.canReadLine()) {
    const QString key = QFileInfo(QString::fromLocal8Bit(m_process.readLine()).trimmed()).completeBaseName();
    if (std::erase_if(m_current, [&](const Order& order) { return order.key == key; }) == 0) continue;
    ++m_done;
    Q_EMIT made(key);
    Q_EMIT progressed(m_done, waiting());
  }
}

void ThumbnailMaker::finished(bool crashed) {
  if (m_current.empty()) {
    if (m_queue.empty()) m_done = 0;
    next();
    return;
  }
  // A crash is the fault of the one that was being drawn; the others are asked for again.
  auto failed = m_current.begin();
  for (const auto end = crashed ? failed + 1 : m_current.end(); failed != end; ++failed, ++m_done)
    m_failed.insert(failed->key);
  m_queue.insert(m_queue.begin(), failed, m_current.end());
  m_current.clear();
  Q_EMIT progressed(m_done, waiting());
  if (m_queue.empty()) m_done = 0;
  next();
}

bool ThumbnailMaker::isBeingDrawn(const QString& key) const {
  return std::ranges::any_of(m_current, [&](const Order& order) { return order.key == key; });
}

void ThumbnailMaker::hold(bool held) {
  if (std::exchange(m_held, held) == held) return;
  if (held) {
    signalProcess(SIGSTOP);
    return;
  }
  if (!m_yielding.isActive()) signalProcess(SIGCONT);
  if (!m_queue.empty()) m_later.start();
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
