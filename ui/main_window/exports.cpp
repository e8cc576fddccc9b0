#include "ui/main_window/exports.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QImage>
#include <QOffscreenSurface>

#include "core/io/disk_cache.h"
#include "core/scene/cameras.h"
#include "ui/dialogs/open_dialog.h"
#include "ui/dialogs/screenshot_dialog.h"
#include "ui/document/document.h"
#include "ui/jobs/task_runner.h"
#include "ui/text.h"
#include "ui/translation.h"
#include "ui/viewport/viewport.h"

namespace dermis {
namespace {

const QString kLane = QStringLiteral("picture");

QString nameOf(const PictureRequest& request) {
  return request.path.empty() ? Exports::tr("A picture") : pathText(request.path.filename());
}

}  // namespace

Exports::Exports(Document& document, TaskRunner& tasks, QWidget& window)
    : QObject(&window), m_document(document), m_tasks(tasks), m_window(window) {
  connect(&m_tasks, &TaskRunner::activityChanged, this, &Exports::startNext);
}

void Exports::ask(const Viewport& viewport) {
  if (!m_document.isReady()) return;
  const double ratio = viewport.devicePixelRatioF();
  auto* dialog =
      new ScreenshotDialog({static_cast<int>(viewport.width() * ratio), static_cast<int>(viewport.height() * ratio)},
                           text(m_document.scene().view.transform), viewport.references(), &m_window);
  connect(dialog, &QDialog::accepted, this, [this, dialog] { draw(dialog->request()); });
  openDialog(dialog);
}

std::vector<NamedView> Exports::sheetViews() const {
  std::vector<NamedView> views;
  if (!m_document.isReady()) return views;
  for (const char* name : {"front", "three-quarter", "profile", "ear"})
    for (const NamedCameraRow& row : namedCameras())
      if (row.id == name)
        views.push_back({tableText(row.label).toStdString(), *namedCamera(name, m_document.model()->bounds)});
  for (const CameraBookmark& bookmark : m_document.scene().bookmarks) views.push_back({bookmark.name, bookmark.camera});
  return views;
}

void Exports::draw(const PictureRequest& given) {
  const std::shared_ptr<const ResolvedScene> scene = m_document.snapshot();
  if (!scene) return;
  PictureRequest request = given;
  request.sceneFolder = m_document.path().parent_path();
  if (request.kind == PictureKind::Sheet && request.views.empty()) request.views = sheetViews();
  if (m_tasks.busy(kLane))
    Q_EMIT message(MessageKind::Info, tr("%1 follows when the picture before it is done").arg(nameOf(request)));
  m_waiting.push_back({std::move(request), scene});
  startNext();
}

void Exports::startNext() {
  if (m_waiting.empty() || m_tasks.busy(kLane)) return;
  const auto [request, scene] = std::move(m_waiting.front());
  m_waiting.pop_front();
  auto surface = std::make_shared<QOffscreenSurface>();
  surface->setFormat(QSurfaceFormat::defaultFormat());
  surface->create();
  const std::filesystem::path cache = userCacheFolder("bakes");
  Q_EMIT progressed(0.0);
  m_tasks.run(
      kLane, tr("Drawing %1").arg(nameOf(request)),
      [this, surface, scene = scene, request = request, cache, metadata = m_metadata](const std::stop_token& stop) {
        const auto progress = [this](double fraction) {
          QMetaObject::invokeMethod(
              this, [this, fraction] { Q_EMIT progressed(fraction); }, Qt::QueuedConnection);
        };
        return drawPicture(*surface, scene, request, cache, metadata, progress, stop);
      },
      // The surface is held here too: it has to go on the thread it came from.
      [this, surface](const Result<DrawnPicture>& result) {
        Q_EMIT progressed(-1.0);
        if (!result) {
          if (result.error().kind != Error::Kind::Cancelled)
            Q_EMIT message(MessageKind::Error, text(result.error().message));
          return;
        }
        if (result->files.size() == 1) {
          Q_EMIT message(MessageKind::Info, tr("Saved %1").arg(pathText(result->files.front())));
        } else if (!result->files.empty()) {
          Q_EMIT message(MessageKind::Info,
                         tr("Saved %1 frames, %2 to %3")
                             .arg(result->files.size())
                             .arg(pathText(result->files.front()), pathText(result->files.back().filename())));
        } else {
          const Image& image = result->image;
          QGuiApplication::clipboard()->setImage(
              QImage(reinterpret_cast<const uchar*>(image.pixels.data()), image.width, image.height,
                     static_cast<qsizetype>(image.rowBytes()), QImage::Format_RGBA8888)
                  .copy());
          Q_EMIT message(MessageKind::Info, tr("Copied a picture of %1 × %2").arg(image.width).arg(image.height));
        }
      });
}

}  // namespace dermis
