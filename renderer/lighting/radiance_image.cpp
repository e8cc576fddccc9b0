#include "lighting/radiance_image.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "lighting/cube_geometry.h"

namespace dermis {
namespace {

float halfToFloat(std::uint16_t h) {
  const int exponent = (h >> 10) & 31;
  const float mantissa = static_cast<float>(h & 1023);
  const float sign = (h & 0x8000) != 0 ? -1.0F : 1.0F;
  if (exponent == 31) return mantissa != 0.0F ? std::nanf("") : sign * INFINITY;
  if (exponent == 0) return sign * std::ldexp(mantissa, -24);
  return sign * std::ldexp(mantissa + 1024.0F, exponent - 25);
}

float srgbToLinear(float v) { return v <= 0.04045F ? v / 12.92F : std::pow((v + 0.055F) / 1.055F, 2.4F); }

template <class T>
T load(const std::byte* p) {
  T value;
  std::memcpy(&value, p, sizeof value);
  return value;
}

/// One channel as a float, integers decoded from sRGB.
float channel(const Image& image, std::size_t index) {
  const std::byte* p = image.pixels.data() + index * bytesPerChannel(image.type);
  switch (image.type) {
    case PixelType::U8:
      return srgbToLinear(static_cast<float>(load<std::uint8_t>(p)) / 255.0F);
    case PixelType::U16:
      return srgbToLinear(static_cast<float>(load<std::uint16_t>(p)) / 65535.0F);
    case PixelType::Half:
      return halfToFloat(load<std::uint16_t>(p));
    case PixelType::Float:
      return load<float>(p);
  }
  return 0.0F;
}

float clean(float v, float peak, CleanedTexels& cleaned) {
  if (v >= 0.0F && v <= peak) return v;
  if (std::isfinite(v)) {
    ++cleaned.negative;
    return 0.0F;
  }
  ++cleaned.nonFinite;
  return v > 0.0F ? peak : 0.0F;
}

glm::vec3 lerp(const glm::vec3& a, const glm::vec3& b, float f) { return a + (b - a) * f; }

}  // namespace

RadianceImage cleanRadiance(const Image& image, CleanedTexels& cleaned) {
  RadianceImage out{image.width, image.height, {}};
  const auto count = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
  const auto channels = static_cast<std::size_t>(image.channels);
  const std::size_t green = channels >= 3 ? 1 : 0;
  const std::size_t blue = channels >= 3 ? 2 : 0;
  out.pixels.resize(count);
  bool repair = false;
  for (std::size_t i = 0; i < count; ++i) {
    const glm::vec3 v{channel(image, i * channels), channel(image, i * channels + green),
                      channel(image, i * channels + blue)};
    // False for NaN too.
    const bool good = v.x >= 0.0F && v.y >= 0.0F && v.z >= 0.0F && v.x + v.y + v.z < INFINITY;
    repair |= !good;
    out.pixels[i] = v;
  }
  if (!repair) return out;

  float peak = 0.0F;
  for (const auto& p : out.pixels) {
    for (int c = 0; c < 3; ++c) {
      if (std::isfinite(p[c])) peak = std::max(peak, p[c]);
    }
  }
  for (auto& p : out.pixels) {
    for (int c = 0; c < 3; ++c) p[c] = clean(p[c], peak, cleaned);
  }
  return out;
}

RadianceMap::RadianceMap(const EnvironmentImages& images) {
  if (images.latLong) {
    layout = Layout::LatLong;
    latLong = cleanRadiance(*images.latLong, cleaned);
  } else if (images.faces[0]) {
    layout = Layout::Faces;
    for (std::size_t f = 0; f < 6; ++f) faces[f] = cleanRadiance(*images.faces[f], cleaned);
  } else {
    for (int c = 0; c < 3; ++c) constant[c] = clean(images.constant[c], 3.0e38F, cleaned);
  }
}

glm::vec3 RadianceMap::latLongAt(float x, float y) const {
  const int w = latLong.width;
  const int h = latLong.height;
  const auto texel = [&](int i, int j) -> const glm::vec3& {
    if (j < 0 || j >= h) {  // over a pole: the opposite meridian
      j = j < 0 ? -1 - j : 2 * h - 1 - j;
      i += w / 2;
    }
    i %= w;
    return latLong.at(i < 0 ? i + w : i, std::clamp(j, 0, h - 1));
  };
  const float fx = std::floor(x);
  const float fy = std::floor(y);
  const int i = static_cast<int>(fx);
  const int j = static_cast<int>(fy);
  return lerp(lerp(texel(i, j), texel(i + 1, j), x - fx), lerp(texel(i, j + 1), texel(i + 1, j + 1), x - fx), y - fy);
}

glm::vec3 RadianceMap::faceAt(int face, float s, float t) const {
  const auto texel = [&](int i, int j) -> const glm::vec3& {
    const RadianceImage& own = faces[static_cast<std::size_t>(face)];
    if (i >= 0 && j >= 0 && i < own.width && j < own.height) return own.at(i, j);
    const CubePoint p = cubePoint(cubeVector(face, (static_cast<float>(i) + 0.5F) / static_cast<float>(own.width),
                                             (static_cast<float>(j) + 0.5F) / static_cast<float>(own.height)));
    const RadianceImage& other = faces[static_cast<std::size_t>(p.face)];
    return other.at(std::clamp(static_cast<int>(p.s * static_cast<float>(other.width)), 0, other.width - 1),
                    std::clamp(static_cast<int>(p.t * static_cast<float>(other.height)), 0, other.height - 1));
  };
  const RadianceImage& own = faces[static_cast<std::size_t>(face)];
  const float x = s * static_cast<float>(own.width) - 0.5F;
  const float y = t * static_cast<float>(own.height) - 0.5F;
  const float fx = std::floor(x);
  const float fy = std::floor(y);
  const int i = static_cast<int>(fx);
  const int j = static_cast<int>(fy);
  return lerp(lerp(texel(i, j), texel(i + 1, j), x - fx), lerp(texel(i, j + 1), texel(i + 1, j + 1), x - fx), y - fy);
}

int RadianceMap::pixelsPerFace() const {
  if (layout == Layout::LatLong) return std::max(1, latLong.width / 4);
  return layout == Layout::Faces ? faces[0].width : 1;
}

}  // namespace dermis
