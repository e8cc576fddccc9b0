// What of a model a ray meets first: for pointing at things.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/bake/ray_scene.h"

namespace dermis {

struct SurfaceHit {
  float distance = 0.0F;
  glm::vec3 position{0.0F};
  glm::vec3 normal{0.0F};  ///< interpolated vertex normal, unit
  std::uint32_t slot = 0;
};

/// Immutable once made, which takes a while for a large model; asking it takes microseconds.
class SurfacePicker {
 public:
  /// Errors: Runtime, where Embree cannot work.
  [[nodiscard]] static Result<SurfacePicker> create(std::shared_ptr<const Model> model);
  /// Seen from either side. `direction` is a unit vector.
  [[nodiscard]] std::optional<SurfaceHit> hit(const glm::vec3& origin, const glm::vec3& direction) const;

 private:
  explicit SurfacePicker(RayScene&& rays) : m_rays(std::move(rays)) {}
  std::shared_ptr<const Model> m_model;
  RayScene m_rays;
  std::vector<std::uint32_t> m_partEnds;  ///< one past each part's last triangle
};

}  // namespace dermis
