// Rays through the front of an eye, in doubles and by angles: the twin of models/eye_optics.glsl, written from its
// description. Millimetres of an eyeball of radius 12 at the origin that looks along +Z.
#pragma once

#include <cmath>
#include <glm/glm.hpp>
#include <optional>

namespace dermis::reference {

struct EyeModel {
  double rim = 5.9, depth = 2.5, ior = 1.376;
  double curve = 7.8;
  [[nodiscard]] double centreZ() const { return std::sqrt(144.0 - rim * rim) - std::sqrt(curve * curve - rim * rim); }
  [[nodiscard]] double irisZ() const { return centreZ() + curve - depth; }
};

struct EyeHit {
  glm::dvec3 entry, normal;  ///< on the cornea
  glm::dvec2 iris;
};

/// Where a ray that travels along the unit `direction` through `point` enters the cornea, and what it meets of the
/// plane of the iris. Nothing where it misses the cornea's cap.
[[nodiscard]] inline std::optional<EyeHit> traceEye(const EyeModel& eye, const glm::dvec3& point,
                                                    const glm::dvec3& direction) {
  const glm::dvec3 centre(0.0, 0.0, eye.centreZ());
  const glm::dvec3 nearest = point + direction * glm::dot(centre - point, direction);
  const double off = glm::length(nearest - centre);
  if (off >= eye.curve) return std::nullopt;
  EyeHit hit;
  hit.entry = nearest - direction * std::sqrt(eye.curve * eye.curve - off * off);
  if (std::hypot(hit.entry.x, hit.entry.y) > eye.rim || hit.entry.z < centre.z) return std::nullopt;
  hit.normal = (hit.entry - centre) / eye.curve;
  // Snell: the part along the surface shrinks by the index.
  const double cosIn = -glm::dot(direction, hit.normal);
  const glm::dvec3 along = direction + cosIn * hit.normal;
  const double sinIn = glm::length(along);
  glm::dvec3 inside = -hit.normal;
  if (sinIn > 1e-12) {
    const double angle = std::asin(sinIn / eye.ior);
    inside = -std::cos(angle) * hit.normal + std::sin(angle) * along / sinIn;
  }
  const double way = hit.entry.z > eye.irisZ() ? (eye.irisZ() - hit.entry.z) / inside.z : 0.0;
  hit.iris = glm::dvec2(hit.entry + way * inside);
  return hit;
}

}  // namespace dermis::reference
