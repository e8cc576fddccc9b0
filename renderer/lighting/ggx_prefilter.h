// Radiance filtered with GGX lobes, without noise.
#pragma once

#include <functional>
#include <span>
#include <stop_token>
#include <vector>

#include "lighting/radiance_tree.h"

namespace dermis {

/// For each texel of a cube of faceSize² a face (a power of two ≥ 32) and each alpha: the mean of the radiance weighted
/// by D_GGX(h) (n·l), with n = v = the texel's direction (Karis 2013, the split sum's first half; D by Trowbridge &
/// Reitz 1975). alpha 1 is the clamped cosine, so its result is irradiance / π.
///
/// Returns RGB and 1 interleaved: [alpha][face][row][column]. Texels are set so that reading them bilinearly is right
/// on average, not only at their centres. `progress` is called with 0..1 from several threads; empty when stopped.
[[nodiscard]] std::vector<float> prefilterGgx(const RadianceTree& tree, int faceSize, std::span<const float> alphas,
                                              std::stop_token stop = {},
                                              const std::function<void(float)>& progress = {});

}  // namespace dermis
