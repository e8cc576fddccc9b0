// From light that enters the body to light that leaves it.
#pragma once

#include "passes/frame_context.h"

namespace dermis {

/// Adds the body's light to the picture, and keeps it before and after diffusion where the targets do.
void subsurfacePass(const FrameContext& frame);
[[nodiscard]] gl::ProgramSources composeProgram();

}  // namespace dermis
