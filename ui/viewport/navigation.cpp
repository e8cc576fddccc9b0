#include "ui/viewport/navigation.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

namespace dermis::navigation {
namespace {

constexpr float kPole = 0.02F;  // radians kept from straight up and down, where a turn about +Y has no direction

constexpr float kFarthest = 1e6F;  // scene units; beyond it a picture is empty and numbers end

/// As near as a camera comes to a target: nearer, the digits of both no longer say in which direction it looks.
float nearest(const glm::vec3& target) { return std::max(1e-5F, 1e-4F * glm::length(target)); }

/// A direction as azimuth about +Y and elevation.
struct Angles {
  float azimuth, elevation;
};
Angles anglesOf(const glm::vec3& d) {
  return {std::atan2(d.x, d.z), std::asin(std::clamp(d.y / glm::length(d), -1.0F, 1.0F))};
}
glm::vec3 directionOf(const Angles& a) {
  return {std::cos(a.elevation) * std::sin(a.azimuth), std::sin(a.elevation),
          std::cos(a.elevation) * std::cos(a.azimuth)};
}
float limited(float elevation) {
  const float most = glm::half_pi<float>() - kPole;
  return std::clamp(elevation, -most, most);
}

struct Axes {
  glm::vec3 right, up, forward;
};
Axes axesOf(const Camera& camera) {
  const glm::vec3 forward = glm::normalize(camera.target - camera.position);
  const glm::vec3 right = glm::normalize(glm::cross(forward, camera.up));
  return {right, glm::cross(right, forward), forward};
}

}  // namespace

Camera orbit(const Camera& camera, float right, float up) {
  const glm::vec3 offset = camera.position - camera.target;
  Angles angles = anglesOf(offset);
  angles.azimuth -= right;
  angles.elevation = limited(angles.elevation + up);
  Camera next = camera;
  next.position = camera.target + glm::length(offset) * directionOf(angles);
  next.up = {0.0F, 1.0F, 0.0F};
  return next;
}

float unitsPerPixel(const Camera& camera, float height) {
  const float whole = camera.orthographicHeight.value_or(2.0F * glm::length(camera.position - camera.target) *
                                                         std::tan(0.5F * glm::radians(camera.verticalFovDegrees)));
  return whole / std::max(height, 1.0F);
}

Camera pan(const Camera& camera, float rightPixels, float upPixels, float height) {
  const Axes axes = axesOf(camera);
  const glm::vec3 move = -unitsPerPixel(camera, height) * (rightPixels * axes.right + upPixels * axes.up);
  Camera next = camera;
  next.position += move;
  next.target += move;
  return next;
}

Camera zoom(const Camera& camera, float steps) {
  const glm::vec3 offset = camera.position - camera.target;
  const float distance = glm::length(offset);
  const float closest = std::min(nearest(camera.target), distance);
  const float limit = std::max(kFarthest, distance);
  // Where a camera came from, it may stay: a step never moves it the other way.
  const float factor = std::clamp(std::pow(0.88F, steps), closest / distance, limit / distance);
  Camera next = camera;
  next.position = camera.target + factor * offset;
  if (next.orthographicHeight)
    next.orthographicHeight = std::clamp(factor * *next.orthographicHeight, std::min(closest, *next.orthographicHeight),
                                         std::max(kFarthest, *next.orthographicHeight));
  return next;
}

Camera lookAt(const Camera& camera, const glm::vec3& point) {
  Camera next = camera;
  next.position += point - camera.target;
  next.target = point;
  return next;
}

Camera frame(const Camera& camera, const Bounds& bounds, float aspect) {
  const float half = 0.5F * glm::radians(camera.verticalFovDegrees);
  const float narrow = aspect >= 1.0F ? half : std::atan(std::tan(half) * aspect);
  const glm::vec3 direction = glm::normalize(camera.position - camera.target);
  Camera next = camera;
  next.target = bounds.centre();
  next.position = next.target + direction * (1.05F * bounds.radius() / std::sin(narrow));
  if (next.orthographicHeight) next.orthographicHeight = 2.1F * bounds.radius() / std::min(aspect, 1.0F);
  return next;
}

Camera fly(const Camera& camera, const glm::vec3& distances) {
  const Axes axes = axesOf(camera);
  const glm::vec3 move = distances.x * axes.right + distances.y * axes.up + distances.z * axes.forward;
  Camera next = camera;
  next.position += move;
  next.target += move;
  return next;
}

Camera look(const Camera& camera, float right, float up) {
  const glm::vec3 ahead = camera.target - camera.position;
  Angles angles = anglesOf(ahead);
  angles.azimuth -= right;
  angles.elevation = limited(angles.elevation + up);
  Camera next = camera;
  next.target = camera.position + glm::length(ahead) * directionOf(angles);
  next.up = {0.0F, 1.0F, 0.0F};
  return next;
}

}  // namespace dermis::navigation
