// Flat pieces side by side in a square.
#pragma once

#include <glm/glm.hpp>
#include <vector>

namespace dermis::sculpt {

struct FlatPiece {
  std::vector<glm::vec2> points;  ///< mm
  std::vector<glm::uvec3> triangles;
};

struct Packing {
  float uvPerMillimetre = 0.0F;
  std::vector<glm::vec2> offsets;  ///< of each piece, in uv, after scaling
};

/// The largest scale at which the pieces fit in 0..1 without turning them, each placed at the first free place from the
/// bottom, larger ones first; between them stays a gap of at least 1/256.
[[nodiscard]] Packing pack(const std::vector<FlatPiece>& pieces);

}  // namespace dermis::sculpt
