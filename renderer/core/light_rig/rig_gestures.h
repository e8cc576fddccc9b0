// What a hand does to an element of a light rig: where it is, how large, how bright. Pure functions; every value stays
// in the range that files may hold.
#pragma once

#include <glm/glm.hpp>
#include <optional>

#include "core/light_rig/light_rig.h"

namespace dermis {

/// Whether the element is somewhere: lamps, glows, a sky by its sun. Domes and grounds are all round.
[[nodiscard]] bool hasPlace(RigElementType type);

/// Unit vector in the world, for an environment turned by `rotationDegrees`.
[[nodiscard]] glm::vec3 worldDirection(const RigElement& element, float rotationDegrees);
/// The element in that direction; azimuth and elevation to a hundredth of a degree.
[[nodiscard]] RigElement turnedTo(const RigElement& element, const glm::vec3& towards, float rotationDegrees);

/// Width and height, or diameter twice; in degrees or metres as the element says. Of a sky, its sun's.
struct RigSize {
  glm::vec2 size{0.0F};
  bool inDegrees = false;
  bool isRound = false;
};
/// None for what is all round.
[[nodiscard]] std::optional<RigSize> sizeOf(const RigElement& element);
[[nodiscard]] RigElement withSize(const RigElement& element, const glm::vec2& size);

/// The number that says how bright: radiance, irradiance, cd/m² or lux, whichever the element has; a sky's factor.
[[nodiscard]] float amountOf(const RigElement& element);
[[nodiscard]] RigElement withAmount(const RigElement& element, float amount);

}  // namespace dermis
