// From light that enters the body to light that leaves it.
#pragma once

#include <vector>

#include "passes/frame_context.h"

namespace dermis {

enum class DiffusionQuality {
  Separable,  ///< two passes of few taps, for moving pictures
  Disc        ///< a gather that converges over the samples of a still picture
};

/// Adds the body's light to the picture, and keeps it before and after diffusion where the targets do.
void subsurfacePass(const FrameContext& frame, DiffusionQuality quality);
/// The programs for a scene with so many different profiles, in the order of their use.
[[nodiscard]] std::vector<gl::ProgramSources> subsurfacePrograms(DiffusionQuality quality, std::size_t profiles);

}  // namespace dermis
