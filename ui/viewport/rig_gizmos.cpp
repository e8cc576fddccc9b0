#include "ui/viewport/rig_gizmos.h"

#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "core/light_rig/rig_gestures.h"
#include "ui/document/document.h"
#include "ui/document/rig_edit.h"
#include "ui/viewport/light_dome.h"
#include "ui/viewport/light_shapes.h"
#include "ui/viewport/rig_marks.h"
#include "ui/viewport/viewport.h"

namespace dermis {
namespace {

constexpr double kHandleRadius = 12.0;
constexpr double kSizeHandleRadius = 7.0;
constexpr int kSleepAfterMs = 2500;

double distance(QPointF a, QPointF b) { return std::hypot(a.x() - b.x(), a.y() - b.y()); }

}  // namespace

RigGizmos::RigGizmos(Document& document, RigEdit& edit, Viewport& viewport)
    : QObject(&viewport), m_document(document), m_edit(edit), m_viewport(viewport) {
  m_sleep.setSingleShot(true);
  m_sleep.setInterval(kSleepAfterMs);
  connect(&m_sleep, &QTimer::timeout, this, [this] {
    if (m_grip != Grip::None) return;
    m_awake = false;
    m_viewport.updateOverlay();
  });
  const auto repaint = [this] { m_viewport.updateOverlay(); };
  connect(&m_edit, &RigEdit::changed, this, repaint);
  connect(&m_edit, &RigEdit::selectionChanged, this, repaint);
}

void RigGizmos::setEnabled(bool enabled) {
  m_enabled = enabled;
  m_viewport.updateOverlay();
}

bool RigGizmos::isShown() const { return m_enabled && m_awake && m_document.isReady() && m_edit.rig() != nullptr; }

const RigElement* RigGizmos::selected() const {
  const LightRig* rig = m_edit.rig();
  const int index = m_edit.selected();
  if (rig == nullptr || index < 0 || index >= static_cast<int>(rig->elements.size())) return nullptr;
  return &rig->elements[static_cast<std::size_t>(index)];
}

QPointF RigGizmos::handle(std::size_t element) const {
  return dome::place(m_viewport.projection(),
                     worldDirection(m_edit.rig()->elements.at(element), m_edit.rotationDegrees()));
}

QList<QPointF> RigGizmos::sizeHandles() const {
  const RigElement* element = selected();
  if (element == nullptr || !hasPlace(element->type)) return {};
  return marks::sizeHandles(*element, handle(static_cast<std::size_t>(m_edit.selected())));
}

std::optional<std::size_t> RigGizmos::elementAt(QPointF point) const {
  const LightRig* rig = m_edit.rig();
  std::optional<std::size_t> nearest;
  double least = kHandleRadius;
  for (std::size_t i = 0; rig != nullptr && i < rig->elements.size(); ++i) {
    if (!hasPlace(rig->elements[i].type)) continue;
    const double d = distance(point, handle(i));
    if (d > least) continue;
    least = d;
    nearest = i;
  }
  return nearest;
}

std::optional<int> RigGizmos::sizeHandleAt(QPointF point) const {
  const QList<QPointF> handles = sizeHandles();
  for (int i = 0; i < handles.size(); ++i)
    if (distance(point, handles[i]) <= kSizeHandleRadius) return i;
  return std::nullopt;
}

void RigGizmos::wake() {
  if (!m_awake) {
    m_awake = true;
    m_viewport.updateOverlay();
  }
  m_sleep.start();
}

void RigGizmos::hover(const QPointF& at) {
  wake();
  const auto under = isShown() ? elementAt(at) : std::nullopt;
  const int hovered = under ? static_cast<int>(*under) : -1;
  if (hovered == m_hovered) return;
  m_hovered = hovered;
  m_viewport.updateOverlay();
}

void RigGizmos::leave() {
  m_hovered = -1;
  if (m_grip != Grip::None || !m_awake) return;
  m_awake = false;
  m_viewport.updateOverlay();
}

bool RigGizmos::press(const QMouseEvent& event) {
  if (event.button() != Qt::LeftButton || !isShown()) return false;
  m_pressed = event.position();
  if (const auto size = sizeHandleAt(m_pressed)) {
    m_grip = Grip::Size;
    m_sizeHandle = *size;
    m_what = tr("Size in the light rig");
  } else if (const auto element = elementAt(m_pressed)) {
    m_edit.select(static_cast<int>(*element));
    m_grip = Grip::Dome;
    m_offset = handle(*element) - m_pressed;
    m_what = tr("Place in the light rig");
  } else {
    return false;
  }
  m_start = *selected();
  m_gesture = newGesture();
  m_sleep.stop();
  m_edit.setDragging(true);
  m_viewport.updateOverlay();
  return true;
}

void RigGizmos::drag(const QMouseEvent& event) {
  if (m_grip == Grip::None || selected() == nullptr) return;
  if (m_grip == Grip::Dome) {
    const glm::vec3 to = dome::direction(m_viewport.projection(), event.position() + m_offset);
    change(turnedTo(m_start, to, m_edit.rotationDegrees()));
  } else {
    const QPointF at = handle(static_cast<std::size_t>(m_edit.selected()));
    change(marks::dragged(m_start, m_sizeHandle, at, m_pressed, event.position()));
  }
}

void RigGizmos::change(const RigElement& element) {
  m_edit.setElement(static_cast<std::size_t>(m_edit.selected()), element, m_what, m_gesture);
}

void RigGizmos::release() {
  m_grip = Grip::None;
  m_edit.setDragging(false);
  wake();
  m_viewport.updateOverlay();
}

void RigGizmos::cancel() {
  if (m_grip != Grip::None && selected() != nullptr) change(m_start);
  release();
}

bool RigGizmos::wheel(const QWheelEvent& event) {
  if (!isShown()) return false;
  const auto under = elementAt(event.position());
  if (!under) return false;
  const RigElement element = m_edit.rig()->elements[*under];
  const float ticks = static_cast<float>(event.angleDelta().y() + event.angleDelta().x()) / 120.0F;
  const bool size = event.modifiers().testFlag(Qt::ControlModifier);
  m_edit.select(static_cast<int>(*under));
  // A lamp that comes nearer is brighter: up is brighter here as well.
  m_edit.setElement(*under,
                    size ? withSize(element, std::pow(1.1F, ticks) * sizeOf(element)->size)
                         : withAmount(element, std::pow(1.12F, ticks) * amountOf(element)),
                    size ? tr("Size in the light rig") : tr("Brightness in the light rig"), m_wheel.current());
  wake();
  return true;
}

void RigGizmos::paint(QPainter& painter, const Projection& view) {
  if (!isShown()) return;
  if (m_grip == Grip::Dome || m_hovered >= 0) shapes::paintRings(painter, view);
  const auto& elements = m_edit.rig()->elements;
  for (std::size_t i = 0; i < elements.size(); ++i)
    if (hasPlace(elements[i].type))
      marks::paintHandle(painter, elements[i], handle(i), static_cast<int>(i) == m_edit.selected(),
                         static_cast<int>(i) == m_hovered);
}

}  // namespace dermis
