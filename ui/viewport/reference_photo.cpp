#include "ui/viewport/reference_photo.h"

#include <QImageReader>
#include <QMouseEvent>
#include <QPainter>
#include <QSettings>
#include <algorithm>
#include <cmath>

#include "ui/jobs/task_runner.h"
#include "ui/viewport/projection.h"
#include "ui/viewport/viewport.h"

namespace dermis {

ReferencePhoto::ReferencePhoto(Viewport& viewport, TaskRunner& tasks)
    : QObject(&viewport), m_viewport(viewport), m_tasks(tasks) {
  const QSettings settings;
  Settings last;
  last.path = settings.value(QStringLiteral("reference/path")).toString();
  last.opacity = settings.value(QStringLiteral("reference/opacity"), 0.5).toDouble();
  last.wipe = settings.value(QStringLiteral("reference/wipe"), 1.0).toDouble();
  last.scale = settings.value(QStringLiteral("reference/scale"), 1.0).toDouble();
  last.offset = settings.value(QStringLiteral("reference/offset")).toPointF();
  // It is loaded when somebody asks for it, not at every start.
  m_settings = last;
}

void ReferencePhoto::set(const Settings& given) {
  Settings next = given;
  next.opacity = std::clamp(next.opacity, 0.0, 1.0);
  next.wipe = std::clamp(next.wipe, 0.0, 1.0);
  next.scale = std::clamp(next.scale, 0.01, 100.0);
  // Chosen anew, even the same file: one that could not be read may have been mended.
  const bool asked = next == m_settings || next.path != m_settings.path || m_settings.place == Place::Off;
  const bool loads = asked && next.place != Place::Off && next.path != m_loaded;
  if (next == m_settings && !loads) return;
  m_settings = next;
  QSettings settings;
  settings.setValue(QStringLiteral("reference/path"), next.path);
  settings.setValue(QStringLiteral("reference/opacity"), next.opacity);
  settings.setValue(QStringLiteral("reference/wipe"), next.wipe);
  settings.setValue(QStringLiteral("reference/scale"), next.scale);
  settings.setValue(QStringLiteral("reference/offset"), next.offset);
  if (loads) load();
  m_viewport.updateOverlay();
  Q_EMIT changed();
}

void ReferencePhoto::load() {
  m_loaded.clear();
  m_image = {};
  if (m_settings.path.isEmpty()) return;
  struct Loaded {
    QImage image;
    QString error;
  };
  m_tasks.run(
      QStringLiteral("reference"), tr("Loading the reference photograph"),
      [path = m_settings.path](std::stop_token) {
        QImageReader reader(path);
        reader.setAutoTransform(true);
        const QImage image = reader.read();
        return Loaded{image, image.isNull() ? reader.errorString() : QString()};
      },
      [this, path = m_settings.path](const Loaded& loaded) {
        m_image = loaded.image;
        if (!m_image.isNull())
          m_loaded = path;
        else
          Q_EMIT problem(
              tr("%1 can't be shown as a reference: %2. Choose a PNG, JPEG or WebP picture.").arg(path, loaded.error));
        m_viewport.updateOverlay();
        Q_EMIT changed();
      });
}

QRectF ReferencePhoto::rectangle(QSizeF viewport) const {
  if (m_image.isNull()) return {};
  const double height = viewport.height() * m_settings.scale;
  const double width = height * m_image.width() / std::max(m_image.height(), 1);
  const QPointF middle =
      QPointF(0.5 * viewport.width(), 0.5 * viewport.height()) + viewport.height() * m_settings.offset;
  return {middle.x() - 0.5 * width, middle.y() - 0.5 * height, width, height};
}

bool ReferencePhoto::press(const QMouseEvent& event) {
  const double line = m_settings.wipe * m_viewport.width();
  if (!isOver() || event.button() != Qt::LeftButton || std::abs(event.position().x() - line) > 6.0) return false;
  if (m_settings.wipe >= 1.0 && event.position().x() < m_viewport.width() - 6.0) return false;
  m_wipeBefore = m_settings.wipe;
  return true;
}

void ReferencePhoto::drag(const QMouseEvent& event) {
  Settings next = m_settings;
  next.wipe = event.position().x() / std::max(m_viewport.width(), 1);
  set(next);
}

void ReferencePhoto::cancel() {
  Settings next = m_settings;
  next.wipe = m_wipeBefore;
  set(next);
}

void ReferencePhoto::paint(QPainter& p, const Projection& view) {
  if (!isOver()) return;
  p.setRenderHint(QPainter::SmoothPixmapTransform);
  const double line = m_settings.wipe * view.size().width();
  p.setClipRect(QRectF(0.0, 0.0, line, view.size().height()));
  p.setOpacity(m_settings.opacity);
  p.drawImage(rectangle(view.size()), m_image);
  p.setOpacity(1.0);
  p.setClipping(false);
  if (m_settings.wipe >= 1.0) return;
  p.fillRect(QRectF(line - 1.5, 0.0, 3.0, view.size().height()), QColor(0, 0, 0, 120));
  p.fillRect(QRectF(line - 0.5, 0.0, 1.0, view.size().height()), QColor(235, 235, 235));
}

ReferenceView::ReferenceView(ReferencePhoto& photo, QWidget* parent) : QWidget(parent), m_photo(photo) {
  setObjectName(QStringLiteral("referenceView"));
  setAccessibleName(tr("Reference photograph"));
  setMinimumWidth(160);
  const auto refresh = [this] {
    setVisible(m_photo.settings().place == ReferencePhoto::Place::Beside && !m_photo.image().isNull());
    update();
  };
  connect(&photo, &ReferencePhoto::changed, this, refresh);
  hide();
}

void ReferenceView::paintEvent(QPaintEvent*) {
  QPainter p(this);
  p.fillRect(rect(), QColor(30, 30, 30));
  p.setRenderHint(QPainter::SmoothPixmapTransform);
  const QImage& image = m_photo.image();
  if (image.isNull()) return;
  // The whole of it at scale 1, moved and enlarged as it would be over the picture.
  const QSizeF whole = QSizeF(image.size()).scaled(QSizeF(size()), Qt::KeepAspectRatio) * m_photo.settings().scale;
  const QPointF middle = QRectF(rect()).center() + height() * m_photo.settings().offset;
  p.drawImage(QRectF(middle - QPointF(0.5 * whole.width(), 0.5 * whole.height()), whole), image);
}

}  // namespace dermis
