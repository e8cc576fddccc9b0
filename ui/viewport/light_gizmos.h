// Lights in the viewport: a handle for each on the dome round the head, the shape of the selected one, and the gestures
// that move, aim and resize them. Drawn over the picture, never part of it.
#pragma once

#include "core/scene/scene.h"
#include "ui/viewport/dome_gizmos.h"
#include "ui/viewport/light_dome.h"

namespace dermis {

class Document;

class LightGizmos : public DomeGizmos {
  Q_OBJECT
 public:
  LightGizmos(Document& document, Viewport& viewport);

  [[nodiscard]] int selected() const { return m_selected; }
  void select(int light);
  [[nodiscard]] bool isShown() const override;
  /// While L is held a drag anywhere moves the key light.
  void holdKeyLight(bool held);
  [[nodiscard]] QPointF handle(std::size_t light) const override;
  [[nodiscard]] QList<QPointF> sizeHandles() const override;

  bool press(const QMouseEvent& event) override;
  void drag(const QMouseEvent& event) override;
  void release() override;
  void cancel() override;
  bool wheel(const QWheelEvent& event) override;
  void paint(QPainter& painter, const Projection& projection) override;

 Q_SIGNALS:
  void selectionChanged(int light);
  void message(const QString& sentence);

 private:
  enum class Grip { None, Dome, Plane, KeyLight, Size };
  [[nodiscard]] std::size_t count() const override;
  [[nodiscard]] bool isHeld() const override { return m_grip != Grip::None; }
  [[nodiscard]] const std::vector<Light>& lights() const;
  [[nodiscard]] glm::vec3 centre() const;
  [[nodiscard]] Projection projection() const;
  void change(const Light& light, const QString& what);

  Document& m_document;
  int m_selected = -1;
  bool m_keyHeld = false;
  Grip m_grip = Grip::None;
  Light m_start;  ///< the light as it was at the press
};

}  // namespace dermis
