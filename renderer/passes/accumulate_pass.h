// The running sum of jittered frames.
#pragma once

#include "passes/frame_context.h"

namespace dermis {

/// Adds the frame's images to the sums; `first` replaces what they held.
void accumulatePass(const FrameContext& frame, bool first);

}  // namespace dermis
