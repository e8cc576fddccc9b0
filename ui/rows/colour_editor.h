// A swatch that opens the picker; for an optional colour a switch and a brightness slider beside it.
#pragma once

#include <QAbstractButton>
#include <QPointer>
#include <glm/glm.hpp>

#include "ui/rows/value_editor.h"

class QCheckBox;
class QLabel;

namespace dermis {

class ColourPicker;
class ScalarEditor;

/// A rectangle in a colour, as a button.
class Swatch : public QAbstractButton {
  Q_OBJECT
 public:
  explicit Swatch(QWidget* parent = nullptr);
  void showColour(const glm::vec3& linear);
  /// The window that a click brings up; assistive technology finds it below the button while it is open.
  void setPicker(QWidget* picker) { m_picker = picker; }
  [[nodiscard]] QWidget* picker() const { return m_picker; }
  [[nodiscard]] QSize sizeHint() const override { return {64, 22}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  glm::vec3 m_linear{0.0F};
  QPointer<QWidget> m_picker;
};

class ColourEditor : public ValueEditor {
  Q_OBJECT
 public:
  /// `optional`: the value is an OptionalColour, and its absence follows something else (shown as "Auto").
  ColourEditor(bool optional, const NumberRange& range, QWidget* parent = nullptr);
  void showValue(const ParameterValue& value) override;
  void showDefault(const ParameterValue& value) override;
  void showMixed(bool mixed) override;
  void nameControls(const QString& path, const QString& id) override;
  /// What an absent colour amounts to, shown while it is absent and taken as the start when it is switched on.
  void setAutomatic(const glm::vec3& linear);
  [[nodiscard]] std::optional<NumberRange> range() const override { return m_range; }

 private:
  void openPicker();
  void tell(const glm::vec3& linear, Gesture gesture);
  void refresh();

  NumberRange m_range;
  bool m_optional = false;
  bool m_mixed = false;
  bool m_own = true;  ///< a colour of its own, rather than none
  glm::vec3 m_linear{0.0F};
  glm::vec3 m_automatic{0.04F};
  QString m_path;
  QString m_id;
  QCheckBox* m_switch = nullptr;
  Swatch* m_swatch = nullptr;
  QLabel* m_text = nullptr;
  ScalarEditor* m_brightness = nullptr;
  QPointer<ColourPicker> m_picker;
};

}  // namespace dermis
