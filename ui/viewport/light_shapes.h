// What the lights' gizmos look like, and the handles of their sizes.
#pragma once

#include <QList>
#include <QPointF>

#include "core/scene/scene.h"
#include "ui/viewport/projection.h"

class QPainter;

namespace dermis::shapes {

/// The rings of the dome: light from the side, light from behind.
void paintRings(QPainter& painter, const Projection& view);
/// A light's mark on the dome: what it is, its colour, the way its light goes; its size where it is selected.
void paintHandle(QPainter& painter, const Projection& view, const Light& light, QPointF at, const glm::vec3& centre,
                 bool selected, bool hovered);
/// The light where it really is, at its real size, as far as the camera sees that place.
void paintInPlace(QPainter& painter, const Projection& view, const Light& light, const glm::vec3& centre,
                  float millimetresPerUnit);

/// Points to drag a light's size by, about its handle: one for a radius or a cone, two for a rectangle's sides.
[[nodiscard]] QList<QPointF> sizeHandles(const Light& light, QPointF at);
/// The light as size handle `which` is dragged: sizes grow as the pointer goes away from the handle at `at`.
[[nodiscard]] Light dragged(const Light& start, int which, QPointF at, QPointF from, QPointF to);

}  // namespace dermis::shapes
