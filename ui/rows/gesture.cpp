#include "ui/rows/gesture.h"

namespace dermis {

Gesture newGesture() {
  static Gesture s_last = 0;
  return ++s_last;
}

Gesture GestureClock::current() {
  if (!m_dragging) {
    if (!m_sinceLast.isValid() || m_sinceLast.elapsed() > kPauseMs) m_current = newGesture();
    m_sinceLast.start();
  }
  return m_current;
}

}  // namespace dermis
