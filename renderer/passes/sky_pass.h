// What surrounds the model: background and visible lamps.
#pragma once

#include "passes/frame_context.h"

namespace dermis {

/// What the beauty is cleared to before anything is drawn.
[[nodiscard]] glm::vec4 backgroundClearColour(const FrameContext& frame);

/// The environment, its irradiance or a prefiltered mip wherever no surface is. Nothing for the other backgrounds.
void skyPass(const FrameContext& frame);

/// Lamps marked visible, as spheres of radius_mm whose radiance is intensity / (π r²), r in scene units: the radiance
/// that makes a sphere's irradiance that of the lamp. Directional lights are nowhere, so they have none.
void lampPass(const FrameContext& frame);
[[nodiscard]] bool hasVisibleLamps(const ResolvedScene& scene);

}  // namespace dermis
