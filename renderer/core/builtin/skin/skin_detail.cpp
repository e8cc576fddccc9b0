#include "core/builtin/skin/skin_detail.h"

#include <algorithm>
#include <cmath>

#include "core/builtin/skin/noise.h"

namespace dermis::skin {
namespace {

constexpr int kSize = 512;
constexpr float kTexelMm = kDetailTileMm / kSize;

float bell(float x, float width) { return std::exp(-x * x / (width * width)); }

/// cells() in a plane that repeats every `period` cells, 0.9 of a cell's freedom for each feature point.
Cells tiledCells(const glm::vec2& p, int period, std::uint32_t seed) {
  const glm::ivec2 cell(glm::floor(p));
  Cells nearest{9.0F, 9.0F, 0U};
  for (int y = -1; y <= 1; ++y)
    for (int x = -1; x <= 1; ++x) {
      const glm::ivec2 at = cell + glm::ivec2(x, y);
      const glm::ivec2 same = ((at % period) + period) % period;
      const std::uint32_t hash = latticeHash({same, 0}, seed);
      const float distance = glm::distance(p, glm::vec2(at) + 0.05F + 0.9F * glm::vec2(unit(hash), unit(hash, 11)));
      if (distance < nearest.first)
        nearest = {distance, nearest.first, hash};
      else
        nearest.second = std::min(nearest.second, distance);
    }
  return {nearest.first, nearest.second, nearest.hash};
}

/// Millimetres. Furrows part plateaus of about a millimetre, finer ones part these again, and pores lie where it
/// pleases them (Piérard, Uhoda & Piérard-Franchimont 2003, "From skin microrelief to wrinkles").
float height(const glm::vec2& mm) {
  constexpr int kCoarse = 46, kFine = 96, kPores = 27;  // cells a tile
  const auto cell = [](int cells) { return kDetailTileMm / static_cast<float>(cells); };
  const Cells coarse = tiledCells(mm / cell(kCoarse), kCoarse, 11), fine = tiledCells(mm / cell(kFine), kFine, 12);
  float sum = -(0.014F + 0.031F * unit(coarse.hash, 3)) * bell((coarse.second - coarse.first) * cell(kCoarse), 0.13F) -
              0.015F * bell((fine.second - fine.first) * cell(kFine), 0.10F);
  const Cells pore = tiledCells(mm / cell(kPores), kPores, 13);
  const float size = unit(pore.hash, 7);
  sum -= (0.03F + 0.09F * size * size) * bell(pore.first * cell(kPores), 0.12F + 0.10F * size);
  return sum;
}

}  // namespace

Image makeSkinDetail() {
  constexpr auto kSide = static_cast<std::size_t>(kSize);
  std::vector<float> heights(kSide * kSide);
  for (std::size_t i = 0; i < heights.size(); ++i)
    heights[i] = height(kTexelMm * (glm::vec2(i % kSide, i / kSide) + 0.5F));
  const auto at = [&](std::size_t x, std::size_t y) { return heights[(y % kSide) * kSide + x % kSide]; };
  Image image;
  image.width = image.height = kSize;
  image.channels = 3;
  image.type = PixelType::U8;
  image.name = "builtin:skin_detail";
  image.pixels.reserve(3 * heights.size());
  for (std::size_t y = 0; y < kSide; ++y)
    for (std::size_t x = 0; x < kSide; ++x) {
      // Rows run downwards, v upwards.
      const glm::vec2 slope(at(x + 1, y) - at(x + kSide - 1, y), at(x, y + kSide - 1) - at(x, y + 1));
      const glm::vec3 normal = glm::normalize(glm::vec3(-slope / (2.0F * kTexelMm), 1.0F));
      for (int c = 0; c < 3; ++c)
        image.pixels.push_back(static_cast<std::byte>(std::lround(255.0F * (0.5F + 0.5F * normal[c]))));
    }
  return image;
}

}  // namespace dermis::skin
