// A ruler between two points of the surface.
#pragma once

#include <QPointF>
#include <optional>

#include "core/scene/scene.h"
#include "ui/preferences/preferences.h"
#include "ui/viewport/viewport_tool.h"

namespace dermis {

class Document;
class Viewport;

class MeasureTool : public ViewportTool {
 public:
  MeasureTool(Document& document, Viewport& viewport) : m_document(document), m_viewport(viewport) {}
  /// While it is on, a drag with the left button measures; turning it off forgets the line.
  void setEnabled(bool enabled);
  /// Without a pointer: the line starts in the middle of the picture, and at the next call ends there. False where the
  /// model is not there.
  bool markMiddle();
  /// In which it says what it has measured.
  void setUnit(LengthUnit unit);
  /// Nothing until two points of the surface are known.
  [[nodiscard]] std::optional<double> millimetres() const;
  /// The same in the unit that was set.
  [[nodiscard]] QString words() const;

  bool press(const QMouseEvent& event) override;
  void drag(const QMouseEvent& event) override;
  void cancel() override;
  void paint(QPainter& painter, const Projection& projection) override;

 private:
  [[nodiscard]] std::optional<glm::vec3> surfaceAt(QPointF at) const;
  static void paintLine(QPainter& painter, const QPointF& from, const QPointF& to);
  Document& m_document;
  Viewport& m_viewport;
  bool m_enabled = false;
  LengthUnit m_unit = LengthUnit::Automatic;
  std::optional<glm::vec3> m_from, m_to;
};

}  // namespace dermis
