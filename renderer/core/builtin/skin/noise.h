// Noise in space: the same numbers on every machine.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>

namespace dermis::skin {

/// 32 well-mixed bits of a lattice place.
[[nodiscard]] std::uint32_t latticeHash(const glm::ivec3& cell, std::uint32_t seed);
/// 0..1 of the hash's bits from `shift` on.
[[nodiscard]] float unit(std::uint32_t hash, unsigned shift = 0);

/// Gradient noise (Perlin 2002, "Improving Noise"), about −1..1, mean 0; features are 1 apart.
[[nodiscard]] float noise(const glm::vec3& p, std::uint32_t seed);
/// `octaves` of it, each half as large and as strong: about −1..1.
[[nodiscard]] float fractal(const glm::vec3& p, int octaves, std::uint32_t seed);

/// Distances to the nearest and the next feature point, one a cell of size 1 (Worley 1996), and the nearest's hash.
struct Cells {
  float first, second;
  std::uint32_t hash;
};
[[nodiscard]] Cells cells(const glm::vec3& p, std::uint32_t seed);

/// Soft round spots, one a cell of size 1 at most: `share` of the cells have one of radius up to `radius`. 0..1.
[[nodiscard]] float spots(const glm::vec3& p, float share, float radius, float softness, std::uint32_t seed);

}  // namespace dermis::skin
