// The triangles of a model that stop light, to shoot rays at. Embree inside.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/base/result.h"
#include "core/scene/model.h"

namespace dermis {

/// Immutable once made; rays may be shot from any number of threads. Keeps what it needs of the model.
class RayScene {
 public:
  /// A place on a triangle, as barycentric weights of its second and third corner.
  struct Hit {
    float distance = 0.0F;
    std::uint32_t triangle = 0;
    glm::vec2 weights{0.0F};
  };

  /// `castingSlots[i]` says whether slot i stops light; shorter lists mean true for the rest. Errors: Runtime, where
  /// Embree cannot work.
  [[nodiscard]] static Result<RayScene> create(const Model& model, const std::vector<bool>& castingSlots);
  RayScene(RayScene&&) noexcept;
  RayScene& operator=(RayScene&&) noexcept;
  ~RayScene();

  /// For each direction whether anything, seen from either side, lies that way.
  void blocked(const glm::vec3& origin, std::span<const glm::vec3> directions, std::span<bool> result) const;
  /// The first triangle each direction meets, from either side; nothing where that way is open.
  void firstHits(const glm::vec3& origin, std::span<const glm::vec3> directions,
                 std::span<std::optional<Hit>> result) const;
  /// Whether a ray that way meets the triangle's outer side.
  [[nodiscard]] bool meetsOutside(const Hit& hit, const glm::vec3& direction) const {
    return glm::dot(m_outward[hit.triangle], direction) < 0.0F;
  }
  /// Where a ray that starts inside the material leaves it: through a triangle that faces the way the ray goes. What it
  /// enters on the way is another body inside this one, and is passed through; so is one that begins within `contact`
  /// of where the first ends: they touch, as an eyelid and its eyeball do.
  [[nodiscard]] std::optional<Hit> exitAlong(const glm::vec3& origin, const glm::vec3& direction, float contact) const;

  /// Vertices of the model that a triangle joins.
  [[nodiscard]] const glm::uvec3& corners(std::uint32_t triangle) const { return m_corners[triangle]; }
  /// A length that is nothing beside the model, and more than rounding can move a point by.
  [[nodiscard]] float bias() const { return m_bias; }

 private:
  RayScene() = default;
  struct Handles;
  std::unique_ptr<Handles> m_handles;
  std::vector<glm::uvec3> m_corners;
  std::vector<glm::vec3> m_outward;  ///< normal of each triangle, not of unit length, on the vertex normals' side
  float m_bias = 0.0F;
};

}  // namespace dermis
