#include "core/builtin/skin/noise.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace dermis::skin {
namespace {

/// One of twelve directions from a cube's middle to its edges.
float slope(std::uint32_t hash, const glm::vec3& d) {
  switch (hash % 12U) {
    case 0:
      return d.x + d.y;
    case 1:
      return d.x - d.y;
    case 2:
      return -d.x + d.y;
    case 3:
      return -d.x - d.y;
    case 4:
      return d.x + d.z;
    case 5:
      return d.x - d.z;
    case 6:
      return -d.x + d.z;
    case 7:
      return -d.x - d.z;
    case 8:
      return d.y + d.z;
    case 9:
      return d.y - d.z;
    case 10:
      return -d.y + d.z;
    default:
      return -d.y - d.z;
  }
}

}  // namespace

std::uint32_t latticeHash(const glm::ivec3& cell, std::uint32_t seed) {
  // Jarzynski & Olano 2020, "Hash Functions for GPU Rendering": pcg3d, with the seed in the first step.
  glm::uvec3 v = glm::uvec3(cell) * 1664525U + 1013904223U + seed;
  v.x += v.y * v.z;
  v.y += v.z * v.x;
  v.z += v.x * v.y;
  v ^= v >> 16U;
  v.x += v.y * v.z;
  v.y += v.z * v.x;
  v.z += v.x * v.y;
  return v.x ^ v.z;
}

float unit(std::uint32_t hash, unsigned shift) {
  return static_cast<float>(std::rotr(hash, static_cast<int>(shift)) & 0xFFFFU) / 65535.0F;
}

float noise(const glm::vec3& p, std::uint32_t seed) {
  const glm::vec3 base = glm::floor(p);
  const glm::vec3 f = p - base;
  const glm::ivec3 cell(base);
  const glm::vec3 t = f * f * f * (f * (f * 6.0F - 15.0F) + 10.0F);
  const auto corner = [&](int x, int y, int z) {
    return slope(latticeHash(cell + glm::ivec3(x, y, z), seed), f - glm::vec3(x, y, z));
  };
  const auto edge = [&](int y, int z) { return glm::mix(corner(0, y, z), corner(1, y, z), t.x); };
  return glm::mix(glm::mix(edge(0, 0), edge(1, 0), t.y), glm::mix(edge(0, 1), edge(1, 1), t.y), t.z);
}

float fractal(const glm::vec3& p, int octaves, std::uint32_t seed) {
  float sum = 0.0F, strength = 1.0F, scale = 1.0F;
  for (int i = 0; i < octaves; ++i) {
    // Moved by no whole number, so that the octaves' lattices don't meet.
    sum += strength * noise(p * scale + 17.37F * static_cast<float>(i), seed + static_cast<std::uint32_t>(i));
    strength *= 0.5F;
    scale *= 2.0F;
  }
  return sum;
}

Cells cells(const glm::vec3& p, std::uint32_t seed) {
  const glm::ivec3 cell(glm::floor(p));
  Cells nearest{9.0F, 9.0F, 0U};
  for (int z = -1; z <= 1; ++z)
    for (int y = -1; y <= 1; ++y)
      for (int x = -1; x <= 1; ++x) {
        const glm::ivec3 at = cell + glm::ivec3(x, y, z);
        const std::uint32_t hash = latticeHash(at, seed);
        const glm::vec3 feature = glm::vec3(at) + glm::vec3(unit(hash), unit(hash, 11), unit(hash, 21));
        const float distance = glm::dot(feature - p, feature - p);
        if (distance < nearest.first)
          nearest = {distance, nearest.first, hash};
        else
          nearest.second = std::min(nearest.second, distance);
      }
  return {std::sqrt(nearest.first), std::sqrt(nearest.second), nearest.hash};
}

float spots(const glm::vec3& p, float share, float radius, float softness, std::uint32_t seed) {
  if (share <= 0.0F) return 0.0F;
  const Cells at = cells(p, seed);
  const std::uint32_t own = latticeHash(glm::ivec3(static_cast<int>(at.hash & 0xFFFFU), 5, 9), seed);
  const float chance = unit(own), size = unit(own, 11), strength = unit(own, 21);
  // Fewer spots come out as fewer, not as fainter ones.
  const float present = glm::smoothstep(0.0F, 0.06F, share - chance);
  const float reach = radius * (0.45F + 0.55F * size * size);
  return present * (0.4F + 0.6F * strength) *
         (1.0F - glm::smoothstep(reach * (1.0F - softness), reach * (1.0F + softness), at.first));
}

}  // namespace dermis::skin
