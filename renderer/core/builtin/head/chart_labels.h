// Which piece of the atlas a triangle belongs to, and the seam.
#pragma once

#include <set>
#include <utility>
#include <vector>

#include "core/builtin/head/charts.h"

namespace dermis::sculpt {

/// One a triangle; every chart is one connected piece.
[[nodiscard]] std::vector<Chart> labelCharts(const Surface& surface, const Sculpt& sculpt);

/// The edges (lower vertex first) of the cut at the back of the head, from near the crown down to the base.
using EdgeSet = std::set<std::pair<std::uint32_t, std::uint32_t>>;
[[nodiscard]] EdgeSet backSeam(const Surface& surface, const std::vector<Chart>& charts);

}  // namespace dermis::sculpt
