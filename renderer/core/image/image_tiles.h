// Sets of UDIM tiles as one image: a tile is the picture of one unit square of the texture coordinates. 1001 is the
// square at the origin, the next number the next square in u, ten to a row, the next row ten numbers on (Mari's
// numbering). Image::tiles says which there are; their pixels stand one below the other.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>

#include "core/image/image.h"

namespace dermis {

inline constexpr int kFirstUdim = 1001, kLastUdim = 1100, kUdimsPerRow = 10;

/// The square of a tile's number, and its inverse (none outside the ten by ten).
[[nodiscard]] glm::ivec2 udimSquare(int number);
[[nodiscard]] std::optional<int> udimNumber(glm::ivec2 square);

/// Rows of one tile; all rows of an image that is no set.
[[nodiscard]] int tileHeight(const Image& image);
/// Which of the tiles a square's is.
[[nodiscard]] std::optional<std::size_t> tileIndex(const Image& set, glm::ivec2 square);
/// A tile as an image of its own.
[[nodiscard]] Image tileOf(const Image& set, std::size_t index);
/// A bit for each tile there is, by number − 1001 from the lowest of the first; zeros for other images.
[[nodiscard]] std::array<std::uint32_t, 4> tileBits(const Image& image);

/// Where in a set a place is read: in which tile and where in it, 0..1 from the lower left. A place on the upper edge
/// of a tile, within rounding, is that tile's where the next is not there. The twin of tilePlace() in map_tiles.glsl.
struct TilePlace {
  std::size_t index = 0;
  glm::vec2 uv{0.0F};
};
[[nodiscard]] std::optional<TilePlace> tilePlace(const Image& set, glm::vec2 uv);

/// The same picture of another size, bilinear, the outermost pixels' middles kept from the edges as a GPU does.
[[nodiscard]] Image resampled(const Image& image, int width, int height);

}  // namespace dermis
