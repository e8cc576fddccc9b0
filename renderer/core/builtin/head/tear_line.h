// The tears that stand along the lower lid: a narrow concave strip from the lid's margin to the eyeball.
#pragma once

#include "core/builtin/head/sculpt.h"
#include "core/scene/model.h"

namespace dermis::sculpt {

/// Both eyes' strips, mm, slot "lens", where the face has been made asymmetrical; `pieces` quads along each. About
/// 0.3 mm high in the middle, nothing in the corners.
[[nodiscard]] Model makeTearLine(const Sculpt& sculpt, int pieces);

}  // namespace dermis::sculpt
