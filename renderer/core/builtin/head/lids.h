// Eyelids: where they open, and how the solid round the eyeball is cut for it.
#pragma once

#include <glm/glm.hpp>

#include "core/builtin/head/profile.h"

namespace dermis::sculpt {

/// The left eyeball, mm; the right one is its mirror image.
inline constexpr glm::vec3 kEyeCentre(31.5F, 0.0F, 72.5F);
inline constexpr float kEyeRadius = 12.0F;
/// The lids' outer faces lie on this sphere: 2.1 mm of lid.
inline constexpr float kLidRadius = 14.1F;
/// Air between lid and eyeball, which the tear film fills.
inline constexpr float kLidGap = 0.12F;

class Lids {
 public:
  Lids();
  /// The lids' swelling joined to the face; q has x > 0.
  [[nodiscard]] float swell(float face, const glm::vec3& q) const;
  /// The fissure and the socket cut out, the caruncle in its corner added.
  [[nodiscard]] float cut(float face, const glm::vec3& q) const;
  /// Signed distance in the frontal plane to the fissure's outline, negative where the eye is open.
  [[nodiscard]] float opening(const glm::vec3& q) const;
  /// Height of the upper and the lower lid's edge over the eye's centre, at `x` mm outwards of it.
  [[nodiscard]] float upperEdge(float x) const { return m_upper(x); }
  [[nodiscard]] float lowerEdge(float x) const { return m_lower(x); }

 private:
  Profile m_upper, m_lower, m_floor;
};

}  // namespace dermis::sculpt
