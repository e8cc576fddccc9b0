// Finer levels of the head's mesh.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "core/builtin/head/charts.h"
#include "core/builtin/head/sculpt.h"

namespace dermis::sculpt {

/// Every triangle into four; the new points on the skin, their texture coordinates halfway, so that the atlas stays
/// what it was.
[[nodiscard]] AtlasMesh refined(const AtlasMesh& mesh, const Sculpt& sculpt);

/// Moves every point onto the skin a last time, but where that would turn a triangle over; the normals there.
[[nodiscard]] std::vector<glm::vec3> settled(AtlasMesh& mesh, const Sculpt& sculpt);

}  // namespace dermis::sculpt
