#include "ui/viewport/light_dome.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/quaternion.hpp>

namespace dermis::dome {
namespace {

/// The shortest turn from one unit vector to another.
glm::quat turnBetween(const glm::vec3& from, const glm::vec3& to) {
  const float cosine = glm::dot(from, to);
  if (cosine < -0.99999F) {
    const glm::vec3 other = std::abs(from.y) < 0.9F ? glm::vec3(0.0F, 1.0F, 0.0F) : glm::vec3(1.0F, 0.0F, 0.0F);
    return glm::angleAxis(glm::pi<float>(), glm::normalize(glm::cross(from, other)));
  }
  const glm::vec3 axis = glm::cross(from, to);
  return glm::normalize(glm::quat(1.0F + cosine, axis.x, axis.y, axis.z));
}

glm::vec3 unitOr(const glm::vec3& v, const glm::vec3& otherwise) {
  const float length = glm::length(v);
  return length > 1e-9F ? v / length : otherwise;
}

}  // namespace

double ringRadius(const Projection& projection) {
  return 0.22 * std::min(projection.size().width(), projection.size().height());
}

QPointF place(const Projection& projection, const glm::vec3& towards) {
  const float x = glm::dot(towards, projection.right());
  const float y = glm::dot(towards, projection.up());
  const float angle = std::acos(std::clamp(-glm::dot(towards, projection.forward()), -1.0F, 1.0F));
  const float across = std::hypot(x, y);
  // Straight behind, every direction of the map is as right as another: up.
  const glm::vec2 way = across > 1e-6F ? glm::vec2(x, y) / across : glm::vec2(0.0F, 1.0F);
  const double r = ringRadius(projection) * static_cast<double>(angle / glm::half_pi<float>());
  return projection.middle() + QPointF(r * static_cast<double>(way.x), -r * static_cast<double>(way.y));
}

glm::vec3 direction(const Projection& projection, QPointF place) {
  const QPointF offset = place - projection.middle();
  const double r = std::hypot(offset.x(), offset.y());
  const auto angle = static_cast<float>(std::min(r / ringRadius(projection), 2.0)) * glm::half_pi<float>();
  if (r < 1e-6) return -projection.forward();
  const glm::vec3 way =
      static_cast<float>(offset.x() / r) * projection.right() - static_cast<float>(offset.y() / r) * projection.up();
  return glm::normalize(std::sin(angle) * way - std::cos(angle) * projection.forward());
}

glm::vec3 towards(const Light& light, const glm::vec3& centre) {
  if (light.type == LightType::Directional) return unitOr(-light.direction, {0.0F, 0.0F, 1.0F});
  return unitOr(light.position - centre, unitOr(-light.direction, {0.0F, 0.0F, 1.0F}));
}

Light turned(const Light& light, const glm::vec3& centre, const glm::vec3& to) {
  Light next = light;
  const glm::quat turn = turnBetween(towards(light, centre), to);
  next.direction = glm::normalize(turn * unitOr(light.direction, {0.0F, 0.0F, -1.0F}));
  if (light.type == LightType::Directional)
    next.direction = -to;
  else
    next.position = centre + glm::length(light.position - centre) * to;
  return next;
}

Light moved(const Light& light, const glm::vec3& centre, float factor) {
  Light next = light;
  if (light.type != LightType::Directional) next.position = centre + factor * (light.position - centre);
  return next;
}

Light resized(const Light& light, float factor) {
  Light next = light;
  switch (light.type) {
    case LightType::Sphere:
      next.radiusMm = std::max(light.radiusMm * factor, 0.1F);
      break;
    case LightType::Rect:
      next.sizeMm = glm::max(light.sizeMm * factor, glm::vec2(0.1F));
      break;
    case LightType::Spot:
      next.outerDegrees = std::clamp(light.outerDegrees * factor, 0.5F, 90.0F);
      next.innerDegrees = std::min(light.innerDegrees * factor, next.outerDegrees);
      break;
    default:
      if (light.visible) next.radiusMm = std::max(light.radiusMm * factor, 0.1F);
      break;
  }
  return next;
}

std::optional<std::size_t> keyLight(const std::vector<Light>& lights, const glm::vec3& centre) {
  std::optional<std::size_t> best;
  float most = 0.0F;
  for (std::size_t i = 0; i < lights.size(); ++i) {
    const Light& light = lights[i];
    if (!light.enabled) continue;
    const float distance = std::max(glm::length(light.position - centre), 1e-3F);
    const float received = glm::dot(light.color, glm::vec3(0.2126F, 0.7152F, 0.0722F)) * light.intensity /
                           (light.type == LightType::Directional ? 1.0F : distance * distance);
    if (received <= most) continue;
    most = received;
    best = i;
  }
  return best;
}

}  // namespace dermis::dome
