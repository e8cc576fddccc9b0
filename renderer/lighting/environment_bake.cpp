#include "lighting/environment_bake.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <bit>
#include <chrono>
#include <cmath>
#include <cstring>
#include <span>
#include <tuple>

#include "lighting/environment_cache.h"
#include "lighting/ggx_prefilter.h"
#include "lighting/half_float.h"
#include "lighting/radiance_tree.h"
#include "lighting/roughness_nodes.h"
#include "lighting/shared_exponent.h"
#include "lighting/sharp_cube.h"

namespace dermis {
namespace {

constexpr int kIrradianceFace = 128;
/// While a lamp of the environment is dragged: as much as shows where it is.
constexpr int kPreviewFace = 32, kPreviewIrradianceFace = 16;
/// What both small formats hold.
constexpr float kStorageMax = kSharedExponentMax;

class Stopwatch {
 public:
  /// Milliseconds since the last call or the start.
  double lap() {
    const auto now = std::chrono::steady_clock::now();
    const double ms = std::chrono::duration<double, std::milli>(now - m_last).count();
    m_last = now;
    return ms;
  }

 private:
  std::chrono::steady_clock::time_point m_last = std::chrono::steady_clock::now();
};

/// Cube levels as floats, before they are packed.
struct Cubes {
  CubeTexels shape;
  std::vector<std::vector<float>> levels;  ///< RGBA
};

struct Parts {
  Cubes sharp, prefiltered, irradiance;
  float peak = 0.0F, mean = 0.0F;
};

float peakOf(const std::vector<float>& values) {
  float peak = 0.0F;
  for (float v : values) peak = std::max(peak, v);
  return peak;
}

/// A power of two to divide by, so that the small formats hold the peak without pushing the mean into the denormals; 0
/// where none does.
float storageScale(float peak, float mean) {
  float scale = 1.0F;
  if (mean > 0.0F && mean < 0x1p-6F) scale = std::exp2(std::floor(std::log2(std::max(mean, 1.0e-30F))));
  if (peak / scale > kStorageMax) scale = std::exp2(std::ceil(std::log2(peak / kStorageMax)));
  return mean / scale < 0x1p-6F && peak > kStorageMax * scale * 0x1p-8F ? 0.0F : scale;
}

/// Stores values / scale at `out`.
void packLevel(const std::vector<float>& level, float scale, TexelStorage storage, std::byte* out) {
  if (storage == TexelStorage::Float) {
    std::memcpy(out, level.data(), level.size() * sizeof(float));
    return;
  }
  constexpr std::size_t kChunk = 1024;  // texels
  const std::size_t texels = level.size() / 4;
  const float inverse = 1.0F / scale;
  tbb::parallel_for(std::size_t{0}, (texels + kChunk - 1) / kChunk, [&](std::size_t chunk) {
    std::array<float, 4 * kChunk> scaled{};
    const std::size_t first = chunk * kChunk;
    const std::size_t count = std::min(kChunk, texels - first);
    for (std::size_t i = 0; i < 4 * count; ++i) scaled[i] = level[4 * first + i] * inverse;
    const std::span<const float> values = std::span(scaled).first(4 * count);
    std::byte* to = out + first * bytesPerTexel(storage);
    if (storage == TexelStorage::Half)
      toHalf(values, std::bit_cast<std::uint16_t*>(to));
    else
      toSharedExponent(values, std::bit_cast<std::uint32_t*>(to));
  });
}

std::shared_ptr<BakedEnvironment> pack(const Parts& parts, TexelStorage ofRadiance) {
  auto baked = std::make_shared<BakedEnvironment>();
  const float small = storageScale(parts.peak, parts.mean);
  const bool floats = small == 0.0F || ofRadiance == TexelStorage::Float;
  baked->scale = floats ? 1.0F : small;
  const std::array packed = {
      std::tuple{&parts.sharp, &baked->sharp, floats ? TexelStorage::Float : ofRadiance},
      std::tuple{&parts.prefiltered, &baked->prefiltered, floats ? TexelStorage::Float : ofRadiance},
      std::tuple{&parts.irradiance, &baked->irradiance, floats ? TexelStorage::Float : TexelStorage::Half}};

  std::size_t bytes = 0;
  for (const auto& [cubes, texels, storage] : packed)
    for (const auto& level : cubes->levels) bytes += level.size() / 4 * bytesPerTexel(storage);
  auto memory = std::make_shared<std::vector<std::byte>>(bytes);
  std::byte* out = memory->data();
  for (const auto& [cubes, texels, storage] : packed) {
    *texels = cubes->shape;
    texels->storage = storage;
    const std::byte* begin = out;
    for (const auto& level : cubes->levels) {
      packLevel(level, baked->scale, storage, out);
      out += level.size() / 4 * bytesPerTexel(storage);
    }
    texels->bytes = {begin, out};
  }
  baked->storage = std::move(memory);
  return baked;
}

/// A constant environment needs one texel, and keeps its value to the last bit.
Parts constantParts(const glm::vec3& value) {
  const auto cube = [&](int layers) {
    Cubes cubes;
    cubes.shape.layers = layers;
    cubes.levels.resize(1);
    for (int i = 0; i < 6 * layers; ++i) {
      cubes.levels[0].insert(cubes.levels[0].end(), {value.x, value.y, value.z, 1.0F});
    }
    return cubes;
  };
  const float peak = std::max({value.x, value.y, value.z});
  return {cube(1), cube(kPrefilterLayers), cube(1), peak, peak};
}

Cubes sharpCubes(const RadianceMap& map, int faceSize) {
  Cubes cubes;
  cubes.shape.faceSize = faceSize;
  cubes.levels.push_back(resampleToCube(map, faceSize));
  for (int n = faceSize; n > 1; n /= 2) cubes.levels.push_back(halveCube(cubes.levels.back(), n));
  cubes.shape.levels = static_cast<int>(cubes.levels.size());
  return cubes;
}

/// All nodes but the first, which is the sharp cube at the size of level 0.
Cubes prefilteredCubes(const RadianceMap& map, const RadianceTree& tree, const Cubes& sharp, int faceSize,
                       const std::stop_token& stop, const std::function<void(float)>& progress) {
  const auto roughnesses = prefilterRoughnesses();
  Cubes cubes;
  cubes.shape.faceSize = faceSize;
  cubes.shape.layers = kPrefilterLayers;
  cubes.shape.levels = kPrefilterLevels;
  for (int l = 0; l < kPrefilterLevels; ++l) {
    std::vector<float> alphas;
    for (int k = l == 0 ? 1 : 0; k < kPrefilterLayers; ++k) {
      const int node = l * kPrefilterLayers + k;
      const float r = roughnesses[static_cast<std::size_t>(node)];
      alphas.push_back(r * r);
    }
    // The first level is nine tenths of the work.
    auto texels = prefilterGgx(tree, std::max(faceSize >> l, 1), alphas, stop, [&](float f) {
      if (progress) progress(l == 0 ? 0.8F * f : 0.8F + 0.1F * (static_cast<float>(l - 1) + f));
    });
    if (l == 0) {
      std::size_t level = 0;
      while ((sharp.shape.faceSize >> level) > faceSize) ++level;
      const std::vector<float> unfiltered =
          (sharp.shape.faceSize >> level) == faceSize ? sharp.levels[level] : resampleToCube(map, faceSize);
      texels.insert(texels.begin(), unfiltered.begin(), unfiltered.end());
    }
    cubes.levels.push_back(std::move(texels));
    if (stop.stop_requested()) break;
  }
  return cubes;
}

std::string cleanedSentence(const std::string& name, const CleanedTexels& cleaned) {
  return fmt::format("{}: {} negative and {} non-finite values were repaired", name.empty() ? "the environment" : name,
                     cleaned.negative, cleaned.nonFinite);
}

Result<std::shared_ptr<BakedEnvironment>> bake(const EnvironmentImages& images, const EnvironmentBakeOptions& options,
                                               const std::stop_token& stop, BakeProgress* progress) {
  const auto report = [&](float f) {
    if (progress != nullptr) progress->store(f);
  };
  Stopwatch total;
  Stopwatch watch;
  EnvironmentFigures figures;
  const RadianceMap map(images);
  figures.cleaned = map.cleaned;
  figures.cleanMs = watch.lap();

  Parts parts;
  if (map.layout == RadianceMap::Layout::Constant) {
    parts = constantParts(map.constant);
  } else {
    parts.sharp = sharpCubes(map, sharpFaceSize(map.pixelsPerFace(), options.maximumSharpFace));
    figures.sharpMs = watch.lap();
    report(0.05F);
    if (stop.stop_requested()) return cancelledError();
    const RadianceTree tree(map);
    figures.sourcesMs = watch.lap();
    report(0.1F);
    if (stop.stop_requested()) return cancelledError();
    const int irradianceFace = images.preview ? kPreviewIrradianceFace : kIrradianceFace;
    parts.irradiance.shape.faceSize = irradianceFace;
    parts.irradiance.levels.push_back(prefilterGgx(tree, irradianceFace, std::array{1.0F}, stop));
    figures.irradianceMs = watch.lap();
    report(0.15F);
    const int prefilteredFace = images.preview ? kPreviewFace : kPrefilterFaceSize;
    parts.prefiltered =
        prefilteredCubes(map, tree, parts.sharp, prefilteredFace, stop, [&](float f) { report(0.15F + 0.8F * f); });
    figures.prefilterMs = watch.lap();
    if (stop.stop_requested()) return cancelledError();
    parts.peak = std::max(peakOf(parts.sharp.levels[0]), peakOf(parts.prefiltered.levels[0]));
    for (const RadianceSource& face : tree.level(0)) {
      parts.mean += (face.red + face.green + face.blue) / (3.0F * 4.0F * 3.14159265F);
    }
  }
  const bool constant = map.layout == RadianceMap::Layout::Constant;
  auto baked = pack(parts, constant ? TexelStorage::Float : TexelStorage::SharedExponent);
  figures.sharpFaceSize = baked->sharp.faceSize;
  figures.prefilteredFaceSize = baked->prefiltered.faceSize;
  figures.irradianceFaceSize = baked->irradiance.faceSize;
  figures.floatStorage = baked->sharp.storage == TexelStorage::Float;
  figures.totalMs = total.lap();
  baked->figures = figures;
  return baked;
}

}  // namespace

Result<std::shared_ptr<const BakedEnvironment>> bakeEnvironment(const EnvironmentImages& images,
                                                                const EnvironmentBakeOptions& options,
                                                                const std::stop_token& stop, BakeProgress* progress) {
  Stopwatch watch;
  const bool isConstant = !images.latLong && !images.faces[0];
  // Without a hash there is no name to find it again by, and a constant is quicker made than read.
  const bool cached = !options.cacheFolder.empty() && images.contentHash != 0 && !isConstant && !images.preview;
  std::shared_ptr<BakedEnvironment> baked;
  if (cached) baked = readEnvironmentCache(options, images);
  if (baked) {
    baked->figures.cacheMs = watch.lap();
    baked->figures.totalMs = baked->figures.cacheMs;
  } else {
    auto fresh = bake(images, options, stop, progress);
    if (!fresh) return tl::unexpected(fresh.error());
    baked = std::move(*fresh);
    if (cached) {
      watch.lap();
      // A full disk or a read-only folder costs time at the next start, nothing else.
      writeEnvironmentCache(options, images, *baked);
      baked->figures.cacheMs = watch.lap();
      baked->figures.totalMs += baked->figures.cacheMs;
    }
  }
  if (baked->figures.cleaned.total() > 0) {
    baked->warnings.push_back(cleanedSentence(images.name, baked->figures.cleaned));
  }
  if (progress != nullptr) progress->store(1.0F);
  return std::shared_ptr<const BakedEnvironment>(std::move(baked));
}

}  // namespace dermis
