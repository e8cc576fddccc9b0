#include "ui/snapshots/snapshot_pictures.h"

#include <QImage>
#include <QOffscreenSurface>
#include <QWidget>
#include <utility>

#include "core/io/disk_cache.h"
#include "ui/jobs/picture_job.h"
#include "ui/jobs/task_runner.h"
#include "ui/snapshots/snapshots.h"
#include "ui/text.h"

namespace dermis {
namespace {
const QString kLane = QStringLiteral("snapshot");
constexpr int kSamples = 8;
}  // namespace

SnapshotPictures::SnapshotPictures(Snapshots& snapshots, TaskRunner& tasks, const QWidget& view, QObject* parent)
    : QObject(parent), m_snapshots(snapshots), m_tasks(tasks), m_view(view) {
  connect(&m_snapshots, &Snapshots::changed, this, &SnapshotPictures::drawNext);
}

void SnapshotPictures::drawNext() {
  const int next = m_snapshots.undrawn();
  if (next < 0 || m_tasks.busy(kLane)) return;
  const std::shared_ptr<const ResolvedScene> scene = m_snapshots.all()[static_cast<std::size_t>(next)].scene;
  const QSize size = m_view.size().scaled(Snapshots::kPicture, Qt::KeepAspectRatioByExpanding);
  PictureRequest request;
  request.size = {size.width(), size.height()};
  request.samples = kSamples;
  auto surface = std::make_shared<QOffscreenSurface>();
  surface->setFormat(QSurfaceFormat::defaultFormat());
  surface->create();
  const std::filesystem::path cache = userCacheFolder("bakes");
  m_tasks.run(
      kLane, tr("Drawing a snapshot"),
      [surface, scene, request, cache](const std::stop_token& stop) {
        return drawPicture(
            *surface, scene, request, cache, {}, [](double) {}, stop);
      },
      // The surface is held here too: it has to go on the thread it came from.
      [this, surface, scene](const Result<DrawnPicture>& result) {
        if (!result) {
          if (result.error().kind == Error::Kind::Cancelled) return;
          Q_EMIT problem(text(result.error().message));
          QImage none(Snapshots::kPicture, QImage::Format_RGB32);
          none.fill(QColor(36, 36, 36));
          m_snapshots.setPicture(scene.get(), none);
          return;
        }
        const Image& image = result->image;
        m_snapshots.setPicture(scene.get(),
                               QImage(reinterpret_cast<const uchar*>(image.pixels.data()), image.width, image.height,
                                      static_cast<qsizetype>(image.rowBytes()), QImage::Format_RGBA8888)
                                   .copy());
      });
}

}  // namespace dermis
