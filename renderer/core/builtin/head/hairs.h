// Brows and lashes: each hair a thin tapered tube.
#pragma once

#include "core/builtin/head/sculpt.h"
#include "core/scene/model.h"

namespace dermis::sculpt {

/// On both sides, millimetres, asymmetry applied; `pieces` along each hair. One slot, hair.
[[nodiscard]] Model makeHairs(const Sculpt& sculpt, int pieces);

}  // namespace dermis::sculpt
