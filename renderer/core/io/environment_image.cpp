#include "core/io/environment_image.h"

#include <cmath>
#include <cstring>
#include <functional>
#include <glm/gtc/packing.hpp>

namespace dermis {
namespace {

/// IEC 61966-2-1, from code value to linear light.
float fromSrgb(float v) { return v <= 0.04045F ? v / 12.92F : std::pow((v + 0.055F) / 1.055F, 2.4F); }

template <class T>
T read(const std::byte* at) {
  T value;
  std::memcpy(&value, at, sizeof value);
  return value;
}

/// Code values to linear floats, by table for integers.
std::vector<float> decodingTable(PixelType type) {
  const std::size_t count = type == PixelType::U8 ? 256 : 65536;
  std::vector<float> table(count);
  for (std::size_t i = 0; i < count; ++i) table[i] = fromSrgb(static_cast<float>(i) / static_cast<float>(count - 1));
  return table;
}

}  // namespace

Image toLinearRadiance(const Image& image) {
  Image out;
  out.width = image.width;
  out.height = image.height;
  out.channels = 3;
  out.type = PixelType::Float;
  out.name = image.name;
  const std::size_t count = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
  out.pixels.resize(count * 3 * sizeof(float));

  std::vector<float> table;
  std::function<float(const std::byte*)> value;
  switch (image.type) {
    case PixelType::U8:
      table = decodingTable(image.type);
      value = [&](const std::byte* at) { return table[std::to_integer<std::size_t>(*at)]; };
      break;
    case PixelType::U16:
      table = decodingTable(image.type);
      value = [&](const std::byte* at) { return table[read<std::uint16_t>(at)]; };
      break;
    case PixelType::Half:
      value = [](const std::byte* at) { return glm::unpackHalf1x16(read<std::uint16_t>(at)); };
      break;
    case PixelType::Float:
      value = [](const std::byte* at) { return read<float>(at); };
      break;
  }
  const std::size_t step = bytesPerChannel(image.type);
  const auto channels = static_cast<std::size_t>(image.channels);
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t c = 0; c < 3; ++c) {
      const float v = value(image.pixels.data() + (i * channels + (channels < 3 ? 0 : c)) * step);
      std::memcpy(out.pixels.data() + (i * 3 + c) * sizeof(float), &v, sizeof v);
    }
  return out;
}

}  // namespace dermis
