// The head's coarsest mesh, from which the others are refined.
#pragma once

#include "core/builtin/head/charts.h"
#include "core/builtin/head/sculpt.h"

namespace dermis::sculpt {

/// About 30,000 triangles, closed, laid flat.
[[nodiscard]] AtlasMesh coarseHeadMesh(const Sculpt& sculpt);

}  // namespace dermis::sculpt
