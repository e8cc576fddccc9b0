#include "core/builtin/head/polygonise.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "core/bake/parallel.h"

namespace dermis::sculpt {
namespace {

constexpr int kBlock = 8;  // lattice points a side
constexpr int kBlockPoints = kBlock * kBlock * kBlock;

/// Corner c of a cell lies at (c & 1, c >> 1 & 1, c >> 2).
constexpr std::array<std::array<int, 2>, 12> kEdges = {
    {{0, 1}, {2, 3}, {4, 5}, {6, 7}, {0, 2}, {1, 3}, {4, 6}, {5, 7}, {0, 4}, {1, 5}, {2, 6}, {3, 7}}};
/// Counter-clockwise seen from outside the cell.
constexpr std::array<std::array<int, 4>, 6> kFaces = {
    {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};

int edgeBetween(int a, int b) {
  const std::array<int, 2> wanted = {std::min(a, b), std::max(a, b)};
  return static_cast<int>(std::find(kEdges.begin(), kEdges.end(), wanted) - kEdges.begin());
}

using Polygon = std::vector<int>;  // of edges

/// The polygons of a cell whose corners are inside as the bits of `inside` say: on each face, an edge where a run of
/// inside corners begins is joined to the one where it ends.
std::vector<Polygon> polygonsOf(int inside) {
  std::array<int, 12> next{};
  next.fill(-1);
  for (const auto& face : kFaces)
    for (std::size_t i = 0; i < 4; ++i) {
      const auto in = [&](std::size_t k) { return (inside >> face[k % 4] & 1) != 0; };
      if (in(i) || !in(i + 1)) continue;
      std::size_t last = i + 1;
      while (in(last + 1)) ++last;
      next[static_cast<std::size_t>(edgeBetween(face[i], face[(i + 1) % 4]))] =
          edgeBetween(face[last % 4], face[(last + 1) % 4]);
    }
  std::vector<Polygon> polygons;
  std::array<bool, 12> used{};
  for (std::size_t first = 0; first < 12; ++first) {
    if (next[first] < 0 || used[first]) continue;
    Polygon polygon;
    for (auto e = static_cast<int>(first); !used[static_cast<std::size_t>(e)]; e = next[static_cast<std::size_t>(e)]) {
      used[static_cast<std::size_t>(e)] = true;
      polygon.push_back(e);
    }
    polygons.push_back(std::move(polygon));
  }
  return polygons;
}

/// Values at the lattice's points, kept only where the surface may be.
class Samples {
 public:
  Samples(const std::function<float(const glm::vec3&)>& distance, const Lattice& lattice) : m_lattice(lattice) {
    for (int axis = 0; axis < 3; ++axis) {
      m_counts[axis] = static_cast<int>(lattice.planes[static_cast<std::size_t>(axis)].size());
      m_blocks[axis] = (m_counts[axis] + kBlock - 1) / kBlock;
    }
    const auto count = static_cast<std::size_t>(m_blocks.x) * static_cast<std::size_t>(m_blocks.y) *
                       static_cast<std::size_t>(m_blocks.z);
    m_sign.resize(count);
    m_values.resize(count);
    forPieces(
        count, 16, {},
        [&](std::size_t begin, std::size_t end) {
          for (std::size_t block = begin; block < end; ++block) sample(block, distance);
        },
        [](float) {});
  }
  [[nodiscard]] const glm::ivec3& counts() const { return m_counts; }
  [[nodiscard]] const glm::ivec3& blocks() const { return m_blocks; }
  [[nodiscard]] bool kept(const glm::ivec3& block) const { return !m_values[blockIndex(block)].empty(); }
  [[nodiscard]] float at(const glm::ivec3& p) const {
    const glm::ivec3 block = p / kBlock, in = p - block * kBlock;
    const std::size_t index = blockIndex(block);
    if (m_values[index].empty()) return m_sign[index];
    const int point = (in.z * kBlock + in.y) * kBlock + in.x;
    return m_values[index][static_cast<std::size_t>(point)];
  }
  [[nodiscard]] glm::vec3 place(const glm::ivec3& p) const { return {plane(0, p.x), plane(1, p.y), plane(2, p.z)}; }

 private:
  [[nodiscard]] std::size_t blockIndex(const glm::ivec3& b) const {
    const int block = (b.z * m_blocks.y + b.y) * m_blocks.x + b.x;
    return static_cast<std::size_t>(block);
  }
  [[nodiscard]] float plane(std::size_t axis, int i) const {
    const std::vector<float>& planes = m_lattice.planes[axis];
    return planes[std::min(static_cast<std::size_t>(i), planes.size() - 1)];
  }
  void sample(std::size_t block, const std::function<float(const glm::vec3&)>& distance) {
    constexpr float kSteepest = 1.7F, kMargin = 2.5F;  // what distance may exceed the true one by
    const auto i = static_cast<int>(block);
    const glm::ivec3 first =
        glm::ivec3(i % m_blocks.x, i / m_blocks.x % m_blocks.y, i / m_blocks.x / m_blocks.y) * kBlock;
    const glm::vec3 low = place(first), high = place(first + kBlock);
    const float middle = distance(0.5F * (low + high));
    m_sign[block] = middle < 0.0F ? -1.0F : 1.0F;
    if (std::abs(middle) > kSteepest * 0.5F * glm::distance(low, high) + kMargin) return;
    m_values[block].resize(kBlockPoints);
    std::size_t at = 0;
    for (int z = 0; z < kBlock; ++z)
      for (int y = 0; y < kBlock; ++y)
        for (int x = 0; x < kBlock; ++x) m_values[block][at++] = distance(place(first + glm::ivec3(x, y, z)));
  }

  const Lattice& m_lattice;
  glm::ivec3 m_counts{0}, m_blocks{0};
  std::vector<float> m_sign;
  std::vector<std::vector<float>> m_values;
};

class Marcher {
 public:
  explicit Marcher(const Samples& samples) : m_samples(samples) {
    for (int inside = 0; inside < 256; ++inside) m_table[static_cast<std::size_t>(inside)] = polygonsOf(inside);
  }
  Surface march() {
    const glm::ivec3 blocks = m_samples.blocks();
    for (int z = 0; z < blocks.z; ++z)
      for (int y = 0; y < blocks.y; ++y)
        for (int x = 0; x < blocks.x; ++x)
          if (m_samples.kept({x, y, z})) marchBlock(glm::ivec3(x, y, z) * kBlock);
    return std::move(m_surface);
  }

 private:
  void marchBlock(const glm::ivec3& first) {
    const glm::ivec3 end = glm::min(first + kBlock, m_samples.counts() - 1);
    for (int z = first.z; z < end.z; ++z)
      for (int y = first.y; y < end.y; ++y)
        for (int x = first.x; x < end.x; ++x) cell({x, y, z});
  }
  void cell(const glm::ivec3& origin) {
    int inside = 0;
    for (int c = 0; c < 8; ++c) inside |= m_samples.at(corner(origin, c)) < 0.0F ? 1 << c : 0;
    for (const Polygon& polygon : m_table[static_cast<std::size_t>(inside)]) {
      std::vector<std::uint32_t> loop;
      for (const int edge : polygon) loop.push_back(vertexOn(origin, edge));
      fill(loop);
    }
  }
  void fill(const std::vector<std::uint32_t>& loop) {
    // A longer loop may pass one face twice, where a diagonal could be the neighbour's too: it gets a middle.
    if (loop.size() < 6) {
      for (std::size_t i = 1; i + 1 < loop.size(); ++i) m_surface.triangles.emplace_back(loop[0], loop[i], loop[i + 1]);
      return;
    }
    glm::vec3 middle(0.0F);
    for (const std::uint32_t v : loop) middle += m_surface.points[v] / static_cast<float>(loop.size());
    const auto centre = static_cast<std::uint32_t>(m_surface.points.size());
    m_surface.points.push_back(middle);
    for (std::size_t i = 0; i < loop.size(); ++i)
      m_surface.triangles.emplace_back(centre, loop[i], loop[(i + 1) % loop.size()]);
  }
  static glm::ivec3 corner(const glm::ivec3& origin, int c) { return origin + glm::ivec3(c & 1, c >> 1 & 1, c >> 2); }
  std::uint32_t vertexOn(const glm::ivec3& origin, int edge) {
    const auto& ends = kEdges[static_cast<std::size_t>(edge)];
    const glm::ivec3 a = corner(origin, ends[0]), b = corner(origin, ends[1]);
    const glm::ivec3 n = m_samples.counts();
    const std::uint64_t point =
        (static_cast<std::uint64_t>(a.z) * static_cast<std::uint64_t>(n.y) + static_cast<std::uint64_t>(a.y)) *
            static_cast<std::uint64_t>(n.x) +
        static_cast<std::uint64_t>(a.x);
    const auto [at, isNew] = m_vertices.try_emplace(point * 3U + static_cast<std::uint64_t>(edge / 4),
                                                    static_cast<std::uint32_t>(m_surface.points.size()));
    if (isNew) {
      constexpr float kOffCorner = 0.05F;  // of the edge: no two vertices of a cell fall together
      const float va = m_samples.at(a), vb = m_samples.at(b);
      const float t = glm::clamp(va / (va - vb), kOffCorner, 1.0F - kOffCorner);
      m_surface.points.push_back(glm::mix(m_samples.place(a), m_samples.place(b), t));
    }
    return at->second;
  }

  const Samples& m_samples;
  std::array<std::vector<Polygon>, 256> m_table;
  std::unordered_map<std::uint64_t, std::uint32_t> m_vertices;
  Surface m_surface;
};

}  // namespace

Surface polygonise(const std::function<float(const glm::vec3&)>& distance, const Lattice& lattice) {
  const Samples samples(distance, lattice);
  return Marcher(samples).march();
}

}  // namespace dermis::sculpt
