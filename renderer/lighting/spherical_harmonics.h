// The environment's radiance in the first nine real spherical harmonics.
#pragma once

#include <array>
#include <glm/glm.hpp>

#include "core/bake/harmonics.h"
#include "lighting/environment_bake.h"
#include "lighting/radiance_image.h"

namespace dermis {

/// ∫ L(d) Y_lm(d) dω, RGB, in the order (l,m) 00, 1−1, 10, 11, 2−2, 2−1, 20, 21, 22 of the real, orthonormal basis
/// without the Condon-Shortley phase (Ramamoorthi & Hanrahan 2001, equation 3: Y_1−1 ∝ y, Y_10 ∝ z, Y_11 ∝ x), in
/// Dermis's axes (+Y up). The sum goes over all pixels with their solid angles.
[[nodiscard]] std::array<glm::dvec3, 9> sphericalHarmonics9(const RadianceMap& map);

/// The same radiance from a cube of floats or halves that holds irradiance/π, which has lost everything but these
/// coefficients' like: each is divided by what the clamped cosine multiplied it by.
[[nodiscard]] Harmonics<glm::vec3> harmonicsOfIrradiance(const CubeTexels& irradiance);

/// Coefficients of the function d ↦ f(turn · d).
[[nodiscard]] Harmonics<glm::vec3> turned(const Harmonics<glm::vec3>& f, const glm::mat3& turn);

}  // namespace dermis
