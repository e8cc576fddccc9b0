// At which perceptual roughnesses an environment is prefiltered, and where they lie in the cube array.
//
// Three mip levels (256², 128², 64² texels a face) of seven layers: 21 nodes, seven to a resolution. Node j lies in
// level j / 7, layer j mod 7, so the shader reads two of them bilinearly and mixes: no trilinear fetch. Node 0 is the
// unfiltered image. Neighbouring lobes are within a factor 1.36 in alpha; a texel stays below the lobe's half width,
// and small enough for the bend at the horizon of the broad ones.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

namespace dermis {

inline constexpr int kPrefilterLevels = 3;
inline constexpr int kPrefilterLayers = 7;
inline constexpr int kPrefilterNodes = kPrefilterLevels * kPrefilterLayers;
inline constexpr int kPrefilterFaceSize = 256;  ///< of level 0

/// The fractional node for a perceptual roughness 0..1. Beyond the first two, nodes are evenly spaced in the logarithm
/// of the roughness from 0.1 to 0.25 (8 steps) and to 0.5 (5 steps), then in the roughness to 1 (6 steps), so 0.1,
/// 0.25, 0.5, 0.75 and 1 are nodes themselves. environmentPrefiltered() in environment.glsl computes the same.
[[nodiscard]] inline float prefilterNode(float perceptualRoughness) {
  const float r = std::clamp(perceptualRoughness, 0.0F, 1.0F);
  const float octaves = std::log2(std::max(r, 0.1F));
  return 10.0F * std::min(r, 0.1F) + (8.0F / 1.32192809F) * std::min(octaves + 3.32192809F, 1.32192809F) +
         5.0F * std::clamp(octaves + 2.0F, 0.0F, 1.0F) + 12.0F * std::clamp(r - 0.5F, 0.0F, 0.5F);
}

/// The perceptual roughness of each node.
[[nodiscard]] inline std::array<float, kPrefilterNodes> prefilterRoughnesses() {
  std::array<float, kPrefilterNodes> r{};
  for (int j = 1; j < kPrefilterNodes; ++j) {
    const auto f = static_cast<float>(j);
    auto& value = r[static_cast<std::size_t>(j)];
    if (j <= 9)
      value = 0.1F * std::pow(2.5F, (f - 1.0F) / 8.0F);
    else if (j <= 14)
      value = 0.25F * std::exp2((f - 9.0F) / 5.0F);
    else
      value = 0.5F + (f - 14.0F) / 12.0F;
  }
  return r;
}

}  // namespace dermis
