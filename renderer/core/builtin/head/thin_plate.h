// A smooth field in space that takes given values at given places.
#pragma once

#include <glm/glm.hpp>
#include <vector>

namespace dermis::sculpt {

/// The smoothing polyharmonic spline with the kernel r³ and a linear term, in three dimensions (Duchon 1977, "Splines
/// minimizing rotation-invariant semi-norms in Sobolev spaces"; smoothing after Wahba 1990, "Spline Models for
/// Observational Data", §2.4).
class ThinPlate {
 public:
  struct Sample {
    glm::vec3 place;
    double value;
  };
  /// `smoothing` 0 takes the values exactly; lengths count in units of 100 mm.
  ThinPlate(const std::vector<Sample>& samples, double smoothing);

  [[nodiscard]] float operator()(const glm::vec3& p) const;

 private:
  std::vector<glm::vec3> m_centres;
  std::vector<double> m_weights;
  double m_linear[4] = {0.0, 0.0, 0.0, 0.0};
};

}  // namespace dermis::sculpt
