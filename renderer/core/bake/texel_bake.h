// Thickness and occlusion in a model's texture layout, for maps.
#pragma once

#include <atomic>
#include <stop_token>

#include "core/base/result.h"
#include "core/image/image.h"
#include "core/scene/model.h"

namespace dermis {

enum class BakedMap {
  Thickness,  ///< mm, at most kThickestMm
  Occlusion   ///< 1 in the open, 0 where nothing of the sky is seen
};

struct TexelBakeOptions {
  int size = 1024;  ///< texels a side
  float millimetresPerUnit = 1000.0F;
  std::stop_token stop;
  std::atomic<float>* progress = nullptr;  ///< 0..1
  int rays = 128;
};

/// Rays are cast from the surface under each texel's centre; where triangles share a texel, the later one counts. What
/// lies between the islands takes the value of the nearest texel that has one, so that no seam shows at any mip level.
/// One channel, Float, top row first. Errors: Input, a model without texture coordinates (`name` is its name for the
/// sentence); Cancelled; Runtime.
[[nodiscard]] Result<Image> bakeTexels(const Model& model, const std::string& name, BakedMap map,
                                       const TexelBakeOptions& options);

}  // namespace dermis
