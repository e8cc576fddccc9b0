#include "core/builtin/head/sdf.h"

namespace dermis::sculpt {

float ellipsoid(const glm::vec3& p, const glm::vec3& centre, const glm::vec3& radii) {
  const glm::vec3 a = (p - centre) / radii;
  const float gradient = glm::length(a / radii);
  constexpr float kAtCentre = 1e-9F;
  if (gradient < kAtCentre) return -std::min({radii.x, radii.y, radii.z});
  const float k = glm::length(a);
  return k * (k - 1.0F) / gradient;
}

float capsule(const glm::vec3& p, const glm::vec3& a, const glm::vec3& b, float ra, float rb) {
  const glm::vec3 along = b - a;
  const float h = glm::clamp(glm::dot(p - a, along) / glm::dot(along, along), 0.0F, 1.0F);
  return glm::length(p - a - along * h) - glm::mix(ra, rb, h);
}

glm::vec3 turned(const glm::vec3& p, float aboutY, float aboutX) {
  const float cy = std::cos(aboutY), sy = std::sin(aboutY), cx = std::cos(aboutX), sx = std::sin(aboutX);
  const glm::vec3 q(p.x * cy + p.z * sy, p.y, -p.x * sy + p.z * cy);
  return {q.x, q.y * cx - q.z * sx, q.y * sx + q.z * cx};
}

}  // namespace dermis::sculpt
