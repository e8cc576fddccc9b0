// A decoded image: flat, checked bytes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/image/pixel_bytes.h"

namespace dermis {

enum class PixelType : std::uint8_t { U8, U16, Half, Float };

[[nodiscard]] constexpr std::size_t bytesPerChannel(PixelType type) {
  return type == PixelType::U8 ? 1 : type == PixelType::Float ? 4 : 2;
}

/// Pixels row by row from the top, channels interleaved. The invariant that a loader establishes and everybody may
/// rely on: width, height ≥ 1, 1 ≤ channels ≤ 4, pixels.size() == width·height·channels·bytesPerChannel(type), and
/// height is a multiple of the number of tiles.
struct Image {
  int width = 0;
  int height = 0;
  int channels = 0;  ///< 1 grey, 2 grey + alpha, 3 RGB, 4 RGBA
  PixelType type = PixelType::U8;
  PixelBytes pixels;
  std::string name;  ///< the file's name, for messages
  /// Of a set of UDIM tiles their numbers, ascending: `height` is that of all, one below the other (image_tiles.h).
  std::vector<int> tiles = {};

  [[nodiscard]] bool isFloatingPoint() const { return type == PixelType::Half || type == PixelType::Float; }
  [[nodiscard]] std::size_t rowBytes() const {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(channels) * bytesPerChannel(type);
  }
};

/// One named layer of an image to be written: float RGB(A) or fewer channels, e.g. "normal" with suffixes R, G, B.
struct ImageLayer {
  std::string name;                   ///< empty for the beauty
  std::vector<std::string> channels;  ///< "R", "G", "B", "A" or "Z", …
  Image image;                        ///< Float, or U8/U16 for display formats; image.channels == channels.size()
};

}  // namespace dermis
