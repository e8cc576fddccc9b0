// A closed triangle mesh whose edges can be split, collapsed and flipped.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "core/builtin/head/polygonise.h"

namespace dermis::sculpt {

/// Half-edge 3t + i runs from corner i of triangle t to the next. Vertices keep their numbers until compacted().
class HalfEdges {
 public:
  static constexpr std::uint32_t kNone = 0xFFFFFFFFU;

  /// The surface must be closed: every edge between two triangles.
  explicit HalfEdges(const Surface& surface);
  /// Without what was collapsed, vertices and triangles in the order they had.
  [[nodiscard]] Surface compacted() const;

  std::vector<glm::vec3> points;

  [[nodiscard]] std::uint32_t count() const { return static_cast<std::uint32_t>(m_origin.size()); }
  [[nodiscard]] bool alive(std::uint32_t h) const { return m_origin[h] != kNone; }
  [[nodiscard]] bool vertexAlive(std::uint32_t v) const { return m_leaving[v] != kNone; }
  [[nodiscard]] static std::uint32_t next(std::uint32_t h) { return h % 3 == 2 ? h - 2 : h + 1; }
  [[nodiscard]] static std::uint32_t previous(std::uint32_t h) { return h % 3 == 0 ? h + 2 : h - 1; }
  [[nodiscard]] std::uint32_t twin(std::uint32_t h) const { return m_twin[h]; }
  [[nodiscard]] std::uint32_t from(std::uint32_t h) const { return m_origin[h]; }
  [[nodiscard]] std::uint32_t to(std::uint32_t h) const { return m_origin[next(h)]; }
  /// The corner across from h in its triangle.
  [[nodiscard]] std::uint32_t across(std::uint32_t h) const { return m_origin[previous(h)]; }

  /// Calls visit(h) for every half-edge that leaves v.
  template <class Visit>
  void round(std::uint32_t v, const Visit& visit) const {
    const std::uint32_t first = m_leaving[v];
    std::uint32_t h = first;
    do {
      visit(h);
      h = m_twin[previous(h)];
    } while (h != first);
  }
  [[nodiscard]] int valence(std::uint32_t v) const;
  [[nodiscard]] bool adjacent(std::uint32_t a, std::uint32_t b) const;

  /// A new vertex in the middle of h; its number.
  std::uint32_t split(std::uint32_t h);
  /// True where from(h) can join to(h) and leave a manifold: they share two neighbours, which keep three of their own
  /// (the link condition, Dey et al. 1999, "Topology preserving edge contraction").
  [[nodiscard]] bool canCollapse(std::uint32_t h) const;
  /// from(h) joins to(h).
  void collapse(std::uint32_t h);
  /// The edge runs between the corners across from it.
  void flip(std::uint32_t h);

 private:
  void pair(std::uint32_t a, std::uint32_t b);
  std::vector<std::uint32_t> m_origin, m_twin;
  std::vector<std::uint32_t> m_leaving;  ///< of each vertex, one half-edge
};

}  // namespace dermis::sculpt
