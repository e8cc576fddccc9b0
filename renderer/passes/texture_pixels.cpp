#include "passes/texture_pixels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <glm/gtc/packing.hpp>

#include "core/base/half.h"

namespace dermis {

namespace {

constexpr float kHalfMaximum = 65504.0F;

Image emptyLike(const Image& image, int width, int height, int channels, PixelType type) {
  Image out;
  out.width = width;
  out.height = height;
  out.channels = channels;
  out.type = type;
  out.name = image.name;
  out.pixels.resize(out.rowBytes() * static_cast<std::size_t>(height));
  return out;
}

float load(const Image& image, std::size_t index) {
  const std::byte* at = image.pixels.data() + index * bytesPerChannel(image.type);
  switch (image.type) {
    case PixelType::U8:
      return static_cast<float>(std::to_integer<unsigned>(*at)) / 255.0F;
    case PixelType::U16: {
      std::uint16_t value = 0;
      std::memcpy(&value, at, sizeof value);
      return static_cast<float>(value) / 65535.0F;
    }
    case PixelType::Half: {
      std::uint16_t value = 0;
      std::memcpy(&value, at, sizeof value);
      return glm::unpackHalf1x16(value);
    }
    default: {
      float value = 0.0F;
      std::memcpy(&value, at, sizeof value);
      return value;
    }
  }
}

void store(Image& image, std::size_t index, float value) {
  std::byte* at = image.pixels.data() + index * bytesPerChannel(image.type);
  switch (image.type) {
    case PixelType::U8:
      *at = static_cast<std::byte>(std::lround(std::clamp(value, 0.0F, 1.0F) * 255.0F));
      break;
    case PixelType::U16: {
      const auto bits = static_cast<std::uint16_t>(std::lround(std::clamp(value, 0.0F, 1.0F) * 65535.0F));
      std::memcpy(at, &bits, sizeof bits);
      break;
    }
    case PixelType::Half: {
      const std::uint16_t bits = halfOf(std::clamp(value, -kHalfMaximum, kHalfMaximum));
      std::memcpy(at, &bits, sizeof bits);
      break;
    }
    default:
      std::memcpy(at, &value, sizeof value);
      break;
  }
}

float linearFromSrgb(float c) { return c <= 0.04045F ? c / 12.92F : std::pow((c + 0.055F) / 1.055F, 2.4F); }
float srgbFromLinear(float c) { return c <= 0.0031308F ? c * 12.92F : 1.055F * std::pow(c, 1.0F / 2.4F) - 0.055F; }

/// Whether a channel carries colour, not coverage.
bool isColourChannel(int channel, int channels) { return channels == 2 ? channel == 0 : channel < 3; }

std::size_t pixelCount(const Image& image) {
  return static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
}

}  // namespace

Image greyToColour(const Image& image) {
  const bool alpha = image.channels == 2;
  Image out = emptyLike(image, image.width, image.height, alpha ? 4 : 3, image.type);
  const std::size_t size = bytesPerChannel(image.type);
  const auto from = static_cast<std::size_t>(image.channels) * size;
  const auto to = static_cast<std::size_t>(out.channels) * size;
  for (std::size_t i = 0; i < pixelCount(image); ++i) {
    const std::byte* grey = image.pixels.data() + i * from;
    std::byte* colour = out.pixels.data() + i * to;
    for (std::size_t c = 0; c < 3; ++c) std::memcpy(colour + c * size, grey, size);
    if (alpha) std::memcpy(colour + 3 * size, grey + size, size);
  }
  return out;
}

Image onlyChannel(const Image& image, int channel) {
  Image out = emptyLike(image, image.width, image.height, 1, image.type);
  const std::size_t size = bytesPerChannel(image.type);
  const std::size_t pixel = static_cast<std::size_t>(image.channels) * size;
  const std::byte* from = image.pixels.data() + static_cast<std::size_t>(channel) * size;
  for (std::size_t i = 0; i < pixelCount(image); ++i) std::memcpy(out.pixels.data() + i * size, from + i * pixel, size);
  return out;
}

Image toFloatRgba(const Image& image) {
  Image out = emptyLike(image, image.width, image.height, 4, PixelType::Float);
  const auto channels = static_cast<std::size_t>(image.channels);
  for (std::size_t i = 0; i < pixelCount(image); ++i) {
    float rgba[4] = {0.0F, 0.0F, 0.0F, 1.0F};
    for (std::size_t c = 0; c < 3; ++c) rgba[c] = load(image, i * channels + (channels <= 2 ? 0 : c));
    if (channels == 2 || channels == 4) rgba[3] = load(image, i * channels + channels - 1);
    std::memcpy(out.pixels.data() + i * sizeof rgba, rgba, sizeof rgba);
  }
  return out;
}

Image toHalf(const Image& image) {
  Image out = emptyLike(image, image.width, image.height, image.channels, PixelType::Half);
  const std::size_t count = pixelCount(image) * static_cast<std::size_t>(image.channels);
  for (std::size_t i = 0; i < count; ++i) store(out, i, load(image, i));
  return out;
}

Image srgbToLinear(const Image& image) {
  Image out = emptyLike(image, image.width, image.height, image.channels, PixelType::Half);
  const int channels = image.channels;
  const std::size_t count = pixelCount(image) * static_cast<std::size_t>(channels);
  for (std::size_t i = 0; i < count; ++i) {
    const int channel = static_cast<int>(i % static_cast<std::size_t>(channels));
    const float value = load(image, i);
    store(out, i, isColourChannel(channel, channels) ? linearFromSrgb(value) : value);
  }
  return out;
}

bool lacksZ(const Image& image) {
  if (image.channels < 3) return false;
  constexpr std::size_t kLooks = 4096;
  const auto channels = static_cast<std::size_t>(image.channels);
  const std::size_t count = pixelCount(image);
  const std::size_t step = std::max<std::size_t>(count / kLooks, 1);
  std::size_t looked = 0, wrong = 0;
  for (std::size_t i = 0; i < count; i += step, ++looked) {
    float square = 0.0F;
    for (std::size_t c = 0; c < 3; ++c) {
      const float value = 2.0F * load(image, i * channels + c) - 1.0F;
      square += value * value;
    }
    wrong += std::abs(std::sqrt(square) - 1.0F) > 0.1F ? 1 : 0;
  }
  return 3 * wrong > looked;
}

Image withZ(const Image& image) {
  Image out = image;
  const auto channels = static_cast<std::size_t>(image.channels);
  for (std::size_t i = 0; i < pixelCount(image); ++i) {
    const float x = 2.0F * load(image, i * channels) - 1.0F;
    const float y = 2.0F * load(image, i * channels + 1) - 1.0F;
    store(out, i * channels + 2, 0.5F + 0.5F * std::sqrt(std::max(1.0F - x * x - y * y, 0.0F)));
  }
  return out;
}

Image reduced(const Image& image, int maximumSize, bool srgb) {
  const int factor =
      std::max((image.width + maximumSize - 1) / maximumSize, (image.height + maximumSize - 1) / maximumSize);
  const int width = std::max(1, image.width / factor);
  const int height = std::max(1, image.height / factor);
  Image out = emptyLike(image, width, height, image.channels, image.type);
  const auto channels = static_cast<std::size_t>(image.channels);
  for (int y = 0; y < height; ++y) {
    // The rows and columns that this pixel stands for; the last ones take what a division left over.
    const int y0 = static_cast<int>(static_cast<long>(y) * image.height / height);
    const int y1 = std::max(y0 + 1, static_cast<int>(static_cast<long>(y + 1) * image.height / height));
    for (int x = 0; x < width; ++x) {
      const int x0 = static_cast<int>(static_cast<long>(x) * image.width / width);
      const int x1 = std::max(x0 + 1, static_cast<int>(static_cast<long>(x + 1) * image.width / width));
      for (std::size_t c = 0; c < channels; ++c) {
        const bool decode = srgb && isColourChannel(static_cast<int>(c), image.channels);
        float sum = 0.0F;
        for (int sy = y0; sy < y1; ++sy)
          for (int sx = x0; sx < x1; ++sx) {
            const std::size_t pixel =
                static_cast<std::size_t>(sy) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(sx);
            const float value = load(image, pixel * channels + c);
            sum += decode ? linearFromSrgb(value) : value;
          }
        const float mean = sum / static_cast<float>((y1 - y0) * (x1 - x0));
        const std::size_t pixel =
            static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
        store(out, pixel * channels + c, decode ? srgbFromLinear(mean) : mean);
      }
    }
  }
  return out;
}

namespace {

/// Both ways between 8-bit sRGB codes and linear light, for images of many millions of them.
struct SrgbTables {
  static constexpr std::uint32_t kSteps = 16384;  // a step is a fifteenth of the darkest code's width
  std::array<std::uint32_t, 256> linear{};        ///< in sixteenths of a step
  std::array<std::uint8_t, kSteps + 1> code{};
  SrgbTables() {
    for (std::size_t i = 0; i < linear.size(); ++i)
      linear.at(i) = static_cast<std::uint32_t>(
          std::lround(linearFromSrgb(static_cast<float>(i) / 255.0F) * static_cast<float>(16 * kSteps)));
    for (std::size_t i = 0; i <= kSteps; ++i)
      code.at(i) = static_cast<std::uint8_t>(
          std::lround(srgbFromLinear(static_cast<float>(i) / static_cast<float>(kSteps)) * 255.0F));
  }
  [[nodiscard]] std::uint8_t mean(std::uint8_t a, std::uint8_t b, std::uint8_t c, std::uint8_t d) const {
    return code[(linear[a] + linear[b] + linear[c] + linear[d] + 32) / 64];
  }
};

std::uint8_t meanOf(std::uint8_t a, std::uint8_t b, std::uint8_t c, std::uint8_t d) {
  return static_cast<std::uint8_t>((a + b + c + d + 2) / 4);
}
std::uint16_t meanOf(std::uint16_t a, std::uint16_t b, std::uint16_t c, std::uint16_t d) {
  return static_cast<std::uint16_t>((std::uint32_t{a} + b + c + d + 2) / 4);
}
float meanOf(float a, float b, float c, float d) { return 0.25F * (a + b + c + d); }
/// A half's bits are a type of their own.
struct HalfBits {
  std::uint16_t bits = 0;
};
HalfBits meanOf(HalfBits a, HalfBits b, HalfBits c, HalfBits d) {
  const float mean = meanOf(glm::unpackHalf1x16(a.bits), glm::unpackHalf1x16(b.bits), glm::unpackHalf1x16(c.bits),
                            glm::unpackHalf1x16(d.bits));
  return {halfOf(std::clamp(mean, -kHalfMaximum, kHalfMaximum))};
}

/// Halves an image of `Channel`s; `mean(c, …)` of channel c's four values. The last row and column of an odd side
/// count for nothing, those of a side of one twice.
template <class Channel, std::size_t kChannels, class Mean>
void halveChannels(const Image& image, Image& out, Mean mean) {
  const auto row = static_cast<std::size_t>(image.width) * kChannels;
  const std::size_t right = image.width > 1 ? kChannels : 0, below = image.height > 1 ? row : 0;
  const auto* from = reinterpret_cast<const Channel*>(image.pixels.data());
  auto* to = reinterpret_cast<Channel*>(out.pixels.data());
  for (std::size_t y = 0; y < static_cast<std::size_t>(out.height); ++y) {
    const Channel* at = from + 2 * y * row;
    for (std::size_t x = 0; x < static_cast<std::size_t>(out.width); ++x, at += 2 * kChannels)
      for (std::size_t c = 0; c < kChannels; ++c)
        *to++ = mean(c, at[c], at[c + right], at[c + below], at[c + below + right]);
  }
}

/// How many channels there are the compiler has to know: for all of a pixel at once it takes a third of the time.
template <class Channel, class Mean>
void halve(const Image& image, Image& out, Mean mean) {
  switch (image.channels) {
    case 1:
      return halveChannels<Channel, 1>(image, out, mean);
    case 2:
      return halveChannels<Channel, 2>(image, out, mean);
    case 3:
      return halveChannels<Channel, 3>(image, out, mean);
    default:
      return halveChannels<Channel, 4>(image, out, mean);
  }
}

}  // namespace

Image halved(const Image& image, bool srgb) {
  Image out = emptyLike(image, std::max(1, image.width / 2), std::max(1, image.height / 2), image.channels, image.type);
  const auto plain = [](std::size_t, auto a, auto b, auto c, auto d) { return meanOf(a, b, c, d); };
  switch (image.type) {
    case PixelType::U8:
      if (srgb) {
        static const SrgbTables kTables;
        const auto colours = static_cast<std::size_t>(image.channels <= 2 ? 1 : 3);
        halve<std::uint8_t>(image, out, [&](std::size_t channel, auto a, auto b, auto c, auto d) {
          return channel < colours ? kTables.mean(a, b, c, d) : meanOf(a, b, c, d);
        });
      } else {
        halve<std::uint8_t>(image, out, plain);
      }
      break;
    case PixelType::U16:
      halve<std::uint16_t>(image, out, plain);
      break;
    case PixelType::Half:
      halve<HalfBits>(image, out, plain);
      break;
    case PixelType::Float:
      halve<float>(image, out, plain);
      break;
  }
  return out;
}

}  // namespace dermis
