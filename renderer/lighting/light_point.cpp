#include "lighting/light_point.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace dermis {

namespace {

constexpr float kPi = std::numbers::pi_v<float>;

glm::vec3 unitOr(const glm::vec3& v, const glm::vec3& otherwise) {
  const float length = glm::length(v);
  return length > 0.0F ? v / length : otherwise;
}

std::uint32_t reversed(std::uint32_t bits) {
  std::uint32_t result = 0;
  for (int i = 0; i < 32; ++i, bits >>= 1) result = result << 1 | (bits & 1U);
  return result;
}

/// Order in which the points are taken, shuffled so that any 2^n that follow each other are still 2^n neighbours of the
/// sequence: every second point in order would lie on one side of the light, and pixels are jittered in steps of nearly
/// one half. Laine & Karras 2011, "Stratified Sampling for Stochastic Transparency"; constants of Burley 2020,
/// "Practical Hash-based Owen Scrambling".
std::uint32_t shuffled(std::uint32_t index) {
  std::uint32_t x = reversed(index) + 0x5bd1e995U;
  x ^= x * 0x6c50b47cU;
  x ^= x * 0xb82f1e52U;
  x ^= x * 0xc7afe638U;
  x ^= x * 0x8d22f6e6U;
  return reversed(x);
}

glm::uvec2 sobol(std::uint32_t index) {
  glm::uvec2 point(0U);
  std::uint32_t column = 1U << 31;
  const std::uint32_t corput = reversed(shuffled(index));
  point.x = corput;
  for (std::uint32_t i = reversed(corput); i != 0; i >>= 1, column ^= column >> 1)
    if ((i & 1U) != 0) point.y ^= column;
  return point;
}

/// Two unit vectors that complete `z` to a right-handed frame.
void frameAbout(const glm::vec3& z, glm::vec3& x, glm::vec3& y) {
  const glm::vec3 up = std::abs(z.y) > 0.99F ? glm::vec3(0.0F, 0.0F, -1.0F) : glm::vec3(0.0F, 1.0F, 0.0F);
  x = glm::normalize(glm::cross(up, z));
  y = glm::cross(z, x);
}

LightPoint pointOfRect(const Light& light, float millimetresPerUnit, glm::vec2 numbers, int pieces) {
  LightPoint point = centreOf(light, millimetresPerUnit);
  glm::vec3 x, y;
  frameAbout(point.direction, x, y);
  const glm::vec2 size = light.sizeMm / millimetresPerUnit;
  const glm::vec2 offset = (numbers - 0.5F) * size;
  point.position += offset.x * x + offset.y * y;
  point.spread = std::sqrt(std::max(size.x * size.y, 0.0F) / (kPi * static_cast<float>(pieces)));
  return point;
}

/// A sphere of radiance L and radius r has the intensity I = L π r². A point y on it, found with density p per area,
/// sends L cos θ_y / p into the direction that leaves it at θ_y: what a flat emitter of intensity L / p does. Points
/// that nothing sees are never taken. The density follows L cos θ_y as seen from far away, which makes each sample
/// exact for far points; a share of it is uniform, so that no weight grows without bound.
LightPoint pointOfSphere(const Light& light, float millimetresPerUnit, const LightCap& cap, glm::vec2 numbers,
                         int pieces) {
  LightPoint point = centreOf(light, millimetresPerUnit);
  const float radius = light.radiusMm / millimetresPerUnit;
  const float uniform = cap.least > -1.0F ? 0.1F : 1.0F;
  // t = (μ − least)/(1 − least) has the density 2 (1 − uniform) t + uniform.
  const float t = uniform < 1.0F ? (std::sqrt(uniform * uniform + 4.0F * (1.0F - uniform) * numbers.x) - uniform) /
                                       (2.0F * (1.0F - uniform))
                                 : numbers.x;
  const float mu = std::clamp(cap.least + t * (1.0F - cap.least), -1.0F, 1.0F);
  const float sine = std::sqrt(std::max(1.0F - mu * mu, 0.0F));
  const float phi = 2.0F * kPi * numbers.y;
  glm::vec3 x, y;
  frameAbout(cap.axis, x, y);
  point.type = LightType::Rect;
  point.direction = glm::normalize(mu * cap.axis + sine * (std::cos(phi) * x + std::sin(phi) * y));
  point.position = light.position + radius * point.direction;
  // Density per area: that of t over dμ = (1 − least) dt, over 2π r² dμ.
  const float density = 2.0F * (1.0F - uniform) * t + uniform;
  point.intensityScale = 2.0F * (1.0F - cap.least) / std::max(density, 1e-6F);
  point.spread = radius / std::sqrt(static_cast<float>(pieces));
  return point;
}

}  // namespace

bool isAreaLight(const Light& light) {
  if (light.type == LightType::Sphere) return light.radiusMm > 0.0F;
  return light.type == LightType::Rect && light.sizeMm.x > 0.0F && light.sizeMm.y > 0.0F;
}

LightPoint centreOf(const Light& light, float millimetresPerUnit) {
  LightPoint point;
  point.type = light.type;
  point.position = light.position;
  point.direction = unitOr(light.direction, {0.0F, 0.0F, -1.0F});
  point.castsShadow = light.shadow;
  if (light.type == LightType::Spot) point.outerDegrees = light.outerDegrees;
  if (light.type == LightType::Sphere) point.spread = light.radiusMm / millimetresPerUnit;
  if (light.type == LightType::Rect)
    point.spread = std::sqrt(std::max(light.sizeMm.x * light.sizeMm.y, 0.0F) / kPi) / millimetresPerUnit;
  return point;
}

LightCap litCap(const Light& light, float millimetresPerUnit, std::span<const Bounds> lit) {
  LightCap cap;
  if (light.type != LightType::Sphere || lit.empty()) return cap;
  Bounds all;
  for (const Bounds& box : lit) {
    all.grow(box.min);
    all.grow(box.max);
  }
  cap.axis = unitOr(all.centre() - light.position, cap.axis);
  const float radius = light.radiusMm / millimetresPerUnit;
  // A point at the distance d sees normals up to acos(r/d) from the direction to it.
  float widest = 0.0F;
  for (const Bounds& box : lit)
    for (unsigned corner = 0; corner < 8; ++corner) {
      const glm::vec3 offset =
          glm::vec3((corner & 1U) != 0 ? box.max.x : box.min.x, (corner & 2U) != 0 ? box.max.y : box.min.y,
                    (corner & 4U) != 0 ? box.max.z : box.min.z) -
          light.position;
      const float distance = glm::length(offset);
      if (distance <= radius) return cap;
      widest = std::max(widest, std::acos(std::clamp(glm::dot(offset, cap.axis) / distance, -1.0F, 1.0F)) +
                                    std::acos(radius / distance));
    }
  cap.least = widest < kPi ? std::cos(widest) : -1.0F;
  return cap;
}

LightPoint pointOf(const Light& light, float millimetresPerUnit, const LightCap& cap, glm::vec2 numbers, int pieces) {
  if (!isAreaLight(light)) return centreOf(light, millimetresPerUnit);
  if (light.type == LightType::Rect) return pointOfRect(light, millimetresPerUnit, numbers, pieces);
  return pointOfSphere(light, millimetresPerUnit, cap, numbers, pieces);
}

glm::vec2 lightNumbers(int index, glm::vec2 first) {
  const glm::uvec2 start = sobol(0);
  const glm::uvec2 now = sobol(static_cast<std::uint32_t>(index));
  const auto moved = [](std::uint32_t n, std::uint32_t from, float to) {
    // Exclusive or with the same bits everywhere keeps the strata.
    const auto target = static_cast<std::uint32_t>(static_cast<double>(to) * 0x1p32);
    return static_cast<float>(((n ^ from ^ target) >> 8) * 0x1p-24);
  };
  return {moved(now.x, start.x, first.x), moved(now.y, start.y, first.y)};
}

}  // namespace dermis
