#include "ui/viewport/pace.h"

#include <algorithm>
#include <cmath>

namespace dermis {

void Pace::measured(double milliseconds) {
  m_smoothed = m_smoothed <= 0.0 ? milliseconds : 0.6 * m_smoothed + 0.4 * milliseconds;
  // Time goes with the number of pixels, the square of the scale; a margin keeps it from hunting between two steps.
  const double ideal = m_scale * std::sqrt(m_target / std::max(m_smoothed, 1.0));
  const double eighths = std::clamp(std::floor(ideal * 8.0) / 8.0, 0.25, 1.0);
  if (eighths < m_scale || eighths >= m_scale + 0.25 || (eighths == 1.0 && ideal > 1.15)) {
    if (eighths != m_scale) m_smoothed = 0.0;
    m_scale = eighths;
  }
}

}  // namespace dermis
