// What a point of a surface can see and how thick the material is behind it, by ray casting.
#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "core/bake/harmonics.h"
#include "core/bake/ray_scene.h"

namespace dermis {

/// Directions round +Z, the same in every run: a spiral by the golden angle whose heights are spaced so that each
/// direction stands for the same share of the cosine-weighted cone.
class RaySet {
 public:
  /// `coneDegrees` is the half angle; 90 is the whole hemisphere.
  RaySet(int count, float coneDegrees);
  /// The directions round `axis`, of unit length.
  void around(const glm::vec3& axis, std::span<glm::vec3> directions) const;
  [[nodiscard]] std::size_t size() const { return m_local.size(); }

 private:
  std::vector<glm::vec3> m_local;
};

/// The part of the sky that is hidden, ∫ (1 − V(d)) max(n·d, 0)/π Y_i(d) dω: the transfer vector of Sloan, Kautz &
/// Snyder 2002, "Precomputed Radiance Transfer", section 4.1, as what it takes away, so that what sees the whole sky
/// has zeros. Its first coefficient over Y_00 is 1 − ambient occlusion.
[[nodiscard]] Harmonics<float> hiddenSky(const RayScene& scene, const glm::vec3& position, const glm::vec3& normal,
                                         const RaySet& rays);
/// Ambient occlusion, 1 in the open.
[[nodiscard]] float occlusionOf(const Harmonics<float>& hidden);

/// How far a surface is from its far side.
struct Thickness {
  float length = 0.0F;               ///< scene units; infinite where rays don't leave
  std::vector<RayScene::Hit> exits;  ///< where the rays that the length comes from left the material
};

/// Each ray of a cone inwards, of length s at an angle θ to −n, says that the slab is s cos θ thick: exactly, on a
/// slab. The mean of the middle half of these neither minds a few rays that leave through a rim or a hole nor jumps as
/// a median does. A ray that never leaves counts as infinite. Over a sphere of radius r the rays of a 30° cone say 7/4
/// r, and not 2 r. Bodies no further apart than `contact`, in scene units, are one.
[[nodiscard]] Thickness thicknessAt(const RayScene& scene, const glm::vec3& position, const glm::vec3& normal,
                                    const RaySet& rays, float contact);
inline constexpr float kThicknessConeDegrees = 30.0F;
/// Bodies this near touch: tears fill what is between an eyelid and its eyeball, so that the lid is no thin slab in
/// air.
inline constexpr float kContactMm = 0.3F;

}  // namespace dermis
