// The outer ear as a height over its own plane.
#pragma once

#include <glm/glm.hpp>
#include <vector>

namespace dermis::sculpt {

/// In the ear's plane, mm: v backwards, u upwards. Tabulated at 0.3 mm, because outlines and strokes are slow.
class EarMap {
 public:
  EarMap();
  struct Sample {
    float height;     ///< of the plate's middle over the plane
    float outline;    ///< signed distance to the ear's outline
    float thickness;  ///< of the plate
    float concha;     ///< signed distance to the outline of the concha
  };
  [[nodiscard]] Sample at(float v, float u) const;
  /// 1 / √(1 + |∇height|²): turns a height above the plate into a distance from it.
  [[nodiscard]] float steepness(float v, float u) const;
  /// How far (v, u) lies beyond the table; beyond it there is no ear.
  [[nodiscard]] static float beyond(float v, float u);

 private:
  [[nodiscard]] std::size_t index(int i, int j) const;
  void smoothHeights();
  int m_width = 0, m_rows = 0;
  std::vector<Sample> m_samples;
};

}  // namespace dermis::sculpt
