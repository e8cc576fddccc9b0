// Curves in space with a radius and an amount along them: brush strokes that raise or lower a surface, and tubes.
#pragma once

#include <glm/glm.hpp>
#include <vector>

namespace dermis::sculpt {

struct StrokePoint {
  glm::vec3 place{0.0F};
  float radius = 1.0F;
  float amount = 0.0F;  ///< mm outwards
};

class Stroke {
 public:
  Stroke() = default;
  /// A Catmull-Rom curve through the points; one point is a dab.
  explicit Stroke(const std::vector<StrokePoint>& points, int piecesPerSpan = 6);

  /// How far the surface is raised at p: amount · (1 − (d/r)²)². Of the pieces in reach the strongest counts, not the
  /// nearest, which would jump on the inner side of a bend.
  [[nodiscard]] float raise(const glm::vec3& p) const;
  /// Distance to the tube of the curve's radii; a bound from below where far away.
  [[nodiscard]] float tube(const glm::vec3& p) const;

 private:
  std::vector<StrokePoint> m_points;
  glm::vec3 m_centre{0.0F};  ///< of a ball that holds it all
  float m_reach = 0.0F;
};

/// Raised by all of them together.
[[nodiscard]] float raisedBy(const std::vector<Stroke>& strokes, const glm::vec3& p);

}  // namespace dermis::sculpt
