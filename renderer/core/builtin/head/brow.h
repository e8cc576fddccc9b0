// Where the eyebrow grows, in front view.
#pragma once

#include "core/builtin/head/profile.h"

namespace dermis::sculpt {

class Brow {
 public:
  Brow();
  /// Of its middle, mm at |x| mm.
  [[nodiscard]] float height(float x) const { return m_height(x); }
  [[nodiscard]] float halfWidth(float x) const { return m_halfWidth(x); }
  /// Of the middle.
  [[nodiscard]] float slope(float x) const { return m_height(x + 0.5F) - m_height(x - 0.5F); }

 private:
  Profile m_height, m_halfWidth;
};

}  // namespace dermis::sculpt
