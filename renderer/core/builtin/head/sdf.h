// Signed distances and blends that the sculpt is made of. Lengths are millimetres; inside is negative.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

namespace dermis::sculpt {

[[nodiscard]] inline float cubed(float x) { return x * x * x; }
[[nodiscard]] inline float squared(float x) { return x * x; }
[[nodiscard]] inline float bell(float x, float width) { return std::exp(-squared(x / width)); }
[[nodiscard]] inline float ramp(float from, float to, float x) { return glm::smoothstep(from, to, x); }
/// Falls from 1 to 0 between `full` and `none`, full < none.
[[nodiscard]] inline float fade(float full, float none, float x) { return 1.0F - glm::smoothstep(full, none, x); }

/// Cubic polynomial smooth minimum that departs from min() where |a − b| < k (Quilez 2013, "Smooth minimum").
[[nodiscard]] inline float smoothMin(float a, float b, float k) {
  return std::min(a, b) - cubed(std::max(k - std::abs(a - b), 0.0F) / k) * k / 6.0F;
}
[[nodiscard]] inline float smoothMax(float a, float b, float k) { return -smoothMin(-a, -b, k); }

/// |x| without the crease at 0, `round` mm above it there.
[[nodiscard]] inline float roundAbs(float x, float round) { return std::sqrt(x * x + round * round); }
[[nodiscard]] inline glm::vec3 mirrored(const glm::vec3& p, float round) { return {roundAbs(p.x, round), p.y, p.z}; }

/// First-order distance to an ellipsoid along the axes.
[[nodiscard]] float ellipsoid(const glm::vec3& p, const glm::vec3& centre, const glm::vec3& radii);
/// A capsule whose radius goes from `ra` at `a` to `rb` at `b`.
[[nodiscard]] float capsule(const glm::vec3& p, const glm::vec3& a, const glm::vec3& b, float ra, float rb);

/// Turned about Y, then about X, by radians: what brings a point into a tilted part's own frame.
[[nodiscard]] glm::vec3 turned(const glm::vec3& p, float aboutY, float aboutX);

}  // namespace dermis::sculpt
