#include "ui/viewport/light_gizmos.h"

#include <QMouseEvent>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>

#include "ui/document/document.h"
#include "ui/viewport/light_shapes.h"
#include "ui/viewport/viewport.h"

namespace dermis {
namespace {

constexpr double kHandleRadius = 13.0;
constexpr float kRadiansPerPixel = 0.008F;

}  // namespace

LightGizmos::LightGizmos(Document& document, Viewport& viewport)
    : DomeGizmos(viewport, kHandleRadius), m_document(document) {
  connect(&m_document, &Document::changed, this, [this] {
    if (m_selected >= static_cast<int>(lights().size())) select(-1);
    this->viewport().updateOverlay();
  });
}

const std::vector<Light>& LightGizmos::lights() const { return m_document.scene().lights; }
glm::vec3 LightGizmos::centre() const {
  return m_document.model() ? m_document.model()->bounds.centre() : glm::vec3(0.0F);
}
Projection LightGizmos::projection() const { return viewport().projection(); }

void LightGizmos::select(int light) {
  if (light == m_selected) return;
  m_selected = light;
  Q_EMIT selectionChanged(light);
  viewport().updateOverlay();
}

bool LightGizmos::isShown() const { return isAwake() && !lights().empty(); }

std::size_t LightGizmos::count() const { return lights().size(); }

void LightGizmos::holdKeyLight(bool held) {
  m_keyHeld = held;
  if (held) wake();
}

QPointF LightGizmos::handle(std::size_t light) const {
  return dome::place(projection(), dome::towards(lights().at(light), centre()));
}

QList<QPointF> LightGizmos::sizeHandles() const {
  if (m_selected < 0 || m_selected >= static_cast<int>(lights().size())) return {};
  const auto index = static_cast<std::size_t>(m_selected);
  return shapes::sizeHandles(lights()[index], handle(index));
}

bool LightGizmos::press(const QMouseEvent& event) {
  if (event.button() != Qt::LeftButton || !m_document.isReady()) return false;
  m_pressed = event.position();
  if (m_keyHeld) {
    const auto key = dome::keyLight(lights(), centre());
    if (!key) {
      Q_EMIT message(
          tr("There is no lamp to move: add one in the Lights panel, or turn the environment with Shift and "
             "the right button."));
      return true;
    }
    select(static_cast<int>(*key));
    m_grip = Grip::KeyLight;
  } else if (isShown()) {
    if (const auto size = sizeHandleAt(m_pressed)) {
      m_grip = Grip::Size;
      m_sizeHandle = *size;
    } else if (const auto light = handleAt(m_pressed)) {
      select(static_cast<int>(*light));
      m_grip = event.modifiers().testFlag(Qt::ShiftModifier) ? Grip::Plane : Grip::Dome;
      m_offset = handle(*light) - m_pressed;
    } else {
      return false;
    }
  } else {
    return false;
  }
  m_start = lights()[static_cast<std::size_t>(m_selected)];
  m_gesture = newGesture();
  m_what = m_grip == Grip::Size ? tr("Size") : tr("Place");
  stayAwake();
  viewport().updateOverlay();
  return true;
}

void LightGizmos::drag(const QMouseEvent& event) {
  if (m_grip == Grip::None || m_selected < 0) return;
  const Projection view = projection();
  const QPointF step = event.position() - m_pressed;
  const auto dx = static_cast<float>(step.x());
  const auto dy = static_cast<float>(step.y());
  switch (m_grip) {
    case Grip::Dome:
      change(dome::turned(m_start, centre(), dome::direction(view, event.position() + m_offset)), m_what);
      break;
    case Grip::KeyLight: {
      const glm::quat turn =
          glm::angleAxis(dx * kRadiansPerPixel, view.up()) * glm::angleAxis(dy * kRadiansPerPixel, view.right());
      change(dome::turned(m_start, centre(), glm::normalize(turn * dome::towards(m_start, centre()))), m_what);
      break;
    }
    case Grip::Plane: {
      if (m_start.type == LightType::Directional) break;
      // As far as the pointer at the distance of what is lit: a lamp may stand behind the camera.
      const float scale = view.unitsPerPixel(centre());
      Light next = m_start;
      next.position += scale * (dx * view.right() - dy * view.up());
      change(next, m_what);
      break;
    }
    case Grip::Size:
      change(shapes::dragged(m_start, m_sizeHandle, handle(static_cast<std::size_t>(m_selected)), m_pressed,
                             event.position()),
             m_what);
      break;
    case Grip::None:
      break;
  }
}

void LightGizmos::change(const Light& light, const QString& what) {
  m_document.setLight(static_cast<std::size_t>(m_selected), light, what, m_gesture);
}

void LightGizmos::release() {
  m_grip = Grip::None;
  wake();
  viewport().updateOverlay();
}

void LightGizmos::cancel() {
  if (m_grip != Grip::None && m_selected >= 0) change(m_start, m_what);
  release();
}

bool LightGizmos::wheel(const QWheelEvent& event) {
  if (!isShown()) return false;
  const auto under = handleAt(event.position());
  if (!under) return false;
  const Light& light = lights()[*under];
  const float ticks = static_cast<float>(event.angleDelta().y() + event.angleDelta().x()) / 120.0F;
  const bool size = event.modifiers().testFlag(Qt::ControlModifier);
  const float factor = std::pow(size ? 1.1F : 1.0F / 1.06F, ticks);
  select(static_cast<int>(*under));
  m_document.setLight(*under, size ? dome::resized(light, factor) : dome::moved(light, centre(), factor),
                      size ? tr("Size") : tr("Distance"), m_wheel.current());
  wake();
  return true;
}

void LightGizmos::paint(QPainter& painter, const Projection& view) {
  if (!isShown()) return;
  if (m_grip == Grip::Dome || m_grip == Grip::KeyLight || hovered() >= 0) shapes::paintRings(painter, view);
  const float millimetres = m_document.millimetresPerUnit();
  if (m_selected >= 0 && m_selected < static_cast<int>(lights().size()))
    shapes::paintInPlace(painter, view, lights()[static_cast<std::size_t>(m_selected)], centre(), millimetres);
  for (std::size_t i = 0; i < lights().size(); ++i)
    shapes::paintHandle(painter, view, lights()[i], handle(i), centre(), static_cast<int>(i) == m_selected,
                        static_cast<int>(i) == hovered());
}

}  // namespace dermis
