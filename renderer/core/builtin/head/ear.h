// The ear: a folded plate, a rolled rim, the tragus, the hollow of the concha and the canal.
#pragma once

#include <glm/glm.hpp>

#include "core/builtin/head/ear_map.h"
#include "core/builtin/head/stroke.h"

namespace dermis::sculpt {

class Ear {
 public:
  Ear();
  /// The ear joined to the head; q has x > 0.
  [[nodiscard]] float join(float head, const glm::vec3& q) const;
  /// In the ear's frame: v backwards, u upwards, w outwards from its plane.
  [[nodiscard]] glm::vec3 local(const glm::vec3& q) const;
  /// Outwards from the ear's plane, in the head's frame.
  [[nodiscard]] const glm::vec3& outwards() const { return m_w; }
  [[nodiscard]] const EarMap& map() const { return m_map; }

 private:
  glm::vec3 m_origin, m_v, m_u, m_w;
  EarMap m_map;
  Stroke m_helix;
};

}  // namespace dermis::sculpt
