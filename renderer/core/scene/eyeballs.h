// The eyeballs of a mesh: where they are and where they look.
#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <vector>

#include "core/scene/model.h"

namespace dermis {

inline constexpr std::size_t kMostEyeballs = 4;

struct Eyeball {
  glm::vec3 centre{0.0F};
  float radius = 1.0F;
  /// Unit, from the centre through the pupil.
  glm::vec3 axis{0.0F, 0.0F, 1.0F};
  /// Change of the texture coordinates along the eye's x and y axes, (du/dx, du/dy, dv/dx, dv/dy), for lengths in
  /// radii, over its front. Zero where they do not follow a linear map there.
  glm::vec4 uvGradient{0.0F};

  /// Right of the eye as it looks, seen from the front: x and y span the plane of the iris.
  [[nodiscard]] glm::vec3 x() const;
  [[nodiscard]] glm::vec3 y() const { return glm::cross(axis, x()); }
};

/// Each connected piece of the part that doesn't lie inside another is an eyeball; the largest kMostEyeballs are kept.
/// A sphere is fitted to it, and it looks along what departs from that sphere (a hollow iris, a cornea's bulge), else
/// away from its open back, else along +Z.
[[nodiscard]] std::vector<Eyeball> findEyeballs(const Model& model, const ModelPart& part);

}  // namespace dermis
