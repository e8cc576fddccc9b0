#include "core/scene/mean_albedo.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/gtc/packing.hpp>

#include "core/image/image_tiles.h"

namespace dermis {

namespace {

float srgbToLinear(float c) { return c <= 0.04045F ? c / 12.92F : std::pow((c + 0.055F) / 1.055F, 2.4F); }

/// How a texel of `image` becomes a linear colour.
struct TexelReader {
  const Image& image;
  bool decode;

  TexelReader(const Image& of, const TextureBinding& binding) : image(of), decode(!of.isFloatingPoint()) {
    const std::string space = binding.colorSpace.value_or("");
    if (space == "linear" || space == "raw") decode = false;
    if (space == "srgb") decode = true;
  }

  float channel(std::size_t texel, int c) const {
    const std::size_t size = bytesPerChannel(image.type);
    const std::byte* at =
        image.pixels.data() + (texel * static_cast<std::size_t>(image.channels) + static_cast<std::size_t>(c)) * size;
    float value = 0.0F;
    std::uint16_t wide = 0;
    if (size == 2) std::memcpy(&wide, at, 2);
    switch (image.type) {
      case PixelType::U8:
        value = static_cast<float>(std::to_integer<int>(*at)) / 255.0F;
        break;
      case PixelType::U16:
        value = static_cast<float>(wide) / 65535.0F;
        break;
      case PixelType::Half:
        value = glm::unpackHalf1x16(wide);
        break;
      case PixelType::Float:
        std::memcpy(&value, at, 4);
        break;
    }
    return decode ? srgbToLinear(value) : value;
  }

  glm::vec3 at(glm::vec2 uv) const {
    TilePlace place{0, uv - glm::floor(uv)};
    if (!image.tiles.empty()) {
      const auto found = tilePlace(image, uv);
      if (!found) return glm::vec3(1.0F);
      place = *found;
    }
    const int height = tileHeight(image);
    const int x = std::min(static_cast<int>(place.uv.x * static_cast<float>(image.width)), image.width - 1);
    const int y = std::min(static_cast<int>((1.0F - place.uv.y) * static_cast<float>(height)), height - 1);
    const std::size_t row = place.index * static_cast<std::size_t>(height) + static_cast<std::size_t>(y);
    const std::size_t texel = row * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(std::max(x, 0));
    if (image.channels < 3) return glm::vec3(channel(texel, 0));
    return {channel(texel, 0), channel(texel, 1), channel(texel, 2)};
  }
};

}  // namespace

glm::vec3 meanOfAlbedoMap(const ResolvedScene& scene, std::size_t slot) {
  const ResolvedMaterial& material = scene.slots.at(slot);
  const auto& image = material.images.at(static_cast<std::size_t>(TextureSlot::Albedo));
  const Model& model = *scene.model;
  if (!image || !model.hasUvs) return glm::vec3(1.0F);
  const TextureBinding& binding = material.material.texture(TextureSlot::Albedo);
  const TexelReader read(*image, binding);
  const glm::vec2 uvScale(binding.uvScale[0], binding.uvScale[1]);

  // Points of the R2 sequence (Roberts 2018) in triangles taken at equal steps, each weighed by its triangle's area.
  constexpr std::size_t kPoints = 4096;
  glm::dvec3 sum(0.0);
  double area = 0.0;
  for (const ModelPart& part : model.parts) {
    if (part.slot != slot || part.indexCount < 3) continue;
    const std::size_t triangles = part.indexCount / 3;
    for (std::size_t i = 0; i < kPoints; ++i) {
      const std::size_t first = part.firstIndex + 3 * (i * triangles / kPoints);
      const std::size_t a = model.indices[first], b = model.indices[first + 1], c = model.indices[first + 2];
      glm::vec2 at = glm::fract(static_cast<float>(i + 1) * glm::vec2(0.7548776662F, 0.5698402910F));
      if (at.x + at.y > 1.0F) at = 1.0F - at;
      const glm::vec3 ab = model.positions[b] - model.positions[a], ac = model.positions[c] - model.positions[a];
      const double weight = glm::length(glm::cross(ab, ac));
      const glm::vec2 uv = model.uvs[a] + at.x * (model.uvs[b] - model.uvs[a]) + at.y * (model.uvs[c] - model.uvs[a]);
      sum += weight * glm::dvec3(read.at(uv * uvScale));
      area += weight;
    }
  }
  if (!(area > 0.0)) return glm::vec3(1.0F);
  // As the shader reads the map: scaled, and turned round where it is inverted.
  glm::vec3 mean(sum / area);
  mean = binding.scale * (binding.invert ? 1.0F - mean : mean);
  return glm::clamp(mean, 0.0F, 1.0F);
}

glm::vec3 meanAlbedo(const ResolvedScene& scene, std::size_t slot) {
  return scene.slots.at(slot).material.parameters.baseAlbedo.rgb * meanOfAlbedoMap(scene, slot);
}

}  // namespace dermis
