// How a hand moves a camera: pure functions on a Camera.
#pragma once

#include "core/scene/model.h"
#include "core/scene/scene.h"

namespace dermis::navigation {

/// Turns about the target; `right` and `up` in radians. Stops short of the poles.
[[nodiscard]] Camera orbit(const Camera& camera, float right, float up);
/// Moves camera and target so that what is at the target follows the pointer; in pixels of a viewport `height` high.
[[nodiscard]] Camera pan(const Camera& camera, float rightPixels, float upPixels, float height);
/// Comes closer for steps > 0, by a constant factor a step; an orthographic picture gets larger.
[[nodiscard]] Camera zoom(const Camera& camera, float steps);
/// Looks at a point from the same direction and distance.
[[nodiscard]] Camera lookAt(const Camera& camera, const glm::vec3& point);
/// From the same direction, the whole of the bounds in view.
[[nodiscard]] Camera frame(const Camera& camera, const Bounds& bounds, float aspect);
/// Moves camera and target by distances along the camera's own right, up and forward.
[[nodiscard]] Camera fly(const Camera& camera, const glm::vec3& distances);
/// Turns the view about the camera's own place; radians.
[[nodiscard]] Camera look(const Camera& camera, float right, float up);
/// Scene units that one pixel covers at the target.
[[nodiscard]] float unitsPerPixel(const Camera& camera, float height);

}  // namespace dermis::navigation
