#include "ui/thumbnails.h"

#include <QPainter>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/image/image_tiles.h"
#include "ui/rows/colour_math.h"

namespace dermis {
namespace {

float halfToFloat(std::uint16_t h) {
  const int exponent = (h >> 10) & 31;
  const int mantissa = h & 1023;
  const float sign = (h & 0x8000) != 0 ? -1.0F : 1.0F;
  if (exponent == 0) return sign * std::ldexp(static_cast<float>(mantissa), -24);
  if (exponent == 31) return sign * 65504.0F;
  return sign * std::ldexp(static_cast<float>(mantissa + 1024), exponent - 25);
}

/// One channel as stored: 0..1 for integers, the number itself for floats.
float sample(const Image& image, int x, int y, int channel) {
  const int c = image.channels <= 2 ? 0 : std::min(channel, 2);
  const std::size_t at =
      (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x)) *
          static_cast<std::size_t>(image.channels) +
      static_cast<std::size_t>(c);
  const std::byte* p = image.pixels.data() + at * bytesPerChannel(image.type);
  switch (image.type) {
    case PixelType::U8:
      return static_cast<float>(std::to_integer<int>(*p)) / 255.0F;
    case PixelType::U16: {
      std::uint16_t v = 0;
      std::memcpy(&v, p, sizeof v);
      return static_cast<float>(v) / 65535.0F;
    }
    case PixelType::Half: {
      std::uint16_t v = 0;
      std::memcpy(&v, p, sizeof v);
      return halfToFloat(v);
    }
    case PixelType::Float: {
      float v = 0.0F;
      std::memcpy(&v, p, sizeof v);
      return v;
    }
  }
  return 0.0F;
}

/// Mean of a few samples of the source's rectangle under one pixel of the thumbnail.
glm::vec3 boxMean(const Image& image, const QRect& part, int x, int y, QSize size) {
  constexpr int kTaps = 3;
  glm::vec3 sum(0.0F);
  for (int j = 0; j < kTaps; ++j)
    for (int i = 0; i < kTaps; ++i) {
      const int sx =
          std::min(part.width() - 1, static_cast<int>((x + (i + 0.5) / kTaps) * part.width() / size.width()));
      const int sy =
          std::min(part.height() - 1, static_cast<int>((y + (j + 0.5) / kTaps) * part.height() / size.height()));
      for (int c = 0; c < 3; ++c) sum[c] += std::clamp(sample(image, part.x() + sx, part.y() + sy, c), 0.0F, 1e4F);
    }
  return sum / static_cast<float>(kTaps * kTaps);
}

}  // namespace

QImage panoramaThumbnail(const EnvironmentImages& environment, QSize size) {
  QImage picture(size, QImage::Format_RGB32);
  picture.fill(toScreen(environment.constant));
  const Image* source = environment.latLong ? environment.latLong.get() : environment.faces[4].get();
  if (source == nullptr) return picture;
  for (int y = 0; y < size.height(); ++y)
    for (int x = 0; x < size.width(); ++x) {
      const glm::vec3 c = boxMean(*source, QRect(0, 0, source->width, source->height), x, y, size);
      picture.setPixelColor(x, y, toScreen(c / (c + 1.0F) * 1.6F));
    }
  return picture;
}

namespace {

/// A rectangle of an image, its longer side `side` pixels.
QImage partThumbnail(const Image& image, const QRect& part, int side) {
  const double scale = static_cast<double>(side) / std::max(part.width(), part.height());
  const QSize size(std::max(1, static_cast<int>(part.width() * scale)),
                   std::max(1, static_cast<int>(part.height() * scale)));
  QImage picture(size, QImage::Format_RGB32);
  for (int y = 0; y < size.height(); ++y)
    for (int x = 0; x < size.width(); ++x) {
      const glm::vec3 c = boxMean(image, part, x, y, size);
      const glm::vec3 shown = glm::clamp(c, glm::vec3(0.0F), glm::vec3(1.0F));
      picture.setPixelColor(x, y, image.isFloatingPoint() ? toScreen(c) : QColor::fromRgbF(shown.r, shown.g, shown.b));
    }
  return picture;
}

/// The tiles of a set as they lie in the texture coordinates, a line between them; squares without one stay dark.
QImage tilesThumbnail(const Image& set, int side) {
  glm::ivec2 lower(kUdimsPerRow), upper(0);
  for (const int number : set.tiles) {
    lower = glm::min(lower, udimSquare(number));
    upper = glm::max(upper, udimSquare(number));
  }
  const glm::ivec2 squares = upper - lower + 1;
  const int one = std::max(side / std::max(squares.x, squares.y), 2);
  QImage picture(one * squares.x, one * squares.y, QImage::Format_RGB32);
  picture.fill(QColor(20, 20, 20));
  QPainter painter(&picture);
  for (std::size_t i = 0; i < set.tiles.size(); ++i) {
    const glm::ivec2 at = udimSquare(set.tiles[i]) - lower;
    const QRect rows(0, static_cast<int>(i) * tileHeight(set), set.width, tileHeight(set));
    painter.drawImage(at.x * one, (squares.y - 1 - at.y) * one, partThumbnail(set, rows, one - 1));
  }
  return picture;
}

}  // namespace

QImage mapThumbnail(const Image& image, int side) {
  return image.tiles.empty() ? partThumbnail(image, QRect(0, 0, image.width, image.height), side)
                             : tilesThumbnail(image, side);
}

QImage materialBall(const Material& material, int side) {
  const MaterialParameters& p = material.parameters;
  glm::vec3 albedo = p.baseAlbedo.rgb;
  float metallic = p.baseMetallic;
  glm::vec3 f0(std::pow((p.specularIor - 1.0F) / (p.specularIor + 1.0F), 2.0F));
  if (p.specularF0) f0 = p.specularF0->rgb;
  float roughness = p.specularPerceptualRoughness;
  switch (material.model) {
    case ShadingModel::Reflection:
      albedo = glm::vec3(0.0F), f0 = glm::vec3(0.9F), roughness = 0.05F;
      break;
    case ShadingModel::MicrofacetLab:
      albedo = glm::vec3(0.0F);
      break;
    case ShadingModel::Eye:
      albedo = p.eyeScleraColor.rgb, roughness = 0.1F;
      break;
    case ShadingModel::Lens:
      albedo = glm::vec3(0.02F), roughness = 0.05F;
      break;
    default:
      break;
  }
  if (p.baseMetallic > 0.0F && material.model != ShadingModel::MicrofacetLab) f0 = glm::mix(f0, albedo, metallic);
  const float alpha = std::max(roughness * roughness, 0.02F);
  const glm::vec3 key = glm::normalize(glm::vec3(-0.5F, 0.75F, 0.75F));
  const glm::vec3 view(0.0F, 0.0F, 1.0F);

  QImage picture(side, side, QImage::Format_ARGB32_Premultiplied);
  picture.fill(Qt::transparent);
  const float radius = 0.5F * static_cast<float>(side) - 1.0F;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const float u = (static_cast<float>(x) + 0.5F - 0.5F * static_cast<float>(side)) / radius;
      const float v = (0.5F * static_cast<float>(side) - static_cast<float>(y) - 0.5F) / radius;
      const float r2 = u * u + v * v;
      const float cover = std::clamp((1.0F - std::sqrt(r2)) * radius + 0.5F, 0.0F, 1.0F);
      if (cover <= 0.0F) continue;
      const glm::vec3 n(u, v, std::sqrt(std::max(1.0F - r2, 0.0F)));
      const float nl = glm::dot(n, key);
      // Skin's light reaches a little round the terminator, the red farthest.
      const glm::vec3 wrap = material.model == ShadingModel::Skin ? glm::vec3(0.30F, 0.12F, 0.08F) : glm::vec3(0.0F);
      const glm::vec3 lit = glm::max((glm::vec3(nl) + wrap) / (1.0F + wrap), glm::vec3(0.0F));
      const float sky = 0.5F + 0.5F * n.y;
      glm::vec3 c = albedo * (1.0F - metallic) * (lit * 0.95F + glm::vec3(0.10F + 0.22F * sky));
      const glm::vec3 h = glm::normalize(key + view);
      const float nh = std::max(glm::dot(n, h), 0.0F);
      const float d = nh * nh * (alpha * alpha - 1.0F) + 1.0F;
      const float lobe = std::min(alpha * alpha / (3.14159F * d * d), 60.0F) * std::max(nl, 0.0F);
      const float fresnel = std::pow(1.0F - n.z, 5.0F);
      const glm::vec3 f = f0 + (1.0F - f0) * fresnel * (1.0F - 0.7F * roughness);
      const float mirror = std::max(2.0F * n.z * n.y, -1.0F);  // height of what a mirror would show there
      const float horizon = 1.0F / (1.0F + std::exp(-(mirror + 0.1F) * (2.0F + 14.0F * (1.0F - roughness))));
      c += f * (0.6F * lobe + 0.12F + 0.85F * horizon);
      QColor pixel = toScreen(c / (c * 0.35F + 1.0F) * 1.15F);
      pixel.setAlphaF(cover);
      picture.setPixelColor(x, y, pixel);
    }
  return picture;
}

}  // namespace dermis
