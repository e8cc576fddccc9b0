#include "core/image/comparison.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <glm/glm.hpp>
#include <glm/gtc/packing.hpp>
#include <limits>

namespace dermis {
namespace {

float valueAt(const Image& image, std::size_t index) {
  const std::byte* at = image.pixels.data() + index * bytesPerChannel(image.type);
  std::uint16_t word = 0;
  float value = 0.0F;
  switch (image.type) {
    case PixelType::U8:
      return static_cast<float>(std::to_integer<int>(*at)) / 255.0F;
    case PixelType::U16:
      std::memcpy(&word, at, sizeof word);
      return static_cast<float>(word) / 65535.0F;
    case PixelType::Half:
      std::memcpy(&word, at, sizeof word);
      return glm::unpackHalf1x16(word);
    case PixelType::Float:
      std::memcpy(&value, at, sizeof value);
      return value;
  }
  return value;
}

bool hasAlpha(const Image& image) { return image.channels == 2 || image.channels == 4; }

/// IEC 61966-2-1, from linear light to code value.
float toSrgb(float v) {
  const float c = std::clamp(v, 0.0F, 1.0F);
  return c <= 0.0031308F ? 12.92F * c : 1.055F * std::pow(c, 1.0F / 2.4F) - 0.055F;
}

double difference(float a, float b) {
  if (std::isfinite(a) && std::isfinite(b)) return std::abs(static_cast<double>(a) - static_cast<double>(b));
  const bool alike = (std::isnan(a) && std::isnan(b)) || a == b;
  return alike ? 0.0 : std::numeric_limits<double>::infinity();
}

}  // namespace

std::vector<float> channelValues(const Image& image, int c) {
  const std::size_t count = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
  const auto channels = static_cast<std::size_t>(image.channels);
  if (c == 3 && !hasAlpha(image)) return std::vector<float>(count, 1.0F);
  const std::size_t offset = c == 3 ? channels - 1 : channels < 3 ? 0 : static_cast<std::size_t>(c);
  std::vector<float> values(count);
  for (std::size_t i = 0; i < count; ++i) values[i] = valueAt(image, i * channels + offset);
  return values;
}

Result<Comparison> compareImages(const Image& a, const Image& b, double tolerance) {
  if (a.width != b.width || a.height != b.height)
    return inputError(a.name + " is " + std::to_string(a.width) + "×" + std::to_string(a.height) + " and " + b.name +
                      " is " + std::to_string(b.width) + "×" + std::to_string(b.height) +
                      "; only images of one size can be compared");
  Comparison result;
  result.width = a.width;
  result.height = a.height;
  const std::size_t count = static_cast<std::size_t>(a.width) * static_cast<std::size_t>(a.height);
  const int channels = hasAlpha(a) || hasAlpha(b) ? 4 : 3;
  std::vector<bool> failing(count, false);
  std::vector<float> codedA[3];
  std::vector<float> codedB[3];
  double sum = 0.0;
  for (int c = 0; c < channels; ++c) {
    std::vector<float> va = channelValues(a, c);
    std::vector<float> vb = channelValues(b, c);
    for (std::size_t i = 0; i < count; ++i) {
      const double d = difference(va[i], vb[i]);
      sum += d;
      result.maximum = std::max(result.maximum, d);
      if (d > tolerance) failing[i] = true;
    }
    if (c == 3) continue;
    // FLIP looks at pictures: linear values are encoded as sRGB first.
    const auto coded = [](const Image& image, std::vector<float> values) {
      if (image.isFloatingPoint())
        for (float& v : values) v = toSrgb(std::isnan(v) ? 0.0F : v);
      return values;
    };
    codedA[c] = coded(a, std::move(va));
    codedB[c] = coded(b, std::move(vb));
  }
  result.mean = sum / (static_cast<double>(count) * channels);
  result.failing = static_cast<double>(std::count(failing.begin(), failing.end(), true)) / static_cast<double>(count);
  result.flipMap = flipMap(codedA, codedB, a.width, a.height);
  for (const float v : result.flipMap) result.flip += static_cast<double>(v);
  result.flip /= static_cast<double>(count);
  return result;
}

Image heatMap(const std::vector<float>& map, int width, int height) {
  // Black, violet, red, orange, pale yellow: brightness rises all the way, so that it reads in grey as well.
  static constexpr std::array<std::array<float, 3>, 6> kStops = {
      {{0, 0, 4}, {59, 15, 112}, {140, 41, 129}, {222, 73, 104}, {254, 159, 109}, {252, 253, 191}}};
  Image image;
  image.width = width;
  image.height = height;
  image.channels = 3;
  image.type = PixelType::U8;
  image.pixels.reserve(map.size() * 3);
  for (const float value : map) {
    const float at = std::clamp(value, 0.0F, 1.0F) * static_cast<float>(kStops.size() - 1);
    const std::size_t i = std::min(static_cast<std::size_t>(at), kStops.size() - 2);
    const float t = at - static_cast<float>(i);
    for (std::size_t c = 0; c < 3; ++c) {
      const float v = kStops.at(i).at(c) + t * (kStops.at(i + 1).at(c) - kStops.at(i).at(c));
      image.pixels.push_back(static_cast<std::byte>(std::lround(v)));
    }
  }
  return image;
}

}  // namespace dermis
