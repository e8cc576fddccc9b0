// The one length that says how far light gets in a material, for what asks for no more than that.
#pragma once

#include <glm/glm.hpp>

#include "core/material/material.h"

namespace dermis {

struct ScatteringLength {
  glm::vec3 mm{0.0F};
  RadiusReading reading = RadiusReading::DiffuseMeanFreePath;
};

/// Of a Burley profile: radius × colour × scale, as the material reads it. Of a sum of Gaussians: the d of the Burley
/// profile with the same mean squared radius, Σ w · 2v = 14 d², × colour × scale.
[[nodiscard]] ScatteringLength scatteringLength(const MaterialParameters& parameters);

}  // namespace dermis
