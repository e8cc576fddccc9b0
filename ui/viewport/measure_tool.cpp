#include "ui/viewport/measure_tool.h"

#include <QMouseEvent>
#include <QPainter>

#include "ui/document/document.h"
#include "ui/viewport/projection.h"
#include "ui/viewport/viewport.h"

namespace dermis {

void MeasureTool::setEnabled(bool enabled) {
  m_enabled = enabled;
  cancel();
}

void MeasureTool::setUnit(LengthUnit unit) {
  m_unit = unit;
  m_viewport.updateOverlay();
}

std::optional<glm::vec3> MeasureTool::surfaceAt(QPointF at) const {
  const auto hit = m_viewport.surfaceAt(at);
  return hit ? std::optional(hit->position) : std::nullopt;
}

std::optional<double> MeasureTool::millimetres() const {
  if (!m_from || !m_to) return std::nullopt;
  return static_cast<double>(glm::length(*m_to - *m_from)) * static_cast<double>(m_document.millimetresPerUnit());
}

QString MeasureTool::words() const {
  const auto length = millimetres();
  return length ? lengthText(*length, m_unit, 1) : QString();
}

bool MeasureTool::press(const QMouseEvent& event) {
  if (!m_enabled || event.button() != Qt::LeftButton) return false;
  m_from = surfaceAt(event.position());
  m_to.reset();
  m_viewport.updateOverlay();
  return m_from.has_value();
}

void MeasureTool::drag(const QMouseEvent& event) {
  if (const auto at = surfaceAt(event.position())) m_to = at;
  m_viewport.updateOverlay();
}

void MeasureTool::cancel() {
  m_from.reset();
  m_to.reset();
  m_viewport.updateOverlay();
}

bool MeasureTool::markMiddle() {
  const auto at = surfaceAt(QRectF(m_viewport.rect()).center());
  if (!at) return false;
  if (m_from && !m_to) {
    m_to = at;
  } else {
    m_from = at;
    m_to.reset();
  }
  m_viewport.updateOverlay();
  return true;
}

void MeasureTool::paintLine(QPainter& p, const QPointF& from, const QPointF& to) {
  for (const auto& [colour, width] : {std::pair(QColor(0, 0, 0, 160), 4.0), std::pair(QColor(240, 240, 240), 1.5)}) {
    p.setPen(QPen(colour, width));
    p.drawLine(from, to);
    p.drawEllipse(from, 3.0, 3.0);
    p.drawEllipse(to, 3.0, 3.0);
  }
}

void MeasureTool::paint(QPainter& p, const Projection& view) {
  if (!m_enabled || !m_from) return;
  const auto a = view.toScreen(*m_from);
  if (!a) return;
  p.setRenderHint(QPainter::Antialiasing);
  // Until it has an end it goes to the middle, where a key would put one.
  const auto b = m_to ? view.toScreen(*m_to) : std::optional(QRectF(QPointF(), view.size()).center());
  if (!b) return;
  paintLine(p, *a, *b);
  if (m_to) paintTag(p, *b + QPointF(10.0, 0.0), Qt::AlignRight, words());
}

}  // namespace dermis
