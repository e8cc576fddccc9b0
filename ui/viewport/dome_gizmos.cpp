#include "ui/viewport/dome_gizmos.h"

#include <cmath>

#include "ui/viewport/viewport.h"

namespace dermis {
namespace {

constexpr double kSizeHandleRadius = 7.0;
constexpr int kSleepAfterMs = 2500;

double distance(QPointF a, QPointF b) { return std::hypot(a.x() - b.x(), a.y() - b.y()); }

}  // namespace

DomeGizmos::DomeGizmos(Viewport& viewport, double handleRadius)
    : QObject(&viewport), m_viewport(viewport), m_handleRadius(handleRadius) {
  m_sleep.setSingleShot(true);
  m_sleep.setInterval(kSleepAfterMs);
  connect(&m_sleep, &QTimer::timeout, this, &DomeGizmos::sleep);
}

void DomeGizmos::setEnabled(bool enabled) {
  m_enabled = enabled;
  m_viewport.updateOverlay();
}

bool DomeGizmos::hasHandle(std::size_t) const { return true; }

std::optional<std::size_t> DomeGizmos::handleAt(QPointF point) const {
  std::optional<std::size_t> nearest;
  double least = m_handleRadius;
  for (std::size_t i = 0; i < count(); ++i) {
    if (!hasHandle(i)) continue;
    const double d = distance(point, handle(i));
    if (d > least) continue;
    least = d;
    nearest = i;
  }
  return nearest;
}

std::optional<int> DomeGizmos::sizeHandleAt(QPointF point) const {
  const QList<QPointF> handles = sizeHandles();
  for (int i = 0; i < handles.size(); ++i)
    if (distance(point, handles[i]) <= kSizeHandleRadius) return i;
  return std::nullopt;
}

void DomeGizmos::wake() {
  if (!m_awake) {
    m_awake = true;
    m_viewport.updateOverlay();
  }
  m_sleep.start();
}

void DomeGizmos::sleep() {
  if (isHeld() || !m_awake) return;
  m_awake = false;
  m_viewport.updateOverlay();
}

void DomeGizmos::hover(const QPointF& at) {
  wake();
  const auto under = isShown() ? handleAt(at) : std::nullopt;
  const int hovered = under ? static_cast<int>(*under) : -1;
  if (hovered == m_hovered) return;
  m_hovered = hovered;
  m_viewport.updateOverlay();
}

void DomeGizmos::leave() {
  m_hovered = -1;
  sleep();
}

}  // namespace dermis
