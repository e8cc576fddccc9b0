// What the handles of a rig's elements look like, and the handles of their sizes.
#pragma once

#include <QList>
#include <QPointF>
#include <QString>

#include "core/light_rig/light_rig.h"

class QPainter;

namespace dermis::marks {

/// Its own name, or that of its type.
[[nodiscard]] QString nameOf(const RigElement& element);

/// On a square, as lamps stand on discs; with its name where it is selected or under the pointer.
void paintHandle(QPainter& painter, const RigElement& element, QPointF at, bool selected, bool hovered);

/// Points about the handle at `at` to drag the size by: one for what is round, two for other shapes.
[[nodiscard]] QList<QPointF> sizeHandles(const RigElement& element, QPointF at);
/// The element as size handle `which` is dragged.
[[nodiscard]] RigElement dragged(const RigElement& start, int which, QPointF at, QPointF from, QPointF to);

}  // namespace dermis::marks
