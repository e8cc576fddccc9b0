#include "lighting/environment_bake.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>

#include "lighting/environment_cache.h"
#include "lighting/ggx_prefilter.h"
#include "lighting/half_float.h"
#include "lighting/radiance_tree.h"
#include "lighting/roughness_nodes.h"
#include "lighting/sharp_cube.h"

namespace dermis {
namespace {

constexpr int kIrradianceFace = 128;
/// While a lamp of the environment is dragged: as much as shows where it is.
constexpr int kPreviewFace = 32, kPreviewIrradianceFace = 16;
constexpr float kHalfMax = 65504.0F;

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

/// A power of two to divide by, so that half floats hold the peak without pushing the mean into the denormals; 0 where
/// none does.
float halfScale(float peak, float mean) {
  float scale = 1.0F;
  if (mean > 0.0F && mean < 0x1p-6F) scale = std::exp2(std::floor(std::log2(std::max(mean, 1.0e-30F))));
  if (peak / scale > kHalfMax) scale = std::exp2(std::ceil(std::log2(peak / kHalfMax)));
  return mean / scale < 0x1p-6F && peak > kHalfMax * scale * 0x1p-8F ? 0.0F : scale;
}

std::shared_ptr<BakedEnvironment> pack(const Parts& parts) {
  auto baked = std::make_shared<BakedEnvironment>();
  const float half = halfScale(parts.peak, parts.mean);
  baked->floatStorage = half == 0.0F;
  baked->scale = baked->floatStorage ? 1.0F : half;
  const std::size_t bytesPerValue = baked->floatStorage ? sizeof(float) : sizeof(std::uint16_t);

  std::size_t values = 0;
  for (const Cubes* cubes : {&parts.sharp, &parts.prefiltered, &parts.irradiance}) {
    for (const auto& level : cubes->levels) values += level.size();
  }
  auto storage = std::make_shared<std::vector<std::byte>>(values * bytesPerValue);
  std::byte* out = storage->data();
  const float inverse = 1.0F / baked->scale;
  const auto packCubes = [&](const Cubes& cubes, CubeTexels& texels) {
    texels = cubes.shape;
    const std::byte* begin = out;
    for (const auto& level : cubes.levels) {
      if (baked->floatStorage) {
        std::memcpy(out, level.data(), level.size() * sizeof(float));
      } else {
        constexpr std::size_t kChunk = 4096;
        tbb::parallel_for(std::size_t{0}, (level.size() + kChunk - 1) / kChunk, [&](std::size_t chunk) {
          std::array<float, kChunk> scaled{};
          std::array<std::uint16_t, kChunk> halves{};
          const std::size_t first = chunk * kChunk;
          const std::size_t count = std::min(kChunk, level.size() - first);
          for (std::size_t i = 0; i < count; ++i) scaled[i] = level[first + i] * inverse;
          toHalf(std::span(scaled).first(count), halves.data());
          std::memcpy(out + first * sizeof(std::uint16_t), halves.data(), count * sizeof(std::uint16_t));
        });
      }
      out += level.size() * bytesPerValue;
    }
    texels.bytes = {begin, out};
  };
  packCubes(parts.sharp, baked->sharp);
  packCubes(parts.prefiltered, baked->prefiltered);
  packCubes(parts.irradiance, baked->irradiance);
  baked->storage = std::move(storage);
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
  cubes.shape = {faceSize, kPrefilterLayers, kPrefilterLevels, {}};
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
  auto baked = pack(parts);
  figures.sharpFaceSize = baked->sharp.faceSize;
  figures.prefilteredFaceSize = baked->prefiltered.faceSize;
  figures.irradianceFaceSize = baked->irradiance.faceSize;
  figures.floatStorage = baked->floatStorage;
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
