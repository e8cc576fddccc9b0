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
/// that no lit point sees are never taken: the rest is a cap about the direction to what is lit, in which the cosine μ
/// to that direction runs from `least` to 1. Its density follows L cos θ_y as seen from far away, which makes far
/// points exact with each sample; a share of it is uniform, so that no weight grows without bound.
LightPoint pointOfSphere(const Light& light, float millimetresPerUnit, const Bounds& lit, glm::vec2 numbers,
                         int pieces) {
  LightPoint point = centreOf(light, millimetresPerUnit);
  const float radius = light.radiusMm / millimetresPerUnit;
  const glm::vec3 towards = lit.centre() - light.position;
  const float distance = glm::length(towards);
  const glm::vec3 axis = unitOr(towards, {0.0F, 0.0F, 1.0F});
  const float least = distance > 0.0F ? std::max((radius - lit.radius()) / distance, -1.0F) : -1.0F;
  const float uniform = least > -1.0F ? 0.1F : 1.0F;
  // t = (μ − least)/(1 − least) has the density 2 (1 − uniform) t + uniform.
  const float t = uniform < 1.0F ? (std::sqrt(uniform * uniform + 4.0F * (1.0F - uniform) * numbers.x) - uniform) /
                                       (2.0F * (1.0F - uniform))
                                 : numbers.x;
  const float mu = std::clamp(least + t * (1.0F - least), -1.0F, 1.0F);
  const float sine = std::sqrt(std::max(1.0F - mu * mu, 0.0F));
  const float phi = 2.0F * kPi * numbers.y;
  glm::vec3 x, y;
  frameAbout(axis, x, y);
  point.type = LightType::Rect;
  point.direction = glm::normalize(mu * axis + sine * (std::cos(phi) * x + std::sin(phi) * y));
  point.position = light.position + radius * point.direction;
  // Density per area: that of t over dμ = (1 − least) dt, over 2π r² dμ.
  const float density = 2.0F * (1.0F - uniform) * t + uniform;
  point.intensityScale = 2.0F * (1.0F - least) / std::max(density, 1e-6F);
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

LightPoint pointOf(const Light& light, float millimetresPerUnit, const Bounds& lit, glm::vec2 numbers, int pieces) {
  if (!isAreaLight(light)) return centreOf(light, millimetresPerUnit);
  if (light.type == LightType::Rect) return pointOfRect(light, millimetresPerUnit, numbers, pieces);
  return pointOfSphere(light, millimetresPerUnit, lit, numbers, pieces);
}

glm::vec2 lightNumbers(int index, glm::vec2 first) {
  std::uint32_t corput = 0, sobol = 0;
  std::uint32_t column = 1U << 31;
  auto i = static_cast<std::uint32_t>(index);
  for (std::uint32_t bit = 1U << 31; i != 0; i >>= 1, bit >>= 1, column ^= column >> 1)
    if ((i & 1U) != 0) {
      corput |= bit;
      sobol ^= column;
    }
  const auto shifted = [](std::uint32_t n, float by) {
    const double x = n * 0x1p-32 + static_cast<double>(by);
    return static_cast<float>(x - std::floor(x));
  };
  return {shifted(corput, first.x), shifted(sobol, first.y)};
}

}  // namespace dermis
