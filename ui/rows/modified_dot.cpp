#include "ui/rows/modified_dot.h"

#include <QPainter>

#include "ui/theme/metrics.h"

namespace dermis {

ModifiedDot::ModifiedDot(QWidget* parent) : QWidget(parent) {
  setFixedSize(metrics::kDotWidth, metrics::kControlHeight);
}

void ModifiedDot::showState(State state) {
  if (state == m_state) return;
  m_state = state;
  switch (state) {
    case State::AsDefault:
      setToolTip({});
      break;
    case State::Differs:
      setToolTip(tr("Differs from the default; a double-click brings that back"));
      break;
    case State::Changed:
      setToolTip(tr("Changed since the preset was applied; a double-click brings the default back"));
      break;
    case State::Several:
      setToolTip(tr("The chosen slots have different values"));
      break;
  }
  update();
}

void ModifiedDot::paintEvent(QPaintEvent*) {
  if (m_state == State::AsDefault) return;
  QPainter p(this);
  p.setRenderHint(QPainter::Antialiasing);
  const QPointF at(width() / 2.0 - 1.0, height() / 2.0);
  const QColor bright = palette().color(isEnabled() ? QPalette::BrightText : QPalette::PlaceholderText);
  if (m_state == State::Several) {
    p.setPen(QPen(bright, 1.4));
    for (const double y : {-2.0, 2.0}) p.drawLine(at + QPointF(-3.0, y), at + QPointF(3.0, y));
    p.drawLine(at + QPointF(-2.0, 4.0), at + QPointF(2.0, -4.0));
    return;
  }
  p.setPen(Qt::NoPen);
  p.setBrush(m_state == State::Changed ? bright : palette().color(QPalette::PlaceholderText));
  const double radius = m_state == State::Changed ? 2.6 : 1.8;
  p.drawEllipse(at, radius, radius);
}

}  // namespace dermis
