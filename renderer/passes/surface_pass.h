// The model: opaque parts first, blended ones after the sky.
#pragma once

#include "passes/frame_context.h"

namespace dermis {

/// The program of a shading model; `withAovs` writes all images that the targets keep.
[[nodiscard]] gl::ProgramSources surfaceProgram(ShadingModel model, bool withAovs);

/// Opaque parts, depth tested and written.
void surfacePass(const FrameContext& frame);

/// Lenses and blended materials, premultiplied over what is there, far ones first. A blended part shows its back faces,
/// then its front ones; its own triangles are not sorted further.
void transparentPass(const FrameContext& frame);
[[nodiscard]] bool hasTransparentParts(const SceneResources& resources);

}  // namespace dermis
