// What the handles on the dome have in common, of lamps and of a rig's elements: they wake as the pointer moves over
// the picture, sleep when it rests or leaves, and the nearest one is under the pointer.
#pragma once

#include <QList>
#include <QObject>
#include <QPointF>
#include <QTimer>
#include <optional>

#include "ui/rows/gesture.h"
#include "ui/viewport/viewport_tool.h"

namespace dermis {

class Viewport;

class DomeGizmos : public QObject, public ViewportTool {
  Q_OBJECT
 public:
  /// The menu's toggle; even when on, they leave while the pointer is away.
  void setEnabled(bool enabled);
  [[nodiscard]] bool isEnabled() const { return m_enabled; }
  /// Whether they are drawn now.
  [[nodiscard]] virtual bool isShown() const = 0;
  /// Where a handle is, in the viewport's own points.
  [[nodiscard]] virtual QPointF handle(std::size_t index) const = 0;
  /// Handles of the selected one's size.
  [[nodiscard]] virtual QList<QPointF> sizeHandles() const = 0;

  void hover(const QPointF& at) override;
  void leave() override;

 protected:
  /// `handleRadius`: how near to a handle's middle the pointer is on it.
  DomeGizmos(Viewport& viewport, double handleRadius);

  /// How many there are, and which of them stand on the dome.
  [[nodiscard]] virtual std::size_t count() const = 0;
  [[nodiscard]] virtual bool hasHandle(std::size_t index) const;
  /// Whether a hand holds one.
  [[nodiscard]] virtual bool isHeld() const = 0;

  [[nodiscard]] std::optional<std::size_t> handleAt(QPointF point) const;
  [[nodiscard]] std::optional<int> sizeHandleAt(QPointF point) const;
  [[nodiscard]] bool isAwake() const { return m_enabled && m_awake; }
  [[nodiscard]] int hovered() const { return m_hovered; }
  [[nodiscard]] Viewport& viewport() const { return m_viewport; }
  void wake();
  /// Stays awake until wake() is called again: a hand takes hold.
  void stayAwake() { m_sleep.stop(); }

  QPointF m_pressed;  ///< where a gesture began
  QPointF m_offset;   ///< from the pointer to the handle's middle
  int m_sizeHandle = 0;
  Gesture m_gesture = 0;
  QString m_what;
  GestureClock m_wheel;

 private:
  void sleep();

  Viewport& m_viewport;
  double m_handleRadius;
  int m_hovered = -1;
  bool m_enabled = true;
  bool m_awake = false;
  QTimer m_sleep;
};

}  // namespace dermis
