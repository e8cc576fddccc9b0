// What is under the pointer, in numbers, and the ones somebody wants to keep.
#pragma once

#include <QList>
#include <QObject>
#include <QPointF>
#include <QTimer>
#include <optional>

#include "renderer.h"
#include "ui/viewport/viewport_tool.h"

namespace dermis {

class Document;
class OverlayLabel;
class Viewport;

class PickReadout : public QObject, public ViewportTool {
  Q_OBJECT
 public:
  PickReadout(Document& document, Viewport& viewport);

  /// Whether the pointer's place is read out.
  void setEnabled(bool enabled);
  [[nodiscard]] bool isEnabled() const { return m_enabled; }
  /// Keeps what is at a point, marked in the picture, and copies it as text.
  void pin(const QPointF& at);
  /// The same where the pointer is, or in the middle when it is elsewhere.
  void pinHere();
  void clearPins();
  [[nodiscard]] qsizetype pinCount() const { return m_pins.size(); }
  /// What is at a point, one line a fact; empty outside of the picture.
  [[nodiscard]] QString textAt(const QPointF& at);
  /// The slot under a point; empty where there is none.
  [[nodiscard]] QString slotAt(const QPointF& at) const;
  /// Makes the slot under a point the one that is edited; false where there is none.
  bool selectSlot(const QPointF& at);

  void paint(QPainter& painter, const Projection& projection) override;

 private:
  struct Pin {
    glm::vec3 place;  ///< in the world
    QString text;
  };
  void read();
  void hide();

  Document& m_document;
  Viewport& m_viewport;
  OverlayLabel* m_label = nullptr;
  QTimer m_soon;
  std::optional<QPointF> m_at;
  bool m_enabled = true;
  bool m_isWanted = false;  ///< the pointer has been over the picture since something was changed
  QList<Pin> m_pins;
};

}  // namespace dermis
