// A rig as the lat-long image that lights a scene.
#pragma once

#include <memory>
#include <stop_token>

#include "core/base/result.h"
#include "core/image/image.h"
#include "core/light_rig/light_rig.h"

namespace dermis {

/// `width`×`width`/2 RGB floats in linear Rec.709; 0: as wide as the rig says. A texel holds the mean radiance over its
/// solid angle, so that sums over texels are integrals however small a lamp is. The same rig gives the same bytes.
/// Errors: Cancelled.
[[nodiscard]] Result<std::shared_ptr<const Image>> rigPicture(const LightRig& rig, int width = 0,
                                                              const std::stop_token& stop = {});

/// What arrives on a surface at the subject with this normal: the sum over the texels of a lat-long image.
[[nodiscard]] glm::dvec3 irradianceOf(const Image& latLong, const glm::dvec3& normal);

}  // namespace dermis
