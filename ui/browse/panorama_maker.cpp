#include "ui/browse/panorama_maker.h"

#include <QCryptographicHash>
#include <QDir>
#include <QFileInfo>
#include <QSaveFile>
#include <QStandardPaths>

#include "core/base/file_reference.h"
#include "core/base/resources.h"
#include "core/builtin/environments.h"
#include "core/io/asset_loader.h"
#include "ui/text.h"
#include "ui/thumbnails.h"

namespace dermis {
namespace {
constexpr const char* kPictureVersion = "panorama 3";

std::shared_ptr<const EnvironmentImages> imagesOf(const std::string& environment, int width) {
  if (const auto name = builtinName(environment)) return builtinEnvironment(*name, width);
  EnvironmentSource source;
  source.builtin.clear();
  source.path = environment;
  Warnings ignored;
  const auto images = resolveEnvironment(source, {}, {}, ignored);
  return images ? *images : nullptr;
}

}  // namespace

PanoramaMaker::PanoramaMaker(QSize size, QObject* parent)
    : QObject(parent),
      m_size(size),
      m_folder(QStandardPaths::writableLocation(QStandardPaths::CacheLocation) + QStringLiteral("/thumbnails")) {
  QDir().mkpath(m_folder);
  m_pool.setMaxThreadCount(1);
  m_pool.setThreadPriority(QThread::LowestPriority);
}

PanoramaMaker::~PanoramaMaker() {
  ++m_round;
  m_pool.clear();
  m_pool.waitForDone();
}

QString PanoramaMaker::cacheFile(const QString& environment) const {
  QCryptographicHash hash(QCryptographicHash::Sha1);
  hash.addData(QByteArray(kPictureVersion));
  const std::string name = environment.toStdString();
  if (const auto builtin = builtinName(name)) {
    const std::string_view rig = resource("rigs/" + std::string(*builtin) + ".json");
    hash.addData(QByteArray(rig.data(), static_cast<qsizetype>(rig.size())));
  } else {
    hash.addData(QByteArray::fromStdString(AssetCache::fileKey(toPath(environment))));
  }
  return m_folder + QLatin1Char('/') + QString::fromLatin1(hash.result().toHex()) + QStringLiteral(".png");
}

QImage PanoramaMaker::find(const QString& environment) {
  const QString cached = cacheFile(environment);
  if (QFileInfo::exists(cached)) return QImage(cached);
  if (m_asked.contains(cached)) return {};
  m_asked.insert(cached, true);
  ++m_waiting;
  m_pool.start([this, environment, cached, size = m_size, round = m_round.load()] {
    bool well = false;
    if (round == m_round) {
      const auto images = imagesOf(environment.toStdString(), 2 * size.width());
      QSaveFile out(cached);
      well = images && out.open(QIODevice::WriteOnly) && panoramaThumbnail(*images, size).save(&out, "PNG") &&
             out.commit();
    }
    QMetaObject::invokeMethod(
        this,
        [this, environment, well] {
          --m_waiting;
          if (well) Q_EMIT made(environment);
          Q_EMIT progressed(m_waiting);
        },
        Qt::QueuedConnection);
  });
  return {};
}

void PanoramaMaker::cancel() { ++m_round; }

}  // namespace dermis
