// The colour picker: it names its space, and shows linear and sRGB values.
#pragma once

#include <QFrame>
#include <QPointer>
#include <glm/glm.hpp>
#include <vector>

#include "ui/rows/gesture.h"

class QLineEdit;

namespace dermis {

class HueStrip;
class SaturationSquare;
class ScalarEditor;
class Swatch;

/// A pop-up that edits one linear Rec.709 colour, each channel 0..1.
class ColourPicker : public QFrame {
  Q_OBJECT
 public:
  explicit ColourPicker(const QString& title, QWidget* parent);
  /// Shows a colour without telling of an edit.
  void showColour(const glm::vec3& linear);
  /// Opens below `anchor`, remembering the colour shown now as the one to go back to.
  void openBeside(QWidget* anchor);
  /// What it was opened from.
  [[nodiscard]] QWidget* anchor() const { return m_anchor; }

 Q_SIGNALS:
  void edited(const glm::vec3& linear, dermis::Gesture gesture);

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  void tell(const glm::vec3& linear, Gesture gesture);
  void tellHsv(float hue, float saturation, float value, Gesture gesture);

  glm::vec3 m_linear{0.0F};
  QPointer<QWidget> m_anchor;
  glm::vec3 m_start{0.0F};
  SaturationSquare* m_square = nullptr;
  HueStrip* m_strip = nullptr;
  std::vector<ScalarEditor*> m_channels;
  std::vector<ScalarEditor*> m_encoded;
  QLineEdit* m_hex = nullptr;
  Swatch* m_before = nullptr;
  Swatch* m_now = nullptr;
};

}  // namespace dermis
