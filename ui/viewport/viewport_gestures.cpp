// Hands on the picture: what a press, a drag, a wheel and a key do.
#include <QApplication>
#include <QMouseEvent>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "core/scene/cameras.h"
#include "ui/document/document.h"
#include "ui/viewport/compared_picture.h"
#include "ui/viewport/fly_keys.h"
#include "ui/viewport/navigation.h"
#include "ui/viewport/viewport.h"
#include "ui/viewport/viewport_tool.h"

namespace dermis {

void Viewport::moveCamera(const Camera& camera) {
  m_document.setCamera(camera);  // tells of a change, and so draws
}

void Viewport::goTo(const Camera& camera) {
  if (!m_document.isReady()) return;
  moveCamera(camera);
  Q_EMIT cameraGestureEnded();
}

void Viewport::frameAll() {
  if (!m_document.isReady()) return;
  goTo(navigation::frame(m_document.camera(), m_document.model()->bounds,
                         static_cast<float>(width()) / static_cast<float>(std::max(height(), 1))));
}

void Viewport::showNamedView(const QString& name) {
  if (!m_document.isReady()) return;
  if (const auto camera = namedCamera(name.toStdString(), m_document.model()->bounds)) goTo(*camera);
}

void Viewport::mousePressEvent(QMouseEvent* event) {
  if (!m_document.isReady() || m_drag != Drag::None || m_activeTool != nullptr) return;
  m_last = m_pressed = event->position();
  m_dragged = false;
  for (ViewportTool* tool : m_tools) {
    if (!tool->press(*event)) continue;
    m_activeTool = tool;
    return;
  }
  const bool shift = event->modifiers().testFlag(Qt::ShiftModifier);
  switch (event->button()) {
    case Qt::LeftButton:
      m_drag = shift ? Drag::Pan : Drag::Orbit;
      break;
    case Qt::MiddleButton:
      m_drag = Drag::Pan;
      break;
    case Qt::RightButton:
      m_drag = shift ? Drag::TurnEnvironment : Drag::Zoom;
      break;
    default:
      return;
  }
  m_gesture = newGesture();
  m_cameraBefore = m_document.camera();
  m_environmentBefore = m_document.scene().environment;
  setCursor(m_drag == Drag::Pan ? Qt::SizeAllCursor : m_drag == Drag::Zoom ? Qt::SizeVerCursor : Qt::ClosedHandCursor);
}

void Viewport::mouseMoveEvent(QMouseEvent* event) {
  if (m_activeTool != nullptr) {
    m_activeTool->drag(*event);
    return;
  }
  if (m_drag == Drag::None) {
    if (event->buttons() != Qt::NoButton) return;
    for (ViewportTool* tool : m_tools) tool->hover(event->position());
    Q_EMIT pointed(event->position());
    return;
  }
  // A hand that clicks trembles.
  if (!m_dragged && (event->position() - m_pressed).manhattanLength() < 3.0) return;
  m_dragged = true;
  const QPointF step = event->position() - m_last;
  m_last = event->position();
  const auto x = static_cast<float>(step.x());
  const auto y = static_cast<float>(step.y());
  constexpr float kRadiansPerPixel = 0.008F;
  const Camera& camera = m_document.camera();
  switch (m_drag) {
    case Drag::Orbit:
      moveCamera(navigation::orbit(camera, x * kRadiansPerPixel, y * kRadiansPerPixel));
      break;
    case Drag::Pan:
      moveCamera(navigation::pan(camera, x, -y, static_cast<float>(height())));
      break;
    case Drag::Zoom:
      moveCamera(navigation::zoom(camera, 0.04F * (x - y)));
      break;
    case Drag::Look:
      moveCamera(navigation::look(camera, x * 0.5F * kRadiansPerPixel, -y * 0.5F * kRadiansPerPixel));
      break;
    case Drag::TurnEnvironment: {
      EnvironmentSource next = m_document.scene().environment;
      next.rotationDegrees = std::remainder(next.rotationDegrees + 0.4F * x, 360.0F);
      m_document.setEnvironmentSettings(next, tr("Rotate environment"), m_gesture);
      break;
    }
    case Drag::None:
      break;
  }
}

void Viewport::mouseReleaseEvent(QMouseEvent* event) {
  if (event->buttons() != Qt::NoButton) return;
  if (ViewportTool* tool = std::exchange(m_activeTool, nullptr)) tool->release();
  const bool wasClick = m_drag == Drag::Orbit || m_drag == Drag::Pan;
  const bool wasDrag = std::exchange(m_drag, Drag::None) != Drag::None && m_dragged;
  m_flyKeys->clear();
  m_fly.stop();
  unsetCursor();
  if (m_moving) still();
  if (wasDrag && !(m_document.camera() == m_cameraBefore)) Q_EMIT cameraGestureEnded();
  if (wasClick && !wasDrag && event->button() == Qt::LeftButton) Q_EMIT clicked(event->position(), event->modifiers());
}

void Viewport::cancelDrag() {
  if (ViewportTool* tool = std::exchange(m_activeTool, nullptr)) tool->cancel();
  if (m_drag == Drag::TurnEnvironment)
    m_document.setEnvironmentSettings(m_environmentBefore, tr("Rotate environment"), m_gesture);
  else if (m_drag != Drag::None)
    moveCamera(m_cameraBefore);
  m_drag = Drag::None;
  m_flyKeys->clear();
  m_fly.stop();
  unsetCursor();
}

void Viewport::mouseDoubleClickEvent(QMouseEvent* event) {
  if (!m_renderer || event->button() != Qt::LeftButton) return;
  if (const auto point = pickPosition(event->position())) goTo(navigation::lookAt(m_document.camera(), *point));
}

void Viewport::wheelEvent(QWheelEvent* event) {
  if (!m_document.isReady()) return;
  event->accept();
  for (ViewportTool* tool : m_tools)
    if (tool->wheel(*event)) return;
  const float fine = event->modifiers().testFlag(Qt::ShiftModifier) ? 0.2F : 1.0F;
  goTo(navigation::zoom(m_document.camera(),
                        fine * static_cast<float>(event->angleDelta().y() + event->angleDelta().x()) / 120.0F));
}

bool Viewport::event(QEvent* event) {
  // While the right button is held, letters fly; while anything is dragged, Esc ends it. No menu's shortcut may take
  // them.
  if (event->type() == QEvent::ShortcutOverride) {
    const bool flies = m_drag == Drag::Zoom || m_drag == Drag::Look;
    const bool drags = m_drag != Drag::None || m_activeTool != nullptr;
    if (flies || (drags && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape)) {
      event->accept();
      return true;
    }
  }
  // A screen with other pixels resizes the picture though the widget keeps its size.
  if (event->type() == QEvent::ScreenChangeInternal) tellPixels();
  return GlWidget::event(event);
}

void Viewport::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape && (m_drag != Drag::None || m_activeTool != nullptr)) {
    cancelDrag();
    return;
  }
  if ((m_drag == Drag::Zoom || m_drag == Drag::Look) && m_flyKeys->press(*event)) {
    if (event->isAutoRepeat()) return;
    m_drag = Drag::Look;
    if (!m_fly.isActive()) {
      m_sinceFlyStep.start();
      m_fly.start();
    }
    return;
  }
  GlWidget::keyPressEvent(event);
}

void Viewport::keyReleaseEvent(QKeyEvent* event) {
  if (!event->isAutoRepeat() && m_flyKeys->release(*event)) {
    if (!m_flyKeys->any()) m_fly.stop();
    return;
  }
  GlWidget::keyReleaseEvent(event);
}

void Viewport::focusOutEvent(QFocusEvent* event) {
  m_flyKeys->clear();
  m_fly.stop();
  GlWidget::focusOutEvent(event);
}

void Viewport::leaveEvent(QEvent* event) {
  for (ViewportTool* tool : m_tools) tool->leave();
  Q_EMIT pointerLeft();
  GlWidget::leaveEvent(event);
}

void Viewport::flyStep() {
  const float seconds = std::min(static_cast<float>(m_sinceFlyStep.restart()) * 1e-3F, 0.1F);
  const float speed = m_document.isReady() ? 0.8F * m_document.model()->bounds.radius() : 1.0F;
  m_dragged = true;
  moveCamera(navigation::fly(m_document.camera(), m_flyKeys->direction() * (speed * seconds)));
}

}  // namespace dermis
