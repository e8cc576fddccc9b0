#include "passes/read_back.h"

#include <algorithm>
#include <cstring>
#include <vector>

namespace dermis {

namespace {

int channelsOf(Aov aov) {
  switch (aov) {
    case Aov::Beauty:
      return 4;
    case Aov::Diffuse:
    case Aov::DiffuseScattered:
    case Aov::Specular:
    case Aov::Transmission:
    case Aov::Normal:
      return 3;
    default:
      return 1;
  }
}

/// Where a number is in its image: see SceneImage.
std::size_t firstChannelOf(Aov aov) {
  switch (aov) {
    case Aov::Depth:
      return 1;
    case Aov::Thickness:
    case Aov::ProfileId:
      return 2;
    case Aov::Energy:
      return 3;
    default:
      return 0;
  }
}

Image blank(glm::ivec2 size, int channels, PixelType type) {
  Image image;
  image.width = std::max(size.x, 1);
  image.height = std::max(size.y, 1);
  image.channels = channels;
  image.type = type;
  image.pixels.resize(image.rowBytes() * static_cast<std::size_t>(image.height));
  return image;
}

}  // namespace

Image blackAov(Aov aov, glm::ivec2 size) {
  Image image = blank(size, channelsOf(aov), PixelType::Float);
  image.name = toString(aov);
  return image;
}

Image aovFromSums(Aov aov, const gl::Texture& sums, int samples) {
  constexpr std::size_t stored = 4;
  const std::vector<float> values = sums.readFloats(static_cast<int>(stored));
  Image image = blackAov(aov, {sums.width(), sums.height()});
  const auto width = static_cast<std::size_t>(image.width);
  const auto height = static_cast<std::size_t>(image.height);
  const auto channels = static_cast<std::size_t>(image.channels);
  const bool isMeanOfCovered =
      aov == Aov::Normal || aov == Aov::Occlusion || aov == Aov::Thickness || aov == Aov::Depth;
  const std::size_t first = firstChannelOf(aov);
  const float weight = 1.0F / static_cast<float>(samples);
  for (std::size_t y = 0; y < height; ++y) {
    for (std::size_t x = 0; x < width; ++x) {
      const float* sum = &values[((height - 1 - y) * width + x) * stored];
      float scale = aov == Aov::ProfileId ? 1.0F : weight;
      if (isMeanOfCovered) scale = sum[3] > 0.0F ? 1.0F / sum[3] : 0.0F;
      float pixel[4] = {};
      for (std::size_t c = 0; c < channels; ++c) pixel[c] = sum[first + c] * scale;
      std::memcpy(image.pixels.data() + (y * width + x) * channels * sizeof(float), pixel, channels * sizeof(float));
    }
  }
  return image;
}

Image blackDisplay(glm::ivec2 size, bool wide) { return blank(size, 4, wide ? PixelType::U16 : PixelType::U8); }

Image displayFromTexture(const gl::Texture& texture, bool wide) {
  Image image = blackDisplay({texture.width(), texture.height()}, wide);
  std::vector<std::byte> rows(image.pixels.size());
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
  glGetTextureImage(texture.id(), 0, GL_RGBA, wide ? GL_UNSIGNED_SHORT : GL_UNSIGNED_BYTE,
                    static_cast<GLsizei>(rows.size()), rows.data());
  const std::size_t row = image.rowBytes();
  const auto height = static_cast<std::size_t>(image.height);
  for (std::size_t y = 0; y < height; ++y)
    std::memcpy(image.pixels.data() + y * row, rows.data() + (height - 1 - y) * row, row);
  return image;
}

}  // namespace dermis
