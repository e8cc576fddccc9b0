// The places of a model that a bake is computed at, and how the rest follow from them.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <limits>
#include <vector>

#include "core/scene/model.h"

namespace dermis {

/// Vertices that are the same but for their texture coordinates are one point: a seam costs nothing and shows nothing.
struct BakePoints {
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

  std::vector<glm::vec3> positions, normals;
  std::vector<std::uint32_t> ofVertex;  ///< parallel to Model::positions; kNone for vertices of other slots
  std::vector<std::uint32_t> firstNeighbour, neighbours;  ///< along edges; of point i from firstNeighbour[i] to [i + 1]
};

/// Those of the slots that `castingSlots` doesn't name false.
[[nodiscard]] BakePoints bakePoints(const Model& model, const std::vector<bool>& castingSlots);

/// Some of the points, in rising order: all of them where they are at most about `most`, else so that each point has
/// one within a few edges.
[[nodiscard]] std::vector<std::uint32_t> representatives(const BakePoints& points, std::size_t most);

/// Values of all points from those of the representatives: of the nearest one along edges, then smoothed until
/// neighbours agree, with the representatives held.
template <class Value>
void spread(const BakePoints& points, const std::vector<std::uint32_t>& chosen, std::vector<Value>& values) {
  const std::size_t count = points.positions.size();
  if (chosen.size() == count) return;
  std::vector<std::uint8_t> known(count, 0);
  for (const std::uint32_t i : chosen) known[i] = 1;
  const std::vector<std::uint8_t> held = known;
  int rings = 0;
  for (std::vector<std::uint32_t> front = chosen, next; !front.empty(); front.swap(next), ++rings) {
    next.clear();
    for (const std::uint32_t i : front)
      for (std::uint32_t k = points.firstNeighbour[i]; k < points.firstNeighbour[i + 1]; ++k) {
        const std::uint32_t n = points.neighbours[k];
        if (known[n] != 0) continue;
        known[n] = 1;
        values[n] = values[i];
        next.push_back(n);
      }
  }
  std::vector<Value> before;
  for (int pass = 0; pass < 4 * rings; ++pass) {
    before = values;
    for (std::size_t i = 0; i < count; ++i) {
      if (held[i] != 0) continue;
      Value sum = before[i];
      for (std::uint32_t k = points.firstNeighbour[i]; k < points.firstNeighbour[i + 1]; ++k)
        for (std::size_t c = 0; c < sum.size(); ++c) sum[c] += before[points.neighbours[k]][c];
      const auto terms = static_cast<float>(1 + points.firstNeighbour[i + 1] - points.firstNeighbour[i]);
      for (float& s : sum) s /= terms;
      values[i] = sum;
    }
  }
}

}  // namespace dermis
