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

}  // namespace

RigGizmos::RigGizmos(Document& document, RigEdit& edit, Viewport& viewport)
    : DomeGizmos(viewport, kHandleRadius), m_document(document), m_edit(edit) {
  const auto repaint = [this] { this->viewport().updateOverlay(); };
  connect(&m_edit, &RigEdit::changed, this, repaint);
  connect(&m_edit, &RigEdit::selectionChanged, this, repaint);
}

bool RigGizmos::isShown() const { return isAwake() && m_document.isReady() && m_edit.rig() != nullptr; }

std::size_t RigGizmos::count() const { return m_edit.rig() == nullptr ? 0 : m_edit.rig()->elements.size(); }
bool RigGizmos::hasHandle(std::size_t element) const { return hasPlace(m_edit.rig()->elements.at(element).type); }

const RigElement* RigGizmos::selected() const {
  const LightRig* rig = m_edit.rig();
  const int index = m_edit.selected();
  if (rig == nullptr || index < 0 || index >= static_cast<int>(rig->elements.size())) return nullptr;
  return &rig->elements[static_cast<std::size_t>(index)];
}

QPointF RigGizmos::handle(std::size_t element) const {
  return dome::place(viewport().projection(),
                     worldDirection(m_edit.rig()->elements.at(element), m_edit.rotationDegrees()));
}

QList<QPointF> RigGizmos::sizeHandles() const {
  const RigElement* element = selected();
  if (element == nullptr || !hasPlace(element->type)) return {};
  return marks::sizeHandles(*element, handle(static_cast<std::size_t>(m_edit.selected())));
}

bool RigGizmos::press(const QMouseEvent& event) {
  if (event.button() != Qt::LeftButton || !isShown()) return false;
  m_pressed = event.position();
  if (const auto size = sizeHandleAt(m_pressed)) {
    m_grip = Grip::Size;
    m_sizeHandle = *size;
    m_what = tr("Size in the light rig");
  } else if (const auto element = handleAt(m_pressed)) {
    m_edit.select(static_cast<int>(*element));
    m_grip = Grip::Dome;
    m_offset = handle(*element) - m_pressed;
    m_what = tr("Place in the light rig");
  } else {
    return false;
  }
  m_start = *selected();
  m_gesture = newGesture();
  stayAwake();
  m_edit.setDragging(true);
  viewport().updateOverlay();
  return true;
}

void RigGizmos::drag(const QMouseEvent& event) {
  if (m_grip == Grip::None || selected() == nullptr) return;
  if (m_grip == Grip::Dome) {
    const glm::vec3 to = dome::direction(viewport().projection(), event.position() + m_offset);
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
  viewport().updateOverlay();
}

void RigGizmos::cancel() {
  if (m_grip != Grip::None && selected() != nullptr) change(m_start);
  release();
}

bool RigGizmos::wheel(const QWheelEvent& event) {
  if (!isShown()) return false;
  const auto under = handleAt(event.position());
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
  if (m_grip == Grip::Dome || hovered() >= 0) shapes::paintRings(painter, view);
  for (std::size_t i = 0; i < count(); ++i)
    if (hasHandle(i))
      marks::paintHandle(painter, m_edit.rig()->elements[i], handle(i), static_cast<int>(i) == m_edit.selected(),
                         static_cast<int>(i) == hovered());
}

}  // namespace dermis
