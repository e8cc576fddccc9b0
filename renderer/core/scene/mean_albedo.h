// A material's albedo as one colour.
#pragma once

#include "core/scene/resolved_scene.h"

namespace dermis {

/// The mean of a slot's albedo map over the surface that wears it, so that what lies between the islands of a texture
/// doesn't count; 1 without a map. Looks at a few thousand texels, sRGB decoded for 8 and 16-bit maps unless they say
/// "linear" or "raw"; other colour spaces are taken for sRGB, which is near enough for a mean.
[[nodiscard]] glm::vec3 meanOfAlbedoMap(const ResolvedScene& scene, std::size_t slot);
/// base.albedo times that: the A of a material's diffusion profile.
[[nodiscard]] glm::vec3 meanAlbedo(const ResolvedScene& scene, std::size_t slot);

}  // namespace dermis
