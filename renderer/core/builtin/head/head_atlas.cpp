// Triangles into texels.
#include <algorithm>
#include <array>
#include <cmath>

#include "core/builtin/head/head.h"

namespace dermis {
namespace {

constexpr std::uint8_t kInside = 2, kBeyond = 1;

float cross(const glm::vec2& a, const glm::vec2& b) { return a.x * b.y - a.y * b.x; }

class Rasteriser {
 public:
  Rasteriser(const Head& head, int size) : m_head(head) {
    m_atlas.size = size;
    const auto texels = static_cast<std::size_t>(size) * static_cast<std::size_t>(size);
    m_atlas.rest.resize(texels);
    m_atlas.normals.resize(texels);
    m_atlas.covered.resize(texels);
    m_atlas.millimetresPerTexel = head.millimetresPerUv / static_cast<float>(size);
  }
  HeadAtlas run(int gutter) {
    const ModelPart& face = m_head.model.parts.front();
    for (std::uint32_t i = 0; i < face.indexCount; i += 3) fill(&m_head.model.indices[face.firstIndex + i]);
    for (int i = 0; i < gutter; ++i) grow();
    return std::move(m_atlas);
  }

 private:
  [[nodiscard]] std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(m_atlas.size) + static_cast<std::size_t>(x);
  }
  /// A texel is in the triangle that holds its middle.
  void fill(const std::uint32_t* corner) {
    const auto size = static_cast<float>(m_atlas.size);
    std::array<glm::vec2, 3> p{};
    for (std::size_t i = 0; i < 3; ++i) {
      const glm::vec2 uv = m_head.model.uvs[corner[i]];
      p[i] = {uv.x * size - 0.5F, (1.0F - uv.y) * size - 0.5F};
    }
    const float area = cross(p[1] - p[0], p[2] - p[0]);
    if (area == 0.0F) return;
    const glm::vec2 low = glm::ceil(glm::min(p[0], glm::min(p[1], p[2]))),
                    high = glm::floor(glm::max(p[0], glm::max(p[1], p[2])));
    for (int y = std::max(0, static_cast<int>(low.y)); y <= std::min(m_atlas.size - 1, static_cast<int>(high.y)); ++y)
      for (int x = std::max(0, static_cast<int>(low.x)); x <= std::min(m_atlas.size - 1, static_cast<int>(high.x));
           ++x) {
        const glm::vec2 at(x, y);
        const float b = cross(at - p[0], p[2] - p[0]) / area, c = cross(p[1] - p[0], at - p[0]) / area,
                    a = 1.0F - b - c;
        constexpr float kOnEdge = -1e-4F;
        if (std::min({a, b, c}) < kOnEdge) continue;
        const std::size_t i = index(x, y);
        m_atlas.rest[i] = a * m_head.rest[corner[0]] + b * m_head.rest[corner[1]] + c * m_head.rest[corner[2]];
        m_atlas.normals[i] = glm::normalize(a * m_head.restNormals[corner[0]] + b * m_head.restNormals[corner[1]] +
                                            c * m_head.restNormals[corner[2]]);
        m_atlas.covered[i] = kInside;
      }
  }
  /// One ring of texels more, each as its first covered neighbour.
  void grow() {
    const std::vector<std::uint8_t> before = m_atlas.covered;
    for (int y = 0; y < m_atlas.size; ++y)
      for (int x = 0; x < m_atlas.size; ++x) {
        const std::size_t i = index(x, y);
        if (before[i] != 0) continue;
        for (const glm::ivec2 off : {glm::ivec2(-1, 0), {1, 0}, {0, -1}, {0, 1}, {-1, -1}, {1, -1}, {-1, 1}, {1, 1}}) {
          const int nx = x + off.x, ny = y + off.y;
          if (std::min(nx, ny) < 0 || std::max(nx, ny) >= m_atlas.size || before[index(nx, ny)] == 0) continue;
          m_atlas.rest[i] = m_atlas.rest[index(nx, ny)];
          m_atlas.normals[i] = m_atlas.normals[index(nx, ny)];
          m_atlas.covered[i] = kBeyond;
          break;
        }
      }
  }

  const Head& m_head;
  HeadAtlas m_atlas;
};

}  // namespace

HeadAtlas rasteriseHead(const Head& head, int size, int gutter) { return Rasteriser(head, size).run(gutter); }

}  // namespace dermis
