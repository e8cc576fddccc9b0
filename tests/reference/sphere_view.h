// The unit sphere at the origin as a camera sees it: the point under each pixel's centre.
#pragma once

#include <cmath>
#include <glm/glm.hpp>
#include <numbers>
#include <optional>

#include "core/scene/scene.h"

namespace dermis::reference {

struct SpherePoint {
  glm::dvec3 normal;  ///< and position: the radius is 1
  glm::dvec3 view;    ///< unit, to the camera
};

/// Column x and row y from the top left of a width × height picture; nothing where the ray misses. interfaces.md,
/// Conventions.
[[nodiscard]] inline std::optional<SpherePoint> sphereUnderPixel(const Camera& camera, int width, int height, int x,
                                                                 int y) {
  const glm::dvec3 eye(camera.position);
  const glm::dvec3 forward = glm::normalize(glm::dvec3(camera.target) - eye);
  const glm::dvec3 right = glm::normalize(glm::cross(forward, glm::dvec3(camera.up)));
  const glm::dvec3 up = glm::cross(right, forward);
  const double halfHeight =
      camera.orthographicHeight
          ? 0.5 * static_cast<double>(*camera.orthographicHeight)
          : std::tan(0.5 * static_cast<double>(camera.verticalFovDegrees) * std::numbers::pi / 180.0);
  const double across = (2.0 * (x + 0.5) / width - 1.0) * halfHeight * width / height;
  const double upwards = (1.0 - 2.0 * (y + 0.5) / height) * halfHeight;
  const glm::dvec3 offset = right * across + up * upwards;
  const glm::dvec3 origin = camera.orthographicHeight ? eye + offset : eye;
  const glm::dvec3 direction = camera.orthographicHeight ? forward : glm::normalize(forward + offset);
  const double b = glm::dot(origin, direction);
  const double discriminant = b * b - (glm::dot(origin, origin) - 1.0);
  if (discriminant <= 0.0) return std::nullopt;
  const glm::dvec3 hit = origin + direction * (-b - std::sqrt(discriminant));
  return SpherePoint{glm::normalize(hit), -direction};
}

}  // namespace dermis::reference
