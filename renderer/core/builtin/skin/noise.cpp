#include "core/builtin/skin/noise.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace dermis::skin {
namespace {

/// Wellons 2018, "Prospecting for Hash Functions": lowbias32.
std::uint32_t mixed(std::uint32_t h) {
  h ^= h >> 16U;
  h *= 0x7FEB352DU;
  h ^= h >> 15U;
  h *= 0x846CA68BU;
  return h ^ h >> 16U;
}

/// A place's share of the hash along each axis: odd numbers far from each other's small multiples.
constexpr glm::uvec3 kStrides(0x9E3779B1U, 0x85EBCA77U, 0xC2B2AE3DU);
std::uint32_t seeded(std::uint32_t seed) { return mixed(seed * 0x27D4EB2FU + 0x165667B1U); }

/// Directions from a cube's middle to its edges; four stand twice (Perlin 2002).
constexpr std::array<glm::vec3, 16> kSlopes = {{{1, 1, 0},
                                                {-1, 1, 0},
                                                {1, -1, 0},
                                                {-1, -1, 0},
                                                {1, 0, 1},
                                                {-1, 0, 1},
                                                {1, 0, -1},
                                                {-1, 0, -1},
                                                {0, 1, 1},
                                                {0, -1, 1},
                                                {0, 1, -1},
                                                {0, -1, -1},
                                                {1, 1, 0},
                                                {-1, 1, 0},
                                                {0, -1, 1},
                                                {0, -1, -1}}};

}  // namespace

std::uint32_t latticeHash(const glm::ivec3& cell, std::uint32_t seed) {
  const glm::uvec3 share = glm::uvec3(cell) * kStrides;
  return mixed(share.x + share.y + share.z + seeded(seed));
}

float unit(std::uint32_t hash, unsigned shift) {
  return static_cast<float>(std::rotr(hash, static_cast<int>(shift)) & 0xFFFFU) / 65535.0F;
}

float noise(const glm::vec3& p, std::uint32_t seed) {
  const glm::vec3 base = glm::floor(p);
  const glm::vec3 f = p - base;
  const glm::uvec3 share = glm::uvec3(glm::ivec3(base)) * kStrides;
  const std::uint32_t origin = share.x + share.y + share.z + seeded(seed);
  std::array<float, 8> corner{};
  for (std::uint32_t i = 0; i < 8; ++i) {
    const glm::uvec3 step(i & 1U, i >> 1U & 1U, i >> 2U);
    const std::uint32_t hash = mixed(origin + step.x * kStrides.x + step.y * kStrides.y + step.z * kStrides.z);
    corner[i] = glm::dot(kSlopes[hash & 15U], f - glm::vec3(step));
  }
  const glm::vec3 t = f * f * f * (f * (f * 6.0F - 15.0F) + 10.0F);
  const float low = glm::mix(glm::mix(corner[0], corner[1], t.x), glm::mix(corner[2], corner[3], t.x), t.y);
  const float high = glm::mix(glm::mix(corner[4], corner[5], t.x), glm::mix(corner[6], corner[7], t.x), t.y);
  return glm::mix(low, high, t.z);
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
  const glm::vec3 f = p - glm::vec3(cell);
  Cells nearest{9.0F, 9.0F, 0U};
  const auto look = [&](const glm::ivec3& step) {
    // No feature of that cell is nearer than its wall.
    const glm::vec3 wall = glm::max(glm::max(glm::vec3(step) - f, f - glm::vec3(step) - 1.0F), glm::vec3(0.0F));
    if (glm::dot(wall, wall) >= nearest.second) return;
    const std::uint32_t hash = latticeHash(cell + step, seed);
    const glm::vec3 off = glm::vec3(step) + glm::vec3(unit(hash), unit(hash, 11), unit(hash, 21)) - f;
    const float distance = glm::dot(off, off);
    if (distance < nearest.first)
      nearest = {distance, nearest.first, hash};
    else
      nearest.second = std::min(nearest.second, distance);
  };
  look(glm::ivec3(0));
  for (int z = -1; z <= 1; ++z)
    for (int y = -1; y <= 1; ++y)
      for (int x = -1; x <= 1; ++x)
        if (x != 0 || y != 0 || z != 0) look({x, y, z});
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
