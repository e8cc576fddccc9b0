// The environment's radiance in the first nine real spherical harmonics.
#pragma once

#include <array>
#include <glm/glm.hpp>

#include "lighting/radiance_image.h"

namespace dermis {

/// ∫ L(d) Y_lm(d) dω, RGB, in the order (l,m) 00, 1−1, 10, 11, 2−2, 2−1, 20, 21, 22 of the real, orthonormal basis
/// without the Condon-Shortley phase (Ramamoorthi & Hanrahan 2001, equation 3: Y_1−1 ∝ y, Y_10 ∝ z, Y_11 ∝ x), in
/// Dermis's axes (+Y up). The sum goes over all pixels with their solid angles.
[[nodiscard]] std::array<glm::dvec3, 9> sphericalHarmonics9(const RadianceMap& map);

}  // namespace dermis
