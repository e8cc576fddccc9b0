// Where each light shines from in one picture, or in one sample of a still one: an area light converges because every
// sample takes another point of it, and shades and casts shadows from there.
#pragma once

#include <glm/glm.hpp>
#include <span>

#include "core/scene/model.h"
#include "core/scene/scene.h"

namespace dermis {

struct LightPoint {
  LightType type = LightType::Point;  ///< what the shader takes it for: a point of an area light shines as a Rect does
  glm::vec3 position{0.0F};
  glm::vec3 direction{0.0F, 0.0F, -1.0F};  ///< unit; of a Rect the side that it shines to
  float intensityScale = 1.0F;
  float spread = 0.0F;          ///< radius of the piece of the light that the point stands for; scene units
  float outerDegrees = 180.0F;  ///< of a spot
  bool castsShadow = true;

  bool operator==(const LightPoint&) const = default;
};

[[nodiscard]] bool isAreaLight(const Light& light);

/// The light's centre, for one picture that has no samples. `light` is where it is now (its animation applied).
[[nodiscard]] LightPoint centreOf(const Light& light, float millimetresPerUnit);

/// The part of a sphere light that any of `lit` can see: the normals there are within acos(least) of `axis`. Other
/// lights have none.
struct LightCap {
  glm::vec3 axis{0.0F, 0.0F, 1.0F};
  float least = -1.0F;
};
[[nodiscard]] LightCap litCap(const Light& light, float millimetresPerUnit, std::span<const Bounds> lit);

/// A point of an area light for two numbers 0..1. Its intensity makes the mean over uniform numbers exact, for every
/// point that a sphere's `cap` was made for. `pieces` is how many points share the light. Other lights are their
/// centre.
[[nodiscard]] LightPoint pointOf(const Light& light, float millimetresPerUnit, const LightCap& cap, glm::vec2 numbers,
                                 int pieces);

/// Sample `index` of the (0,2)-sequence of van der Corput 1935 and Sobol 1967, so that any 2^n samples are stratified;
/// moved so that the first one is `first`.
[[nodiscard]] glm::vec2 lightNumbers(int index, glm::vec2 first = glm::vec2(0.5F));

}  // namespace dermis
