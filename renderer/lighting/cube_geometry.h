// Where the texels of a GL cube map look: OpenGL 4.5, table 8.19. Face order +X −X +Y −Y +Z −Z, row 0 is t = 0.
#pragma once

#include <cmath>
#include <glm/glm.hpp>

namespace dermis {

/// A place on a cube: face 0..5 and 0..1 coordinates.
struct CubePoint {
  int face;
  float s, t;
};

/// The (not normalised) direction seen at (s, t) of a face; s and t may lie a little outside 0..1.
[[nodiscard]] inline glm::vec3 cubeVector(int face, float s, float t) {
  const float sc = 2.0F * s - 1.0F;
  const float tc = 2.0F * t - 1.0F;
  switch (face) {
    case 0:
      return {1.0F, -tc, -sc};
    case 1:
      return {-1.0F, -tc, sc};
    case 2:
      return {sc, 1.0F, tc};
    case 3:
      return {sc, -1.0F, -tc};
    case 4:
      return {sc, -tc, 1.0F};
    default:
      return {-sc, -tc, -1.0F};
  }
}

[[nodiscard]] inline glm::vec3 cubeDirection(int face, float s, float t) {
  return glm::normalize(cubeVector(face, s, t));
}

/// The place that GL samples for a direction.
[[nodiscard]] inline CubePoint cubePoint(const glm::vec3& d) {
  const glm::vec3 a = glm::abs(d);
  int face = 0;
  float sc = 0.0F;
  float tc = 0.0F;
  float ma = 1.0F;
  if (a.x >= a.y && a.x >= a.z) {
    face = d.x >= 0.0F ? 0 : 1, sc = d.x >= 0.0F ? -d.z : d.z, tc = -d.y, ma = a.x;
  } else if (a.y >= a.z) {
    face = d.y >= 0.0F ? 2 : 3, sc = d.x, tc = d.y >= 0.0F ? d.z : -d.z, ma = a.y;
  } else {
    face = d.z >= 0.0F ? 4 : 5, sc = d.z >= 0.0F ? d.x : -d.x, tc = -d.y, ma = a.z;
  }
  return {face, 0.5F * (sc / ma + 1.0F), 0.5F * (tc / ma + 1.0F)};
}

/// Solid angle of texel (x, y) of a face of n×n texels, exactly: the signed corner areas of Van Oosterom & Strackee
/// (1983) for a plane at distance 1, ∫∫ (1+u²+v²)^(−3/2) = atan(uv / √(1+u²+v²)).
[[nodiscard]] inline double cubeTexelSolidAngle(int x, int y, int n) {
  const auto corner = [n](int i, int j) {
    const double u = 2.0 * i / n - 1.0;
    const double v = 2.0 * j / n - 1.0;
    return std::atan2(u * v, std::sqrt(1.0 + u * u + v * v));
  };
  return corner(x, y) - corner(x + 1, y) - corner(x, y + 1) + corner(x + 1, y + 1);
}

/// The direction at (u, v) of a lat-long image: u = 0.5 looks to −Z, u = 0.75 to +X, v = 0 is +Y.
[[nodiscard]] inline glm::vec3 latLongDirection(double u, double v) {
  constexpr double kPi = 3.14159265358979323846;
  const double phi = (u - 0.5) * 2.0 * kPi;
  const double theta = v * kPi;
  return {static_cast<float>(std::sin(theta) * std::sin(phi)), static_cast<float>(std::cos(theta)),
          static_cast<float>(-std::sin(theta) * std::cos(phi))};
}

}  // namespace dermis
