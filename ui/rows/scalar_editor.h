// Slider, number field and unit of one real number.
#pragma once

#include "ui/rows/value_editor.h"

class QLabel;

namespace dermis {

class NumberField;
class ValueSlider;

class ScalarEditor : public ValueEditor {
  Q_OBJECT
 public:
  explicit ScalarEditor(const NumberRange& range, QWidget* parent = nullptr);
  void showValue(const ParameterValue& value) override { showNumber(static_cast<double>(std::get<float>(value))); }
  void showDefault(const ParameterValue& value) override;
  void showMixed(bool mixed) override;
  void nameControls(const QString& path, const QString& id) override;

  void showNumber(double number);
  void showDefaultNumber(double number);
  void setNumberRange(const NumberRange& range);
  [[nodiscard]] std::optional<NumberRange> range() const override { return m_range; }
  /// A short name before the slider, such as the channel's letter.
  void setPrefix(const QString& text);
  [[nodiscard]] ValueSlider* slider() const { return m_slider; }
  [[nodiscard]] NumberField* field() const { return m_field; }

 Q_SIGNALS:
  void numberEdited(double number, dermis::Gesture gesture);

 private:
  NumberRange m_range;
  QLabel* m_prefix = nullptr;
  ValueSlider* m_slider = nullptr;
  NumberField* m_field = nullptr;
};

}  // namespace dermis
