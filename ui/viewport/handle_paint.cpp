#include "ui/viewport/handle_paint.h"

#include <algorithm>

namespace dermis::handles {

void setGround(QPainter& painter, bool strong) {
  painter.setPen(Qt::NoPen);
  painter.setBrush(QColor(20, 20, 20, strong ? 190 : 120));
}

void setMark(QPainter& painter, const QColor& fill, bool selected, bool hovered) {
  painter.setPen(QPen(selected ? kAccent : kPale, hovered ? 2.0 : 1.4));
  painter.setBrush(fill);
}

void paintSizeHandles(QPainter& painter, const QList<QPointF>& places) {
  painter.setPen(QPen(kDark, 1.0));
  painter.setBrush(kAccent);
  for (const QPointF& place : places) painter.drawRect(QRectF(place - QPointF(4, 4), QSizeF(8, 8)));
}

float sizeFactor(int which, QPointF at, QPointF from, QPointF to) {
  const double before = which == 1 ? at.y() - from.y() : from.x() - at.x();
  const double after = which == 1 ? at.y() - to.y() : to.x() - at.x();
  return static_cast<float>(std::clamp(after / std::max(before, 1.0), 0.02, 50.0));
}

}  // namespace dermis::handles
