#include "ui/browse/panorama_maker.h"

#include <QCryptographicHash>
#include <QDir>
#include <QFileInfo>
#include <QSaveFile>
#include <QStandardPaths>

#include "core/io/asset_loader.h"
#include "ui/text.h"
#include "ui/thumbnails.h"

namespace dermis {
namespace {
constexpr const char* kPictureVersion = "panorama 2";
}

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

QString PanoramaMaker::cacheFile(const QString& file) const {
  QCryptographicHash hash(QCryptographicHash::Sha1);
  hash.addData(QByteArray(kPictureVersion));
  hash.addData(QByteArray::fromStdString(AssetCache::fileKey(toPath(file))));
  return m_folder + QLatin1Char('/') + QString::fromLatin1(hash.result().toHex()) + QStringLiteral(".png");
}

QImage PanoramaMaker::find(const QString& file) {
  const QString cached = cacheFile(file);
  if (QFileInfo::exists(cached)) return QImage(cached);
  if (m_asked.contains(cached)) return {};
  m_asked.insert(cached, true);
  ++m_waiting;
  m_pool.start([this, file, cached, size = m_size, round = m_round.load()] {
    bool well = false;
    if (round == m_round) {
      EnvironmentSource source;
      source.builtin.clear();
      source.path = file.toStdString();
      Warnings ignored;
      const auto images = resolveEnvironment(source, {}, {}, ignored);
      QSaveFile out(cached);
      well = images && out.open(QIODevice::WriteOnly) && panoramaThumbnail(**images, size).save(&out, "PNG") &&
             out.commit();
    }
    QMetaObject::invokeMethod(
        this,
        [this, file, well] {
          --m_waiting;
          if (well) Q_EMIT made(file);
          Q_EMIT progressed(m_waiting);
        },
        Qt::QueuedConnection);
  });
  return {};
}

void PanoramaMaker::cancel() { ++m_round; }

}  // namespace dermis
