// A smooth function of one number through given points.
#pragma once

#include <glm/glm.hpp>
#include <initializer_list>
#include <vector>

namespace dermis::sculpt {

/// Monotone cubic between its points (Fritsch & Butland 1984, "A Method for Constructing Local Monotone Piecewise Cubic
/// Interpolants"), constant beyond them.
class Profile {
 public:
  /// (x, y), x ascending.
  Profile(std::initializer_list<glm::vec2> points);
  [[nodiscard]] float operator()(float x) const;

 private:
  struct Knot {
    float x, y, slope;
  };
  std::vector<Knot> m_knots;
};

}  // namespace dermis::sculpt
