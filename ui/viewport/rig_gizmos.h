// Handles of the elements of a light rig: softboxes, strips, glows, the sun. They stand on the same dome as those of
// lamps and take the same gestures; what they change is the rig.
#pragma once

#include "core/light_rig/light_rig.h"
#include "ui/viewport/dome_gizmos.h"
#include "ui/viewport/projection.h"

namespace dermis {

class Document;
class RigEdit;

class RigGizmos : public DomeGizmos {
  Q_OBJECT
 public:
  RigGizmos(Document& document, RigEdit& edit, Viewport& viewport);

  [[nodiscard]] bool isShown() const override;
  /// Only elements that hasPlace() have one.
  [[nodiscard]] QPointF handle(std::size_t element) const override;
  /// One across, one upright where that is another.
  [[nodiscard]] QList<QPointF> sizeHandles() const override;

  bool press(const QMouseEvent& event) override;
  void drag(const QMouseEvent& event) override;
  void release() override;
  void cancel() override;
  bool wheel(const QWheelEvent& event) override;
  void paint(QPainter& painter, const Projection& projection) override;

 private:
  enum class Grip { None, Dome, Size };
  [[nodiscard]] std::size_t count() const override;
  [[nodiscard]] bool hasHandle(std::size_t element) const override;
  [[nodiscard]] bool isHeld() const override { return m_grip != Grip::None; }
  [[nodiscard]] const RigElement* selected() const;
  void change(const RigElement& element);

  Document& m_document;
  RigEdit& m_edit;
  Grip m_grip = Grip::None;
  RigElement m_start;
};

}  // namespace dermis
