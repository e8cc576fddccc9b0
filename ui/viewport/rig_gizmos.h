// Handles of the elements of a light rig: softboxes, strips, glows, the sun. They stand on the same dome as those of
// lamps and take the same gestures; what they change is the rig.
#pragma once

#include <QObject>
#include <QTimer>
#include <optional>

#include "core/light_rig/light_rig.h"
#include "ui/rows/gesture.h"
#include "ui/viewport/projection.h"
#include "ui/viewport/viewport_tool.h"

namespace dermis {

class Document;
class RigEdit;
class Viewport;

class RigGizmos : public QObject, public ViewportTool {
  Q_OBJECT
 public:
  RigGizmos(Document& document, RigEdit& edit, Viewport& viewport);

  void setEnabled(bool enabled);
  [[nodiscard]] bool isShown() const;
  /// In the viewport's own points; only elements that hasPlace() have one.
  [[nodiscard]] QPointF handle(std::size_t element) const;
  /// Those of the selected element's size: one across, one upright where that is another.
  [[nodiscard]] QList<QPointF> sizeHandles() const;

  bool press(const QMouseEvent& event) override;
  void drag(const QMouseEvent& event) override;
  void release() override;
  void cancel() override;
  bool wheel(const QWheelEvent& event) override;
  void hover(const QPointF& at) override;
  void leave() override;
  void paint(QPainter& painter, const Projection& projection) override;

 private:
  enum class Grip { None, Dome, Size };
  [[nodiscard]] std::optional<std::size_t> elementAt(QPointF point) const;
  [[nodiscard]] std::optional<int> sizeHandleAt(QPointF point) const;
  [[nodiscard]] const RigElement* selected() const;
  void change(const RigElement& element);
  void wake();

  Document& m_document;
  RigEdit& m_edit;
  Viewport& m_viewport;
  int m_hovered = -1;
  bool m_enabled = true;
  bool m_awake = false;
  Grip m_grip = Grip::None;
  RigElement m_start;
  QPointF m_pressed, m_offset;
  int m_sizeHandle = 0;
  Gesture m_gesture = 0;
  QString m_what;
  GestureClock m_wheel;
  QTimer m_sleep;
};

}  // namespace dermis
