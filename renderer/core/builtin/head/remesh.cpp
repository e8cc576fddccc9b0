#include "core/builtin/head/remesh.h"

#include <algorithm>
#include <cmath>

#include "core/bake/parallel.h"
#include "core/builtin/head/half_edges.h"

namespace dermis::sculpt {
namespace {

constexpr int kRounds = 5;
constexpr float kDelta = 0.3F;  // mm, for the skin's slope
/// Cosine of how far a step may turn a triangle from the skin.
constexpr float kLeastFacing = 0.5F;

class Remesher {
 public:
  Remesher(const Surface& surface, const Sculpt& sculpt, const EdgeLengths& lengths)
      : m_mesh(surface), m_sculpt(sculpt), m_lengths(lengths), m_normals(surface.points.size()) {}

  Surface run() {
    forVertices([&](std::uint32_t v) { m_normals[v] = unit(m_sculpt.slope(place(v), kDelta).gradient); });
    for (int round = 0; round < kRounds; ++round) {
      measure();
      collapseShort();
      if (round == 0) collapseShort();
      measure();
      splitLong();
      collapseShort();
      flipForValence();
      relax();
    }
    return m_mesh.compacted();
  }

 private:
  [[nodiscard]] glm::vec3 areaNormal(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) const {
    return glm::cross(b - a, c - a);
  }
  [[nodiscard]] const glm::vec3& place(std::uint32_t v) const { return m_mesh.points[v]; }
  [[nodiscard]] float length(std::uint32_t h) const {
    return glm::distance(place(m_mesh.from(h)), place(m_mesh.to(h)));
  }
  [[nodiscard]] float wanted(std::uint32_t a, std::uint32_t b) const { return std::min(m_wanted[a], m_wanted[b]); }

  template <class Work>
  void forVertices(const Work& work) {
    forPieces(
        m_mesh.points.size(), 512, {},
        [&](std::size_t begin, std::size_t end) {
          for (std::size_t v = begin; v < end; ++v)
            if (m_mesh.vertexAlive(static_cast<std::uint32_t>(v))) work(static_cast<std::uint32_t>(v));
        },
        [](float) {});
  }

  /// The edge length that the skin's bend and the place ask for.
  void measure() {
    m_wanted.resize(m_mesh.points.size());
    forVertices([&](std::uint32_t v) {
      float bend = 1e-6F;
      const float shortest = m_lengths.shortest(place(v));
      m_mesh.round(v, [&](std::uint32_t h) {
        const std::uint32_t to = m_mesh.to(h);
        bend = std::max(
            bend, glm::distance(m_normals[v], m_normals[to]) / std::max(glm::distance(place(v), place(to)), shortest));
      });
      // Dunyach et al., eq. 1: the edge of an equilateral triangle whose middle is `tolerance` off a sphere.
      const float e = m_lengths.tolerance;
      const float byBend = std::sqrt(std::max(6.0F * e / bend - 3.0F * e * e, 0.0F));
      m_wanted[v] = glm::clamp(byBend, shortest, std::max(shortest, m_lengths.longest(place(v))));
    });
    // Neighbouring edges differ by no more than a third of the way between them.
    constexpr float kGrading = 0.35F;
    for (int pass = 0; pass < 4; ++pass)
      for (std::uint32_t h = 0; h < m_mesh.count(); ++h) {
        if (!m_mesh.alive(h)) continue;
        float& here = m_wanted[m_mesh.to(h)];
        here = std::min(here, m_wanted[m_mesh.from(h)] + kGrading * length(h));
      }
  }
  [[nodiscard]] static glm::vec3 unit(const glm::vec3& gradient) {
    const float size = glm::length(gradient);
    return size > 1e-6F ? gradient / size : glm::vec3(0.0F, 1.0F, 0.0F);
  }

  void splitLong() {
    const std::uint32_t count = m_mesh.count();
    for (std::uint32_t h = 0; h < count; ++h) {
      if (!m_mesh.alive(h) || h > m_mesh.twin(h)) continue;
      const std::uint32_t a = m_mesh.from(h), b = m_mesh.to(h);
      const float size = wanted(a, b);
      if (length(h) <= 4.0F / 3.0F * size) continue;
      const std::uint32_t m = m_mesh.split(h);
      const Sculpt::Slope slope = m_sculpt.slope(m_mesh.points[m], kDelta);
      m_mesh.points[m] = slope.onSkin(m_mesh.points[m], 0.5F * size);
      m_normals.push_back(unit(slope.gradient));
      m_wanted.push_back(size);
    }
  }

  void collapseShort() {
    for (std::uint32_t h = 0; h < m_mesh.count(); ++h) {
      if (!m_mesh.alive(h)) continue;
      const std::uint32_t a = m_mesh.from(h), b = m_mesh.to(h);
      if (length(h) >= 0.8F * wanted(a, b) || !m_mesh.canCollapse(h) || !fits(a, b)) continue;
      m_mesh.collapse(h);
    }
  }
  /// Moving a to b makes no edge too long and turns no triangle over.
  [[nodiscard]] bool fits(std::uint32_t a, std::uint32_t b) const {
    bool good = true;
    m_mesh.round(a, [&](std::uint32_t h) {
      const std::uint32_t to = m_mesh.to(h), across = m_mesh.across(h);
      if (!good || to == b) return;
      good = glm::distance(place(to), place(b)) < 4.0F / 3.0F * wanted(to, b);
      if (good && across != b) good = staysUp(a, place(b), m_normals[b], to, across);
    });
    return good;
  }
  /// Cosine between a triangle and the skin at its corners; −1 without area.
  [[nodiscard]] float facing(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const glm::vec3& skin) const {
    const glm::vec3 normal = areaNormal(a, b, c);
    constexpr float kNoArea = 1e-3F;  // mm²
    const float area = glm::length(normal);
    return area < kNoArea ? -1.0F : glm::dot(normal, skin) / (area * std::max(glm::length(skin), 1e-6F));
  }
  /// The triangle (v, b, c) may get its corner v at `after`: it goes on facing outwards, or faces more so than before.
  [[nodiscard]] bool staysUp(std::uint32_t v, const glm::vec3& after, const glm::vec3& normalAfter, std::uint32_t b,
                             std::uint32_t c) const {
    const glm::vec3 others = m_normals[b] + m_normals[c];
    const float is = facing(after, place(b), place(c), normalAfter + others);
    return is > kLeastFacing || is > facing(place(v), place(b), place(c), m_normals[v] + others);
  }

  void flipForValence() {
    for (std::uint32_t h = 0; h < m_mesh.count(); ++h) {
      if (!m_mesh.alive(h) || h > m_mesh.twin(h)) continue;
      const std::uint32_t a = m_mesh.from(h), b = m_mesh.to(h), c = m_mesh.across(h), d = m_mesh.across(m_mesh.twin(h));
      const auto off = [&](std::uint32_t v, int change) { return std::abs(m_mesh.valence(v) + change - 6); };
      const int before = off(a, 0) + off(b, 0) + off(c, 0) + off(d, 0);
      const int after = off(a, -1) + off(b, -1) + off(c, 1) + off(d, 1);
      if (after >= before || m_mesh.valence(a) <= 3 || m_mesh.valence(b) <= 3 || m_mesh.adjacent(c, d)) continue;
      const glm::vec3 n0 = areaNormal(place(a), place(b), place(c)), n1 = areaNormal(place(b), place(a), place(d));
      const glm::vec3 m0 = areaNormal(place(d), place(c), place(a)), m1 = areaNormal(place(c), place(d), place(b));
      const auto agree = [](const glm::vec3& u, const glm::vec3& v) {
        constexpr float kCloselyFlat = 0.9F;
        return glm::dot(u, v) > kCloselyFlat * glm::length(u) * glm::length(v);
      };
      if (agree(n0, n1) && agree(m0, m1) && agree(m0, n0)) m_mesh.flip(h);
    }
  }

  /// Each vertex towards the middle of its neighbours, along the skin, then back onto it.
  void relax() {
    std::vector<glm::vec3> moved = m_mesh.points, normals = m_normals;
    forVertices([&](std::uint32_t v) {
      glm::vec3 middle(0.0F);
      float total = 0.0F;
      m_mesh.round(v, [&](std::uint32_t h) {
        // Neighbours with larger triangles pull harder, which keeps the grading.
        const std::uint32_t to = m_mesh.to(h);
        const float weight = 1.0F / m_wanted[to];
        middle += weight * place(to);
        total += weight;
      });
      const glm::vec3 off = middle / total - place(v);
      const glm::vec3 along = off - glm::dot(off, m_normals[v]) * m_normals[v];
      const float most = 0.4F * m_wanted[v];
      glm::vec3 p = place(v) + 0.7F * along;
      p = m_sculpt.slope(p, kDelta).onSkin(p, most);
      const Sculpt::Slope slope = m_sculpt.slope(p, kDelta);
      moved[v] = slope.onSkin(p, most);
      normals[v] = unit(slope.gradient);
    });
    for (std::uint32_t v = 0; v < moved.size(); ++v) {
      if (!m_mesh.vertexAlive(v)) continue;
      bool good = true;
      m_mesh.round(
          v, [&](std::uint32_t h) { good = good && staysUp(v, moved[v], normals[v], m_mesh.to(h), m_mesh.across(h)); });
      if (!good) continue;
      m_mesh.points[v] = moved[v];
      m_normals[v] = normals[v];
    }
  }

  HalfEdges m_mesh;
  const Sculpt& m_sculpt;
  const EdgeLengths& m_lengths;
  std::vector<glm::vec3> m_normals;
  std::vector<float> m_wanted;
};

}  // namespace

Surface remesh(const Surface& surface, const Sculpt& sculpt, const EdgeLengths& lengths) {
  return Remesher(surface, sculpt, lengths).run();
}

}  // namespace dermis::sculpt
