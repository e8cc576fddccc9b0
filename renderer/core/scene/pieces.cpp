#include "core/scene/pieces.h"

#include <meshoptimizer.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/scene/model.h"

namespace dermis {

Pieces piecesOf(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices) {
  // Bytes are compared: a seam in a plane of symmetry lies at 0, −0 and what rounding makes of the sine of π.
  Bounds bounds;
  for (const glm::vec3& position : positions) bounds.grow(position);
  const float nothing = 1e-7F * bounds.radius();
  std::vector<glm::vec3> places(positions.begin(), positions.end());
  for (glm::vec3& place : places)
    for (int axis = 0; axis < 3; ++axis)
      if (std::abs(place[axis]) <= nothing) place[axis] = 0.0F;
  Pieces pieces;
  pieces.point.resize(places.size());
  const std::size_t points = meshopt_generateVertexRemap(pieces.point.data(), nullptr, places.size(), places.data(),
                                                         places.size(), sizeof(glm::vec3));
  std::vector<unsigned>& parent = pieces.piece;
  parent.resize(points);
  std::iota(parent.begin(), parent.end(), 0U);
  const auto root = [&](unsigned of) {
    while (parent[of] != of) of = parent[of] = parent[parent[of]];
    return of;
  };
  for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
    const unsigned a = pieces.point[indices[i]], b = pieces.point[indices[i + 1]], c = pieces.point[indices[i + 2]];
    parent[root(a)] = root(b);
    parent[root(b)] = root(c);
  }
  for (unsigned i = 0; i < points; ++i) parent[i] = root(i);
  return pieces;
}

bool boundsSolids(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices) {
  if (positions.empty() || indices.empty()) return false;
  const Pieces pieces = piecesOf(positions, indices);
  std::vector<double> volumes(pieces.piece.size(), 0.0);
  // Each side of a triangle by its points, the lower one first, and which way it is gone along.
  std::vector<std::uint64_t> sides;
  sides.reserve(indices.size());
  for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
    const unsigned corners[3] = {pieces.point[indices[i]], pieces.point[indices[i + 1]], pieces.point[indices[i + 2]]};
    if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]) continue;
    for (int k = 0; k < 3; ++k) {
      const unsigned from = corners[k], to = corners[(k + 1) % 3];
      sides.push_back((std::uint64_t{std::min(from, to)} << 33U) | (std::uint64_t{std::max(from, to)} << 1U) |
                      (from < to ? 1U : 0U));
    }
    const glm::dvec3 a(positions[indices[i]]), b(positions[indices[i + 1]]), c(positions[indices[i + 2]]);
    volumes[pieces.piece[corners[0]]] += glm::dot(a, glm::cross(b, c));
  }
  std::ranges::sort(sides);
  for (std::size_t i = 0; i < sides.size();) {
    int turns = 0;
    const std::uint64_t side = sides[i] >> 1U;
    for (; i < sides.size() && sides[i] >> 1U == side; ++i) turns += (sides[i] & 1U) != 0 ? 1 : -1;
    if (turns != 0) return false;
  }
  for (const std::uint64_t side : sides)
    if (!(volumes[pieces.piece[static_cast<std::size_t>(side >> 33U)]] > 0.0)) return false;
  return !sides.empty();
}

}  // namespace dermis
