// A gesture: what a person feels as one action, and therefore one undo entry.
#pragma once

#include <QElapsedTimer>
#include <QtGlobal>

namespace dermis {

/// Edits that carry the same gesture and touch the same thing merge into one undo entry.
using Gesture = quint64;

/// A number that no gesture had before.
[[nodiscard]] Gesture newGesture();

/// Says which gesture an edit belongs to: one for each drag; and one for wheel ticks, key presses and typing that
/// follow each other within 400 ms.
class GestureClock {
 public:
  void beginDrag() {
    m_dragging = true;
    m_current = newGesture();
  }
  void endDrag() {
    m_dragging = false;
    m_sinceLast.invalidate();
  }
  [[nodiscard]] bool dragging() const { return m_dragging; }
  /// The gesture of an edit made now.
  [[nodiscard]] Gesture current();

 private:
  static constexpr qint64 kPauseMs = 400;
  Gesture m_current = 0;
  bool m_dragging = false;
  QElapsedTimer m_sinceLast;
};

}  // namespace dermis
