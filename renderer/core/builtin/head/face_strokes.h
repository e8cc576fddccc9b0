// Brush strokes over the head, dropped on the surface from the front or from the side.
#pragma once

#include <glm/glm.hpp>
#include <span>
#include <string_view>
#include <vector>

namespace dermis::sculpt {

/// One point of a stroke in front view (x, y) or side view (z, y): where, how wide, how much outwards (mm).
struct DrawnPoint {
  float across, y, radius, amount;
};
enum class DrawnFrom { Front, Side };
struct DrawnStroke {
  std::string_view name;
  DrawnFrom from;
  std::vector<DrawnPoint> points;
};
/// Before lids and nose: brow ridge, orbit, cheekbone, chin, neck muscle.
[[nodiscard]] std::vector<DrawnStroke> broadStrokes();
/// On the finished form: folds, grooves, creases.
[[nodiscard]] std::vector<DrawnStroke> fineStrokes();

}  // namespace dermis::sculpt
