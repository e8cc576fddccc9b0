// What of a mesh hangs together.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace dermis {

/// Vertices at one place are one point, whatever else sets them apart; points that triangles join are one piece.
struct Pieces {
  std::vector<unsigned> point;  ///< by vertex
  std::vector<unsigned> piece;  ///< by point: some point of its piece, the same for all of it; itself where unused
};
/// `indices` are triangles of `positions`.
[[nodiscard]] Pieces piecesOf(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices);

/// Whether the triangles bound solids: every edge has a triangle on each side that turns the same way, and each piece
/// faces outwards, by its volume. From outside only front faces of such a surface are seen.
[[nodiscard]] bool boundsSolids(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices);

}  // namespace dermis
