// How large a picture this machine draws often enough while something is being dragged.
#pragma once

namespace dermis {

/// Keeps about twenty pictures a second by drawing fewer pixels; only slow (software) OpenGL needs it.
class Pace {
 public:
  static constexpr double kTargetMs = 48.0;
  /// The side of the picture as a share of the viewport's, in eighths, 0.25 to 1.
  [[nodiscard]] double scale() const { return m_scale; }
  /// A picture drawn at scale() while dragging took this long.
  void measured(double milliseconds);

 private:
  double m_scale = 0.5;  // until something was measured: better coarse at first than late
  double m_smoothed = 0.0;
};

}  // namespace dermis
