#include "core/bake/bake_points.h"

#include <algorithm>
#include <array>
#include <bit>
#include <unordered_map>
#include <utility>

namespace dermis {
namespace {

using Key = std::array<std::uint32_t, 6>;

struct KeyHash {
  std::size_t operator()(const Key& key) const {
    std::uint64_t h = 0x9E3779B97F4A7C15U;
    for (const std::uint32_t word : key) h = (h ^ word) * 0xFF51AFD7ED558CCDU, h ^= h >> 32U;
    return h;
  }
};

Key keyOf(const glm::vec3& p, const glm::vec3& n) {
  // + 0 makes −0 and 0 one.
  return {std::bit_cast<std::uint32_t>(p.x + 0.0F), std::bit_cast<std::uint32_t>(p.y + 0.0F),
          std::bit_cast<std::uint32_t>(p.z + 0.0F), std::bit_cast<std::uint32_t>(n.x + 0.0F),
          std::bit_cast<std::uint32_t>(n.y + 0.0F), std::bit_cast<std::uint32_t>(n.z + 0.0F)};
}

void connect(BakePoints& points, const std::vector<glm::uvec2>& edges) {
  points.firstNeighbour.assign(points.positions.size() + 1, 0);
  for (const glm::uvec2& e : edges) ++points.firstNeighbour[e.x + 1];
  for (std::size_t i = 1; i < points.firstNeighbour.size(); ++i)
    points.firstNeighbour[i] += points.firstNeighbour[i - 1];
  points.neighbours.resize(edges.size());
  std::vector<std::uint32_t> next(points.firstNeighbour.begin(), points.firstNeighbour.end() - 1);
  for (const glm::uvec2& e : edges) points.neighbours[next[e.x]++] = e.y;
}

/// Points on a hard edge look from a little beside it: a ray inwards from the edge itself runs along the next face, and
/// a slab of eight vertices would have no thickness.
void leaveHardEdges(BakePoints& points) {
  std::unordered_map<Key, int, KeyHash> pointsAt;
  for (const glm::vec3& position : points.positions) ++pointsAt[keyOf(position, glm::vec3(0.0F))];
  std::vector<glm::vec3> moved = points.positions;
  for (std::size_t i = 0; i < moved.size(); ++i) {
    const std::uint32_t begin = points.firstNeighbour[i], end = points.firstNeighbour[i + 1];
    if (begin == end || pointsAt[keyOf(points.positions[i], glm::vec3(0.0F))] < 2) continue;
    glm::vec3 mean(0.0F);
    for (std::uint32_t k = begin; k < end; ++k) mean += points.positions[points.neighbours[k]];
    const glm::vec3 towards = mean / static_cast<float>(end - begin) - points.positions[i];
    constexpr float kShare = 0.1F;
    moved[i] += kShare * (towards - points.normals[i] * glm::dot(towards, points.normals[i]));
  }
  points.positions = std::move(moved);
}

}  // namespace

BakePoints bakePoints(const Model& model, const std::vector<bool>& castingSlots) {
  BakePoints points;
  points.ofVertex.assign(model.positions.size(), BakePoints::kNone);
  std::unordered_map<Key, std::uint32_t, KeyHash> known;
  known.reserve(model.positions.size());
  std::vector<glm::uvec2> edges;
  for (const ModelPart& part : model.parts) {
    if (part.slot < castingSlots.size() && !castingSlots[part.slot]) continue;
    for (std::uint32_t i = part.firstIndex; i < part.firstIndex + part.indexCount; ++i) {
      const std::uint32_t vertex = model.indices[i];
      if (points.ofVertex[vertex] != BakePoints::kNone) continue;
      const auto [it, added] = known.try_emplace(keyOf(model.positions[vertex], model.normals[vertex]),
                                                 static_cast<std::uint32_t>(points.positions.size()));
      if (added) {
        points.positions.push_back(model.positions[vertex]);
        points.normals.push_back(model.normals[vertex]);
      }
      points.ofVertex[vertex] = it->second;
    }
    for (std::uint32_t i = part.firstIndex; i + 2 < part.firstIndex + part.indexCount; i += 3)
      for (std::uint32_t c = 0; c < 3; ++c) {
        const std::uint32_t a = points.ofVertex[model.indices[i + c]];
        const std::uint32_t b = points.ofVertex[model.indices[i + (c + 1) % 3]];
        if (a == b) continue;
        edges.emplace_back(a, b);
        edges.emplace_back(b, a);
      }
  }
  connect(points, edges);
  leaveHardEdges(points);
  return points;
}

std::vector<std::uint32_t> representatives(const BakePoints& points, std::size_t most) {
  const std::size_t count = points.positions.size();
  std::vector<std::uint32_t> chosen;
  // Every point whose neighbours within `rings` edges haven't been chosen; a wider reach until they are few enough.
  for (int rings = 0;; ++rings) {
    chosen.clear();
    std::vector<std::uint8_t> covered(count, 0);
    std::vector<std::uint32_t> seenFrom(count, BakePoints::kNone), front, next;
    for (std::uint32_t i = 0; i < count; ++i) {
      if (covered[i] != 0) continue;
      chosen.push_back(i);
      covered[i] = 1;
      front = {i};
      for (int ring = 0; ring < rings; ++ring, front.swap(next)) {
        next.clear();
        for (const std::uint32_t f : front)
          for (std::uint32_t k = points.firstNeighbour[f]; k < points.firstNeighbour[f + 1]; ++k) {
            const std::uint32_t n = points.neighbours[k];
            covered[n] = 1;
            if (std::exchange(seenFrom[n], i) != i) next.push_back(n);
          }
      }
    }
    constexpr int kMostRings = 8;
    if (chosen.size() <= std::max<std::size_t>(most, 1) || rings == kMostRings) return chosen;
  }
}

}  // namespace dermis
