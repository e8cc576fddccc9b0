#include "lighting/bake_readback.h"

#include <chrono>
#include <cstring>

#include "lighting/cube_geometry.h"
#include "lighting/lighting_probe.h"
#include "lighting/spherical_harmonics.h"

namespace dermis {
namespace {

Image floatImage(int width, int height, const std::vector<glm::vec3>& pixels, std::string name) {
  Image image;
  image.width = width;
  image.height = height;
  image.channels = 3;
  image.type = PixelType::Float;
  image.name = std::move(name);
  static_assert(sizeof(glm::vec3) == 3 * sizeof(float));
  image.pixels.resize(pixels.size() * sizeof(glm::vec3));
  std::memcpy(image.pixels.data(), pixels.data(), image.pixels.size());
  return image;
}

/// The direction of each lat-long texel, in the query's form.
template <class MakeQuery>
std::vector<LightingQuery> latLongQueries(const MakeQuery& makeQuery) {
  std::vector<LightingQuery> queries;
  queries.reserve(std::size_t{kReadbackWidth} * kReadbackHeight);
  for (int j = 0; j < kReadbackHeight; ++j) {
    for (int i = 0; i < kReadbackWidth; ++i) {
      queries.push_back(makeQuery(latLongDirection((i + 0.5) / kReadbackWidth, (j + 0.5) / kReadbackHeight)));
    }
  }
  return queries;
}

}  // namespace

Result<EnvironmentReadback> readBackEnvironment(const std::shared_ptr<const EnvironmentImages>& images,
                                                std::span<const float> perceptualRoughnesses,
                                                const EnvironmentBakeOptions& options, Warnings& warnings) {
  EnvironmentReadback out;
  out.sphericalHarmonics = sphericalHarmonics9(RadianceMap(*images));
  const auto map = makeEnvironmentMap(images, options, warnings);
  if (!map) return tl::unexpected(map.error());
  out.figures = (*map)->figures();

  const auto start = std::chrono::steady_clock::now();
  gl::ShaderLibrary shaders;
  const auto irradiance = probeLighting(
      shaders, map->get(), latLongQueries([](const glm::vec3& d) { return LightingQuery::irradiance(d); }));
  if (!irradiance) return tl::unexpected(irradiance.error());
  out.irradiance = floatImage(kReadbackWidth, kReadbackHeight, *irradiance, "irradiance");
  for (float r : perceptualRoughnesses) {
    const auto prefiltered = probeLighting(
        shaders, map->get(), latLongQueries([r](const glm::vec3& d) { return LightingQuery::prefiltered(d, r); }));
    if (!prefiltered) return tl::unexpected(prefiltered.error());
    out.prefiltered.push_back(floatImage(kReadbackWidth, kReadbackHeight, *prefiltered, "prefiltered"));
  }
  out.readbackMs = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  return out;
}

Result<Image> readBackDfg(DfgGeometry geometry, int size) {
  std::vector<LightingQuery> queries;
  queries.reserve(static_cast<std::size_t>(size) * static_cast<std::size_t>(size));
  const auto centre = [size](int i) { return (static_cast<float>(i) + 0.5F) / static_cast<float>(size); };
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) queries.push_back(LightingQuery::dfg(geometry, centre(x), centre(y)));
  }
  gl::ShaderLibrary shaders;
  const auto values = probeLighting(shaders, nullptr, queries);
  if (!values) return tl::unexpected(values.error());
  return floatImage(size, size, *values, "dfg");
}

}  // namespace dermis
