// A material's albedo as one colour.
#pragma once

#include "core/scene/resolved_scene.h"

namespace dermis {

/// base.albedo, times the mean of the albedo map where there is one: over the surface that wears it, so that what lies
/// between the islands of a texture doesn't count. Looks at a few thousand texels, sRGB decoded for 8 and 16-bit maps
/// unless they say "linear" or "raw"; other colour spaces are taken for sRGB, which is near enough for a mean.
[[nodiscard]] glm::vec3 meanAlbedo(const ResolvedScene& scene, std::size_t slot);

}  // namespace dermis
