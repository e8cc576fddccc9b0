// What handles over the picture are painted with, those of lamps and of a rig's elements alike.
#pragma once

#include <QColor>
#include <QList>
#include <QPainter>
#include <QPen>
#include <QPointF>

namespace dermis::handles {

constexpr double kRing = 26.0;  // where size handles stand
constexpr QColor kDark(0, 0, 0, 150);
constexpr QColor kPale(235, 235, 235, 210);
constexpr QColor kAccent(255, 196, 87);

/// Twice: a dark line under a pale one is seen on any picture.
template <class Draw>
void outlined(QPainter& painter, const QColor& colour, double width, Draw draw) {
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(kDark, width + 2.0));
  draw();
  painter.setPen(QPen(colour, width));
  draw();
}

/// For what a mark stands on: darker where a hand is near.
void setGround(QPainter& painter, bool strong);
void setMark(QPainter& painter, const QColor& fill, bool selected, bool hovered);
void paintSizeHandles(QPainter& painter, const QList<QPointF>& places);

/// How much a size grows as size handle `which` (1: upright, else across) of the handle at `at` is dragged.
[[nodiscard]] float sizeFactor(int which, QPointF at, QPointF from, QPointF to);

}  // namespace dermis::handles
