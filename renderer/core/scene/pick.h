// What of a model a ray meets first: for pointing at things, one ray at a time.
#pragma once

#include <cstdint>
#include <optional>

#include "core/scene/model.h"

namespace dermis {

struct SurfaceHit {
  float distance = 0.0F;
  glm::vec3 position{0.0F};
  glm::vec3 normal{0.0F};  ///< interpolated vertex normal, unit
  std::uint32_t slot = 0;
};

/// Looks at every triangle, seen from either side: a few milliseconds for a million, and nothing to prepare.
/// `direction` is a unit vector.
[[nodiscard]] std::optional<SurfaceHit> hitModel(const Model& model, const glm::vec3& origin,
                                                 const glm::vec3& direction);

}  // namespace dermis
