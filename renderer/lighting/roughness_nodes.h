// At which perceptual roughnesses an environment is prefiltered, and where they lie in the cube array.
//
// Four mip levels (256², 128², 64², 32² texels a face) of six layers: 24 nodes, six to a resolution. Node j lies in
// level j / 6, layer j mod 6, so the shader reads two of them bilinearly and mixes: no trilinear fetch. Node 0 is the
// unfiltered image. The spacing keeps neighbouring lobes within a factor 1.3 in alpha, the resolutions keep a texel
// below about half the lobe's half width.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

namespace dermis {

inline constexpr int kPrefilterLevels = 4;
inline constexpr int kPrefilterLayers = 6;
inline constexpr int kPrefilterNodes = kPrefilterLevels * kPrefilterLayers;
inline constexpr int kPrefilterFaceSize = 256;  ///< of level 0

/// The fractional node for a perceptual roughness 0..1. Nodes are evenly spaced in roughness below 0.1, in its logarithm
/// from 0.1 to 0.25 (7 steps) and to 0.5 (6 steps), and evenly again to 1 (8 steps), so 0.1, 0.25, 0.5, 0.75 and 1 are
/// nodes themselves. environmentPrefiltered() in environment.glsl computes the same.
[[nodiscard]] inline float prefilterNode(float perceptualRoughness) {
  const float r = std::clamp(perceptualRoughness, 0.0F, 1.0F);
  const float octaves = std::log2(std::max(r, 0.1F));
  return 20.0F * std::min(r, 0.1F) + (7.0F / 1.32192809F) * std::min(octaves + 3.32192809F, 1.32192809F) +
         6.0F * std::clamp(octaves + 2.0F, 0.0F, 1.0F) + 16.0F * std::clamp(r - 0.5F, 0.0F, 0.5F);
}

/// The perceptual roughness of each node.
[[nodiscard]] inline std::array<float, kPrefilterNodes> prefilterRoughnesses() {
  std::array<float, kPrefilterNodes> r{};
  for (int j = 0; j < kPrefilterNodes; ++j) {
    const auto f = static_cast<float>(j);
    auto& value = r[static_cast<std::size_t>(j)];
    if (j <= 2) value = 0.05F * f;
    else if (j <= 9) value = 0.1F * std::pow(2.5F, (f - 2.0F) / 7.0F);
    else if (j <= 15) value = 0.25F * std::exp2((f - 9.0F) / 6.0F);
    else value = 0.5F + (f - 15.0F) / 16.0F;
  }
  return r;
}

}  // namespace dermis
