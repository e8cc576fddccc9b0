// What is kept when another model takes the place of the one that is open.
#pragma once

#include "ui/document/sections.h"

namespace dermis {

/// Places beside one model, taken to another: × the ratio of the bounds' radii, about the centres.
class CarriedOver {
 public:
  CarriedOver(const Model& from, const Model& to);
  [[nodiscard]] float ratio() const { return m_ratio; }
  [[nodiscard]] glm::vec3 operator()(const glm::vec3& place) const { return m_to + m_ratio * (place - m_from); }
  [[nodiscard]] Camera operator()(const Camera& camera) const;

 private:
  glm::vec3 m_from, m_to;
  float m_ratio = 1.0F;
};

/// Slots of the same name keep their look (also those that an earlier model had); the others wear `imported`, parallel
/// to model->slots. Lights, camera and bookmarks are carried over by the ratio s of the bounds' radii: positions × s
/// about the centres, intensities × s².
[[nodiscard]] WholeLook carryOver(const WholeLook& before, const ModelSource& source,
                                  std::shared_ptr<const Model> model, std::vector<ResolvedMaterial> imported);

}  // namespace dermis
