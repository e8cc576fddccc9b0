// From a signed distance to a closed mesh.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <vector>

namespace dermis::sculpt {

struct Surface {
  std::vector<glm::vec3> points;
  std::vector<glm::uvec3> triangles;  ///< counter-clockwise seen from outside
};

/// Planes of a lattice along each axis, ascending.
struct Lattice {
  std::array<std::vector<float>, 3> planes;
};

/// Marching cubes (Lorensen & Cline 1987) with the faces' ambiguity settled the same way from both sides (inside
/// corners kept apart), and polygons of six or more corners fanned from their middle: every edge has two triangles.
/// Blocks of the lattice further from the surface than their size are skipped, so `distance` must not exceed 1.7 times
/// the true one. The surface must not reach the lattice's hull.
[[nodiscard]] Surface polygonise(const std::function<float(const glm::vec3&)>& distance, const Lattice& lattice);

}  // namespace dermis::sculpt
