// The outlines of a rig's lamps as the subject sees them: what comes from a direction, and how near an edge is.
#pragma once

#include <functional>
#include <glm/glm.hpp>

#include "core/light_rig/light_rig.h"

namespace dermis {

struct ShapeSample {
  float value = 0.0F;  ///< radiance as a share of the element's own
  float edge = 0.0F;   ///< radians to the nearest sharp edge, never more than there are
};

/// A light with an outline. Nothing comes from outside its cone.
struct RigShape {
  std::function<ShapeSample(const glm::vec3& direction)> sample;
  glm::vec3 axis{0.0F, 1.0F, 0.0F};
  float coneAngle = 0.0F;  ///< radians, half
  float finest = 0.0F;     ///< radians across the narrowest part that matters
};

/// Of the types with a face: softbox, strip, disc, ring, window.
[[nodiscard]] RigShape lampShape(const RigElement& element);
/// A disc on the sky.
[[nodiscard]] RigShape discShape(const glm::vec3& axis, float radiusAngle);

}  // namespace dermis
