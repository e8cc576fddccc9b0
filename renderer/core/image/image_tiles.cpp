#include "core/image/image_tiles.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/base/half.h"
#include "core/image/comparison.h"

namespace dermis {

namespace {

/// How far past an edge a place may lie by rounding.
constexpr float kEdge = 1e-4F;

void store(Image& image, std::size_t index, float value) {
  std::byte* at = image.pixels.data() + index * bytesPerChannel(image.type);
  std::uint16_t word = 0;
  switch (image.type) {
    case PixelType::U8:
      *at = static_cast<std::byte>(std::lround(value * 255.0F));
      return;
    case PixelType::U16:
      word = static_cast<std::uint16_t>(std::lround(value * 65535.0F));
      break;
    case PixelType::Half:
      word = halfOf(value);
      break;
    case PixelType::Float:
      std::memcpy(at, &value, sizeof value);
      return;
  }
  std::memcpy(at, &word, sizeof word);
}

/// The two pixels along one side that a new one lies between, and the share of the second.
struct Between {
  std::size_t low, high;
  float share;
};
Between between(int at, int size, int from) {
  const float place = (static_cast<float>(at) + 0.5F) * static_cast<float>(from) / static_cast<float>(size) - 0.5F;
  const float low = std::clamp(std::floor(place), 0.0F, static_cast<float>(from - 1));
  const auto first = static_cast<std::size_t>(low);
  return {first, std::min(first + 1, static_cast<std::size_t>(from - 1)), std::clamp(place - low, 0.0F, 1.0F)};
}

}  // namespace

glm::ivec2 udimSquare(int number) {
  return {(number - kFirstUdim) % kUdimsPerRow, (number - kFirstUdim) / kUdimsPerRow};
}

std::optional<int> udimNumber(glm::ivec2 square) {
  const int number = kFirstUdim + square.x + kUdimsPerRow * square.y;
  if (square.x < 0 || square.x >= kUdimsPerRow || square.y < 0 || number > kLastUdim) return std::nullopt;
  return number;
}

int tileHeight(const Image& image) {
  return image.height / static_cast<int>(std::max<std::size_t>(image.tiles.size(), 1));
}

std::optional<std::size_t> tileIndex(const Image& set, glm::ivec2 square) {
  const auto number = udimNumber(square);
  if (!number) return std::nullopt;
  const auto found = std::lower_bound(set.tiles.begin(), set.tiles.end(), *number);
  if (found == set.tiles.end() || *found != *number) return std::nullopt;
  return static_cast<std::size_t>(found - set.tiles.begin());
}

Image tileOf(const Image& set, std::size_t index) {
  Image tile;
  tile.width = set.width;
  tile.height = tileHeight(set);
  tile.channels = set.channels;
  tile.type = set.type;
  tile.name = set.name;
  const std::size_t bytes = set.rowBytes() * static_cast<std::size_t>(tile.height);
  tile.pixels.assign({set.pixels.data() + index * bytes, bytes});
  return tile;
}

std::array<std::uint32_t, 4> tileBits(const Image& image) {
  std::array<std::uint32_t, 4> bits{};
  for (const int number : image.tiles) {
    const auto at = static_cast<std::size_t>(number - kFirstUdim);
    bits.at(at / 32) |= std::uint32_t{1} << (at % 32);
  }
  return bits;
}

std::optional<TilePlace> tilePlace(const Image& set, glm::vec2 uv) {
  // Edges that rounding has moved: first as it is, then a touch lower, then a touch higher.
  for (const float nudge : {0.0F, -kEdge, kEdge}) {
    const glm::vec2 square = glm::floor(uv + nudge);
    if (const auto index = tileIndex(set, glm::ivec2(square)))
      return TilePlace{*index, glm::clamp(uv - square, 0.0F, 1.0F)};
  }
  return std::nullopt;
}

Image resampled(const Image& image, int width, int height) {
  Image out;
  out.width = width;
  out.height = height;
  out.channels = image.channels;
  out.type = image.type;
  out.name = image.name;
  out.pixels.resize(out.rowBytes() * static_cast<std::size_t>(height));
  const auto channels = static_cast<std::size_t>(image.channels);
  const auto stride = static_cast<std::size_t>(image.width);
  for (std::size_t c = 0; c < channels; ++c) {
    const bool alpha = channels % 2 == 0 && c + 1 == channels;
    const std::vector<float> values = channelValues(image, alpha ? 3 : static_cast<int>(c));
    for (int y = 0; y < height; ++y) {
      const Between v = between(y, height, image.height);
      for (int x = 0; x < width; ++x) {
        const Between u = between(x, width, image.width);
        const float above = glm::mix(values[v.low * stride + u.low], values[v.low * stride + u.high], u.share);
        const float below = glm::mix(values[v.high * stride + u.low], values[v.high * stride + u.high], u.share);
        const std::size_t pixel =
            static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
        store(out, pixel * channels + c, glm::mix(above, below, v.share));
      }
    }
  }
  return out;
}

}  // namespace dermis
