#include "core/builtin/head/pack.h"

#include <algorithm>
#include <array>
#include <bitset>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

namespace dermis::sculpt {
namespace {

constexpr int kGrid = 512;
using Row = std::bitset<kGrid>;

/// Cells that a piece covers, grown by one cell all round.
struct Mask {
  int width = 0, height = 0;
  std::vector<Row> rows;
  glm::vec2 low{0.0F};  ///< of the piece, in cells
};

bool overlaps(const std::array<glm::vec2, 3>& triangle, const glm::vec2& low, const glm::vec2& high) {
  // Separating axes: the cell's two were the triangle's box; here the triangle's three.
  for (std::size_t i = 0; i < 3; ++i) {
    const glm::vec2 edge = triangle[(i + 1) % 3] - triangle[i], normal(-edge.y, edge.x);
    const glm::vec2 inmost(normal.x > 0.0F ? high.x : low.x, normal.y > 0.0F ? high.y : low.y);
    if (glm::dot(inmost - triangle[i], normal) < 0.0F) return false;
  }
  return true;
}

std::optional<Mask> maskOf(const FlatPiece& piece, float cellsPerMillimetre) {
  Mask mask;
  glm::vec2 low(std::numeric_limits<float>::max()), high(std::numeric_limits<float>::lowest());
  for (const glm::vec2& p : piece.points) {
    low = glm::min(low, p * cellsPerMillimetre);
    high = glm::max(high, p * cellsPerMillimetre);
  }
  mask.low = low - 1.0F;
  mask.width = static_cast<int>(std::ceil(high.x - low.x)) + 2;
  mask.height = static_cast<int>(std::ceil(high.y - low.y)) + 2;
  if (mask.width > kGrid || mask.height > kGrid) return std::nullopt;
  std::vector<Row> bare(static_cast<std::size_t>(mask.height));
  for (const glm::uvec3& t : piece.triangles) {
    std::array<glm::vec2, 3> corners{};
    for (int i = 0; i < 3; ++i)
      corners[static_cast<std::size_t>(i)] = piece.points[t[i]] * cellsPerMillimetre - mask.low;
    const glm::vec2 first = glm::floor(glm::min(corners[0], glm::min(corners[1], corners[2])));
    const glm::vec2 last = glm::floor(glm::max(corners[0], glm::max(corners[1], corners[2])));
    for (float y = first.y; y <= last.y; ++y)
      for (float x = first.x; x <= last.x; ++x)
        if (overlaps(corners, {x, y}, {x + 1.0F, y + 1.0F}))
          bare[static_cast<std::size_t>(y)].set(static_cast<std::size_t>(x));
  }
  mask.rows.resize(bare.size());
  for (std::size_t y = 0; y < bare.size(); ++y)
    for (std::size_t n = y == 0 ? 0 : y - 1; n <= std::min(y + 1, bare.size() - 1); ++n)
      mask.rows[y] |= bare[n] | bare[n] << 1 | bare[n] >> 1;
  return mask;
}

std::size_t rowIndex(int y, int row) { return static_cast<std::size_t>(y) + static_cast<std::size_t>(row); }
Row shifted(const Mask& mask, int row, int x) {
  return mask.rows[static_cast<std::size_t>(row)] << static_cast<std::size_t>(x);
}

std::optional<glm::ivec2> place(const Mask& mask, std::vector<Row>& taken) {
  for (int y = 0; y + mask.height <= kGrid; ++y)
    for (int x = 0; x + mask.width <= kGrid; ++x) {
      bool free = true;
      for (int r = 0; free && r < mask.height; ++r) free = (shifted(mask, r, x) & taken[rowIndex(y, r)]).none();
      if (!free) continue;
      for (int r = 0; r < mask.height; ++r) taken[rowIndex(y, r)] |= shifted(mask, r, x);
      return glm::ivec2(x, y);
    }
  return std::nullopt;
}

std::optional<Packing> packAt(const std::vector<FlatPiece>& pieces, float cellsPerMillimetre) {
  std::vector<Mask> masks;
  for (const FlatPiece& piece : pieces) {
    std::optional<Mask> mask = maskOf(piece, cellsPerMillimetre);
    if (!mask) return std::nullopt;
    masks.push_back(std::move(*mask));
  }
  std::vector<std::size_t> order(pieces.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return masks[a].width * masks[a].height > masks[b].width * masks[b].height;
  });
  std::vector<Row> taken(kGrid);
  Packing packing;
  packing.uvPerMillimetre = cellsPerMillimetre / kGrid;
  packing.offsets.resize(pieces.size());
  for (const std::size_t i : order) {
    const std::optional<glm::ivec2> at = place(masks[i], taken);
    if (!at) return std::nullopt;
    packing.offsets[i] = (glm::vec2(*at) - masks[i].low) / static_cast<float>(kGrid);
  }
  return packing;
}

}  // namespace

Packing pack(const std::vector<FlatPiece>& pieces) {
  // Between nothing fitting and everything: 14 halvings leave a ten-thousandth.
  double area = 0.0;
  for (const FlatPiece& piece : pieces)
    for (const glm::uvec3& t : piece.triangles) {
      const glm::vec2 a = piece.points[t.y] - piece.points[t.x], b = piece.points[t.z] - piece.points[t.x];
      area += 0.5 * std::abs(static_cast<double>(a.x * b.y - a.y * b.x));
    }
  auto high = static_cast<float>(kGrid / std::sqrt(std::max(area, 1e-6))), low = 0.0F;
  Packing best;
  for (int i = 0; i < 14; ++i) {
    const float middle = 0.5F * (low + high);
    if (const std::optional<Packing> packing = packAt(pieces, middle)) {
      best = *packing;
      low = middle;
    } else {
      high = middle;
    }
  }
  return best;
}

}  // namespace dermis::sculpt
