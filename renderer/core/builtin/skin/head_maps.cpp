// From a laid-out head to images.
#include "core/builtin/skin/head_maps.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/bake/mesh_bake.h"
#include "core/bake/parallel.h"
#include "core/bake/point_bake.h"
#include "core/builtin/skin/pigments.h"
#include "core/io/disk_cache.h"

namespace dermis {
namespace {

using namespace skin;

/// Of a texel that a chart covers, and of one in the gutter round it.
constexpr std::uint8_t kInside = 2;

/// Calls work(x, y, index) for every texel that the atlas has, from several threads.
template <class Work>
void forTexels(const HeadAtlas& atlas, int step, const Work& work) {
  const auto size = static_cast<std::size_t>(atlas.size);
  forPieces(
      size, 8, {},
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t y = begin; y < end; ++y) {
          if (y % static_cast<std::size_t>(step) != 0) continue;
          for (std::size_t x = 0; x < size; x += static_cast<std::size_t>(step))
            if (atlas.covered[y * size + x] != 0) work(x, y, y * size + x);
        }
      },
      [](float) {});
}

SkinPlace placeOf(const HeadAtlas& atlas, std::size_t index, const HeadRegions& regions) {
  return {atlas.rest[index], regions.at(atlas.rest[index])};
}

Image emptyImage(const HeadAtlas& atlas, int channels, PixelType type, std::string_view name) {
  Image image;
  image.width = image.height = atlas.size;
  image.channels = channels;
  image.type = type;
  image.name = name;
  image.pixels.resize(static_cast<std::size_t>(image.height) * image.rowBytes());
  return image;
}

void store8(Image& image, std::size_t index, float value) {
  image.pixels[index] = static_cast<std::byte>(std::lround(255.0F * std::clamp(value, 0.0F, 1.0F)));
}
void store16(Image& image, std::size_t index, float value) {
  const auto code = static_cast<std::uint16_t>(std::lround(65535.0F * std::clamp(value, 0.0F, 1.0F)));
  std::memcpy(image.pixels.data() + 2 * index, &code, sizeof code);
}

/// IEC 61966-2-1.
float toSrgb(float v) { return v <= 0.0031308F ? 12.92F * v : 1.055F * std::pow(v, 1.0F / 2.4F) - 0.055F; }

/// The tone's pigments and table, ready for many texels.
class Painter {
 public:
  Painter(const HeadAtlas& atlas, const Look& look) : m_look(look), m_pigments(pigmentsOf(toneAlbedo(look.tone))) {
    // The tones' albedos are an artist's, brighter or darker than two layers of measured coefficients: one factor a
    // channel makes the mean of a plain face the tone's own.
    Look plain;
    plain.tone = look.tone;
    plain.seed = look.seed;
    constexpr int kSparse = 9;
    std::vector<glm::dvec3> rows(static_cast<std::size_t>(atlas.size), glm::dvec3(0.0));
    std::vector<double> counts(rows.size(), 0.0);
    forTexels(atlas, kSparse, [&](std::size_t, std::size_t y, std::size_t index) {
      if (atlas.covered[index] != kInside) return;
      rows[y] += glm::dvec3(uncorrected(pigmentLayers(placeOf(atlas, index, m_regions), plain), plain));
      counts[y] += 1.0;
    });
    glm::dvec3 sum(0.0);
    double count = 0.0;
    for (std::size_t y = 0; y < rows.size(); ++y) {
      sum += rows[y];
      count += counts[y];
    }
    if (count > 0.0) m_correction = glm::vec3(toneAlbedo(look.tone) * count / glm::max(sum, glm::dvec3(1e-9)));
  }

  [[nodiscard]] const HeadRegions& regions() const { return m_regions; }
  /// No surface returns all the light that it gets.
  [[nodiscard]] glm::vec3 albedo(const SkinPlace& place) const {
    constexpr float kMost = 0.97F;
    const glm::vec3 hair = glm::mix(glm::vec3(0.058F, 0.036F, 0.023F), glm::vec3(0.42F),
                                    0.8F * glm::smoothstep(45.0F, 85.0F, m_look.age));  // dark brown, then grey
    const PigmentLayers layers = pigmentLayers(place, m_look);
    // Light that reaches a shaft under the skin is mostly long-wave, what comes back from over it short-wave: shaved
    // skin looks blue for the reason that veins do (Kienle et al. 1996, "Why do veins appear blue? A new look at an old
    // question").
    constexpr glm::vec3 kReach(1.0F, 0.93F, 0.8F);
    const glm::vec3 skin = glm::min(m_correction * uncorrected(layers, m_look), glm::vec3(kMost));
    return glm::mix(glm::mix(skin, hair, layers.buried * kReach), hair, layers.hair);
  }

 private:
  [[nodiscard]] glm::vec3 uncorrected(const PigmentLayers& layers, const Look& look) const {
    // What lips or a flush add is blood of the body, not of a tone that has next to none in its colour.
    constexpr float kUsualBlood = 0.011F;
    const auto own = static_cast<float>(m_pigments.blood);
    const float blood =
        own * std::min(layers.blood, 1.0F) + std::max(own, kUsualBlood) * std::max(layers.blood - 1.0F, 0.0F);
    return m_table.at(static_cast<float>(m_pigments.melanin) * look.melanin * layers.melanin, look.haemoglobin * blood,
                      layers.oxygenation);
  }

  Look m_look;
  Pigments m_pigments;
  AlbedoTable m_table;
  HeadRegions m_regions;
  glm::vec3 m_correction{1.0F};
};

/// Height by texel with its neighbours.
class Relief {
 public:
  Relief(const HeadAtlas& atlas, std::vector<float> heights) : m_atlas(atlas), m_heights(std::move(heights)) {}

  [[nodiscard]] float height(std::size_t index) const { return m_heights[index]; }

  /// Millimetres of height a millimetre of skin, along u and along v. Measured on the resting head, because not all of
  /// the atlas has the same density.
  [[nodiscard]] glm::vec2 slope(std::size_t x, std::size_t y) const {
    return {along(x, y, 1, 0), -along(x, y, 0, 1)};  // rows run downwards, v upwards
  }

  /// Height over the mean of its surroundings, mm.
  [[nodiscard]] float overSurroundings(std::size_t x, std::size_t y) const {
    const int reach = std::max(1, static_cast<int>(std::lround(1.2F / m_atlas.millimetresPerTexel)));
    float sum = 0.0F, count = 0.0F;
    for (int j = -2; j <= 2; ++j)
      for (int i = -2; i <= 2; ++i)
        if (const auto at = neighbour(x, y, i * reach / 2, j * reach / 2)) {
          sum += m_heights[*at];
          count += 1.0F;
        }
    return m_heights[y * size() + x] - sum / count;
  }

 private:
  [[nodiscard]] std::size_t size() const { return static_cast<std::size_t>(m_atlas.size); }
  [[nodiscard]] std::optional<std::size_t> neighbour(std::size_t x, std::size_t y, int dx, int dy) const {
    const auto nx = static_cast<std::ptrdiff_t>(x) + dx, ny = static_cast<std::ptrdiff_t>(y) + dy;
    if (std::min(nx, ny) < 0 || std::max(nx, ny) >= m_atlas.size) return std::nullopt;
    const std::size_t index = static_cast<std::size_t>(ny) * size() + static_cast<std::size_t>(nx);
    return m_atlas.covered[index] != 0 ? std::optional(index) : std::nullopt;
  }
  [[nodiscard]] float along(std::size_t x, std::size_t y, int dx, int dy) const {
    const std::size_t here = y * size() + x;
    const std::size_t before = neighbour(x, y, -dx, -dy).value_or(here), after = neighbour(x, y, dx, dy).value_or(here);
    const float distance = glm::distance(m_atlas.rest[before], m_atlas.rest[after]);
    // In the gutter places repeat, and between charts they are far apart.
    const float texel = m_atlas.millimetresPerTexel;
    if (distance < 0.1F * texel || distance > 8.0F * texel) return 0.0F;
    return (m_heights[after] - m_heights[before]) / distance;
  }

  const HeadAtlas& m_atlas;
  std::vector<float> m_heights;
};

}  // namespace

Image makeHeadAlbedo(const HeadAtlas& atlas, const Look& look, bool relative) {
  const Painter painter(atlas, look);
  Image image = emptyImage(atlas, 3, PixelType::U8, "head_albedo");
  // Between the charts the tone's own colour, so that small mipmaps don't darken.
  const glm::vec3 tone(toneAlbedo(look.tone));
  const glm::vec3 one = relative ? kMostRelative * tone : glm::vec3(1.0F);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) store8(image, i, toSrgb((tone / one)[static_cast<int>(i % 3)]));
  forTexels(atlas, 1, [&](std::size_t, std::size_t, std::size_t index) {
    const glm::vec3 albedo = painter.albedo(placeOf(atlas, index, painter.regions())) / one;
    for (std::size_t c = 0; c < 3; ++c) store8(image, 3 * index + c, toSrgb(albedo[static_cast<int>(c)]));
  });
  return image;
}

Image makeHeadRegion(const HeadAtlas& atlas, HeadRegion region) {
  const HeadRegions regions;
  Image image = emptyImage(atlas, 1, PixelType::U8, "head_region");
  forTexels(atlas, 1, [&](std::size_t, std::size_t, std::size_t index) {
    store8(image, index, regions.at(atlas.rest[index])[region]);
  });
  return image;
}

Image makeHeadBaked(const Head& head, HeadMap map, int size) {
  MeshBakeOptions options;
  options.millimetresPerUnit = head.model.millimetresPerUnit;
  // As the renderer asks for it, so that the two share a file: the cornea stops no light.
  for (const ModelSlot& slot : head.model.slots)
    options.castingSlots.push_back(slot.imported.model != ShadingModel::Lens);
  options.cacheFolder = userCacheFolder("bakes");
  const auto baked = bakeMesh(head.model, options);
  if (!baked) return {};
  // The atlas interpolates positions; here they are numbers to be interpolated.
  Head numbers = head;
  for (std::size_t v = 0; v < numbers.rest.size(); ++v) {
    const VertexBake& of = (*baked)->vertices[v];
    numbers.rest[v] = {occlusionOf(of.hiddenSky), std::clamp(of.thicknessMm, 0.0F, kHeadThickestMm), 0.0F};
  }
  const HeadAtlas atlas = rasteriseHead(numbers, size);
  const bool thickness = map == HeadMap::Thickness;
  Image image = emptyImage(atlas, 1, thickness ? PixelType::U16 : PixelType::U8,
                           headMapNames().at(static_cast<std::size_t>(map)));
  for (std::size_t i = 0; i < atlas.rest.size(); ++i) {
    const glm::vec3 value = atlas.covered[i] != 0 ? atlas.rest[i] : glm::vec3(1.0F, kHeadThickestMm, 0.0F);
    if (thickness)
      store16(image, i, value.y / kHeadThickestMm);
    else
      store8(image, i, value.x);
  }
  return image;
}

HeadMaps makeHeadRelief(const HeadAtlas& atlas, const Look& look) {
  HeadMaps maps;
  const auto add = [&](HeadMap map, int channels, PixelType type) -> Image& {
    const auto index = static_cast<std::size_t>(map);
    return maps.images.at(index) = emptyImage(atlas, channels, type, headMapNames().at(index));
  };
  Image& normal = add(HeadMap::Normal, 3, PixelType::U16);
  Image& displacement = add(HeadMap::Displacement, 1, PixelType::U16);
  Image& roughness = add(HeadMap::Roughness, 1, PixelType::U8);
  Image& cavity = add(HeadMap::Cavity, 1, PixelType::U8);
  Image& detail = add(HeadMap::Detail, 1, PixelType::U8);
  const HeadRegions regions;
  const std::size_t texels = atlas.rest.size();
  std::vector<float> heights(texels, 0.0F);
  for (std::size_t i = 0; i < texels; ++i) {
    store8(roughness, i, 0.5F);
    store8(cavity, i, 1.0F);
    store16(displacement, i, 0.5F);
    for (std::size_t c = 0; c < 3; ++c) store16(normal, 3 * i + c, c == 2 ? 1.0F : 0.5F);
  }
  forTexels(atlas, 1, [&](std::size_t, std::size_t, std::size_t index) {
    const SkinPlace place = placeOf(atlas, index, regions);
    heights[index] = reliefHeight(place, regions, look, atlas.millimetresPerTexel);
    store8(roughness, index, skinRoughness(place, look));
    store8(detail, index, fineRelief(place));
  });
  const Relief relief(atlas, std::move(heights));
  forTexels(atlas, 1, [&](std::size_t x, std::size_t y, std::size_t index) {
    store16(displacement, index, 0.5F + relief.height(index) / kHeadReliefMm);
    const glm::vec3 n = glm::normalize(glm::vec3(-relief.slope(x, y), 1.0F));
    for (std::size_t c = 0; c < 3; ++c) store16(normal, 3 * index + c, 0.5F + 0.5F * n[static_cast<int>(c)]);
    constexpr float kDeep = 0.12F;  // mm below the surroundings where a fold is dark
    store8(cavity, index, 1.0F + std::clamp(relief.overSurroundings(x, y) / kDeep, -0.75F, 0.0F));
  });
  return maps;
}

}  // namespace dermis
