// Lights in the viewport: a handle for each on the dome round the head, the shape of the selected one, and the gestures
// that move, aim and resize them. Drawn over the picture, never part of it.
#pragma once

#include <QObject>
#include <QTimer>
#include <optional>

#include "core/scene/scene.h"
#include "ui/rows/gesture.h"
#include "ui/viewport/light_dome.h"
#include "ui/viewport/viewport_tool.h"

namespace dermis {

class Document;
class Viewport;

class LightGizmos : public QObject, public ViewportTool {
  Q_OBJECT
 public:
  LightGizmos(Document& document, Viewport& viewport);

  [[nodiscard]] int selected() const { return m_selected; }
  void select(int light);
  /// The menu's toggle; even when on, they leave while the pointer is away.
  void setEnabled(bool enabled);
  [[nodiscard]] bool isEnabled() const { return m_enabled; }
  /// Whether they are drawn now.
  [[nodiscard]] bool isShown() const;
  /// While L is held a drag anywhere moves the key light.
  void holdKeyLight(bool held);
  /// Where a light's handle is, and the handles of the selected one's size; in the viewport's own points.
  [[nodiscard]] QPointF handle(std::size_t light) const;
  [[nodiscard]] QList<QPointF> sizeHandles() const;

  bool press(const QMouseEvent& event) override;
  void drag(const QMouseEvent& event) override;
  void release() override;
  void cancel() override;
  bool wheel(const QWheelEvent& event) override;
  void hover(const QPointF& at) override;
  void leave() override;
  void paint(QPainter& painter, const Projection& projection) override;

 Q_SIGNALS:
  void selectionChanged(int light);
  void message(const QString& sentence);

 private:
  enum class Grip { None, Dome, Plane, KeyLight, Size };
  [[nodiscard]] const std::vector<Light>& lights() const;
  [[nodiscard]] glm::vec3 centre() const;
  [[nodiscard]] Projection projection() const;
  [[nodiscard]] std::optional<std::size_t> lightAt(QPointF point) const;
  [[nodiscard]] std::optional<int> sizeHandleAt(QPointF point) const;
  void change(const Light& light, const QString& what);
  void wake();

  Document& m_document;
  Viewport& m_viewport;
  int m_selected = -1;
  int m_hovered = -1;
  bool m_enabled = true;
  bool m_awake = false;
  bool m_keyHeld = false;
  Grip m_grip = Grip::None;
  Light m_start;      ///< the light as it was at the press
  QPointF m_pressed;  ///< where
  QPointF m_offset;   ///< from the pointer to the handle's middle
  int m_sizeHandle = 0;
  Gesture m_gesture = 0;
  QString m_what;
  GestureClock m_wheel;
  QTimer m_sleep;
};

}  // namespace dermis
