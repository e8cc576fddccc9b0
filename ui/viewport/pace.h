// How large a picture this machine draws often enough while something is being dragged.
#pragma once

namespace dermis {

/// Keeps about twenty pictures a second by drawing fewer pixels; a machine that needs no help keeps all of them.
class Pace {
 public:
  static constexpr double kTargetMs = 48.0;  ///< of a picture, on the screen
  /// Where nothing was measured yet: coarse at first rather than late, unless the machine is one that draws fast.
  explicit Pace(bool fast = false, double targetMs = kTargetMs) : m_target(targetMs), m_scale(fast ? 1.0 : 0.5) {}
  /// The side of the picture as a share of the viewport's, in eighths, 0.25 to 1.
  [[nodiscard]] double scale() const { return m_scale; }
  /// A picture drawn at scale() while dragging took this long.
  void measured(double milliseconds);

 private:
  double m_target;
  double m_scale;
  double m_smoothed = 0.0;
};

}  // namespace dermis
