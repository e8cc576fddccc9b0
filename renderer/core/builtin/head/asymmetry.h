// A face has a left and a right side.
#pragma once

#include <glm/glm.hpp>

namespace dermis::sculpt {

/// Where a point of the symmetrical head goes, 0.5 to 1.3 mm away, mm. Round each eye it is one translation, so that
/// the lids keep their distance from the eyeball.
[[nodiscard]] glm::vec3 asymmetrical(const glm::vec3& p);
/// The direction there of a normal of the symmetrical head.
[[nodiscard]] glm::vec3 asymmetricalNormal(const glm::vec3& p, const glm::vec3& normal);

}  // namespace dermis::sculpt
