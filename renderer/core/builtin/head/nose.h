// The nose: bridge, tip, wings, columella, nostrils.
#pragma once

#include <glm/glm.hpp>

#include "core/builtin/head/stroke.h"

namespace dermis::sculpt {

class Nose {
 public:
  Nose();
  [[nodiscard]] float join(float face, const glm::vec3& p) const;
  /// q has x > 0, rounded at the middle.
  [[nodiscard]] float cutNostrils(float face, const glm::vec3& q) const;
  /// Distance to the hollow of the nostril.
  [[nodiscard]] static float nostril(const glm::vec3& q);

 private:
  [[nodiscard]] float bridge(const glm::vec3& p) const;
  [[nodiscard]] float lobule(const glm::vec3& p) const;
  Stroke m_dorsum, m_flank, m_columella, m_rim;
};

}  // namespace dermis::sculpt
