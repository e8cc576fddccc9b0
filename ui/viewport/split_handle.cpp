#include "ui/viewport/split_handle.h"

#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "ui/viewport/projection.h"
#include "ui/viewport/viewport.h"

namespace dermis {

void SplitHandle::setNames(const QString& left, const QString& right) {
  m_left = left;
  m_right = right;
  m_viewport.updateOverlay();
}

bool SplitHandle::isUnder(const QPointF& at) const {
  return m_viewport.compared() != nullptr && std::abs(at.x() - m_viewport.split() * m_viewport.width()) <= 7.0;
}

bool SplitHandle::press(const QMouseEvent& event) {
  if (event.button() != Qt::LeftButton || !isUnder(event.position())) return false;
  m_dragging = true;
  m_before = m_viewport.split();
  return true;
}

void SplitHandle::drag(const QMouseEvent& event) {
  if (m_dragging) m_viewport.setSplit(event.position().x() / std::max(m_viewport.width(), 1));
}

void SplitHandle::release() { m_dragging = false; }

void SplitHandle::cancel() {
  m_viewport.setSplit(m_before);
  m_dragging = false;
}

void SplitHandle::hover(const QPointF& at) {
  const bool hovered = isUnder(at);
  if (hovered == m_hovered) return;
  m_hovered = hovered;
  if (hovered)
    m_viewport.setCursor(Qt::SplitHCursor);
  else
    m_viewport.unsetCursor();
  m_viewport.updateOverlay();
}

void SplitHandle::leave() { hover(QPointF(-1e6, 0.0)); }

void SplitHandle::paint(QPainter& p, const Projection& view) {
  if (m_viewport.compared() == nullptr) return;
  const double x = std::round(m_viewport.split() * view.size().width());
  const double height = view.size().height();
  p.setRenderHint(QPainter::Antialiasing);
  p.fillRect(QRectF(x - 1.5, 0.0, 3.0, height), QColor(0, 0, 0, 130));
  p.fillRect(QRectF(x - 0.5, 0.0, 1.0, height), QColor(235, 235, 235));
  const QPointF grip(x, 0.5 * height);
  p.setPen(QPen(QColor(235, 235, 235), m_hovered || m_dragging ? 2.0 : 1.2));
  p.setBrush(QColor(25, 25, 25, 210));
  p.drawEllipse(grip, 11.0, 11.0);
  for (const double side : {-1.0, 1.0}) {
    const QPointF tip = grip + QPointF(side * 7.0, 0.0);
    p.drawLine(tip, tip + QPointF(-side * 4.0, -4.0));
    p.drawLine(tip, tip + QPointF(-side * 4.0, 4.0));
  }
  constexpr double kTop = 21.0;
  if (!m_left.isEmpty()) paintTag(p, {x - 8.0, kTop}, Qt::AlignLeft, m_left);
  if (!m_right.isEmpty()) paintTag(p, {x + 8.0, kTop}, Qt::AlignRight, m_right);
}

}  // namespace dermis
