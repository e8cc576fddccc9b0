// From an environment's images to what the GPU samples: a sharp cube, GGX-prefiltered cubes and an irradiance cube.
// No OpenGL: runs on TBB workers, so a window never waits for it.
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <stop_token>
#include <vector>

#include "core/base/result.h"
#include "core/scene/resolved_scene.h"
#include "lighting/radiance_image.h"

namespace dermis {

struct EnvironmentBakeOptions {
  std::filesystem::path cacheFolder;  ///< empty: no disk cache
  int maximumSharpFace = 1024;        ///< texels a side of the sharp cube; 512 is enough for software GL
};

/// Sizes, times and counts, as `dermis bake environment` writes them to bake.json.
struct EnvironmentFigures {
  int sharpFaceSize = 0, prefilteredFaceSize = 0, irradianceFaceSize = 0;
  bool floatStorage = false;  ///< RGBA32F: a constant, or the range passes what the smaller formats hold
  bool fromCache = false;
  CleanedTexels cleaned;
  double cleanMs = 0, sourcesMs = 0, sharpMs = 0, prefilterMs = 0, irradianceMs = 0, cacheMs = 0,
         totalMs = 0;  ///< wall
};

/// How a cube's texels are kept: RGBA floats, RGBA half floats, or RGB with one exponent (shared_exponent.h).
enum class TexelStorage : std::uint8_t { Float, Half, SharedExponent };
[[nodiscard]] constexpr std::size_t bytesPerTexel(TexelStorage storage) {
  return storage == TexelStorage::Float ? 16 : storage == TexelStorage::Half ? 8 : 4;
}

/// One cube map: texels level by level, in each level layer-face by layer-face (layer · 6 + face), row 0 at t = 0.
struct CubeTexels {
  int faceSize = 1;
  int layers = 1;  ///< cubes of an array
  int levels = 1;
  TexelStorage storage = TexelStorage::Half;
  std::span<const std::byte> bytes;
  [[nodiscard]] int size(int level) const { return faceSize >> level > 0 ? faceSize >> level : 1; }
};

/// Everything of one environment; immutable. Values are radiance / scale. Radiance takes the small format: its error
/// of 2⁻⁹ is a quarter of what 8 bits of sRGB show; irradiance, a hundredth of the bytes, keeps halves.
struct BakedEnvironment {
  CubeTexels sharp, prefiltered, irradiance;
  float scale = 1.0F;  ///< a power of two that keeps dim environments out of the denormals
  EnvironmentFigures figures;
  Warnings warnings;
  std::shared_ptr<const void> storage;  ///< what the spans point into: memory, or a mapped cache file
};

/// 0..1, written by the bake, read by a progress bar.
using BakeProgress = std::atomic<float>;

/// Changes whenever the same image would give other texels; part of the cache's key.
inline constexpr std::uint32_t kEnvironmentBakeVersion = 3;

/// Reads the cache or bakes (and writes the cache). Errors: Cancelled.
[[nodiscard]] Result<std::shared_ptr<const BakedEnvironment>> bakeEnvironment(const EnvironmentImages& images,
                                                                              const EnvironmentBakeOptions& options,
                                                                              const std::stop_token& stop = {},
                                                                              BakeProgress* progress = nullptr);

}  // namespace dermis
