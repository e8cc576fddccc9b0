// A piece of skin laid flat.
#pragma once

#include <glm/glm.hpp>
#include <vector>

namespace dermis::sculpt {

/// A disc in space, holes allowed; triangles counter-clockwise seen from outside, every vertex used.
struct Patch {
  std::vector<glm::vec3> points;
  std::vector<glm::uvec3> triangles;
};

/// Where each vertex goes, mm: no triangle turned over, lengths kept as far as its shape lets it. Starts from Tutte's
/// embedding (Tutte 1963, "How to Draw a Graph"; holes closed by fans), which has no overlap, and lowers the symmetric
/// Dirichlet energy by the scheme of Rabinovich et al. 2017, "Scalable Locally Injective Mappings", without letting go
/// of that. Empty where the patch is no disc.
[[nodiscard]] std::vector<glm::dvec2> flatten(const Patch& patch, int iterations);

}  // namespace dermis::sculpt
