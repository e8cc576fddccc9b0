// Even triangles of the size each place needs.
#pragma once

#include <functional>
#include <glm/glm.hpp>

#include "core/builtin/head/polygonise.h"
#include "core/builtin/head/sculpt.h"

namespace dermis::sculpt {

struct EdgeLengths {
  /// Departure of the skin from its triangles, mm; shorter edges where it bends.
  float tolerance = 0.1F;
  std::function<float(const glm::vec3&)> shortest;
  /// Shortest and longest edge wanted at a place, mm.
  std::function<float(const glm::vec3&)> longest;
};

/// Edges split, collapsed and flipped, vertices spread along the skin (Botsch & Kobbelt 2004, "A Remeshing Approach to
/// Multiresolution Modeling", §4) towards lengths that follow the curvature (Dunyach et al. 2013, "Adaptive Remeshing
/// for Real-Time Mesh Deformation"). Stays closed; a step that would turn a triangle over is not taken.
[[nodiscard]] Surface remesh(const Surface& surface, const Sculpt& sculpt, const EdgeLengths& lengths);

}  // namespace dermis::sculpt
