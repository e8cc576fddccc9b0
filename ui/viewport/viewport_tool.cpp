#include "ui/viewport/viewport_tool.h"

#include <QPainter>

namespace dermis {

bool ViewportTool::press(const QMouseEvent&) { return false; }
void ViewportTool::drag(const QMouseEvent&) {}
void ViewportTool::release() {}
void ViewportTool::cancel() {}
bool ViewportTool::wheel(const QWheelEvent&) { return false; }
void ViewportTool::hover(const QPointF&) {}
void ViewportTool::leave() {}

void paintTag(QPainter& painter, const QPointF& at, Qt::AlignmentFlag side, const QString& words) {
  const QFontMetrics metrics = painter.fontMetrics();
  const QSizeF size(metrics.horizontalAdvance(words) + 14.0, metrics.height() + 6.0);
  const double before = side == Qt::AlignLeft ? 1.0 : side == Qt::AlignHCenter ? 0.5 : 0.0;
  const QRectF box(QPointF(at.x() - before * size.width(), at.y() - 0.5 * size.height()), size);
  painter.setPen(Qt::NoPen);
  painter.setBrush(QColor(20, 20, 20, 170));
  painter.drawRoundedRect(box, 3.0, 3.0);
  painter.setPen(QColor(230, 230, 230));
  painter.drawText(box, Qt::AlignCenter, words);
}

}  // namespace dermis
