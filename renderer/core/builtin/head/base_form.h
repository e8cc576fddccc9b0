// The head without its features: skull, jaw, neck and shoulders, bent to pass through the pins.
#pragma once

#include <glm/glm.hpp>
#include <vector>

namespace dermis::sculpt {

/// Some fifteen ellipsoids and capsules blended: within about 10 mm of the head.
[[nodiscard]] float roughForm(const glm::vec3& p);

class BaseForm {
 public:
  /// Fits the pins and samples the result on a lattice: about a quarter of a second.
  BaseForm();
  /// Signed distance to it, tricubic from the lattice.
  [[nodiscard]] float operator()(const glm::vec3& p) const;

 private:
  std::vector<float> m_lattice;
};

}  // namespace dermis::sculpt
