// The lips: not bodies but a height over the muzzle, between the borders and the line where they meet.
#pragma once

#include <glm/glm.hpp>

#include "core/builtin/head/profile.h"

namespace dermis::sculpt {

class Lips {
 public:
  Lips();
  /// mm outwards.
  [[nodiscard]] float raise(const glm::vec3& p) const;
  /// Heights (y) at |x|, mm.
  [[nodiscard]] float line(float x) const { return m_line(x); }
  [[nodiscard]] float upperBorder(float x) const { return m_upper(x); }
  [[nodiscard]] float lowerBorder(float x) const { return m_lower(x); }

 private:
  Profile m_line, m_upper, m_lower;
  Profile m_upperAmount, m_lowerAmount;
  Profile m_upperSection, m_lowerSection;  ///< over the share of the way from line to border
};

}  // namespace dermis::sculpt
