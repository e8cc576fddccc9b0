#include "ui/rows/scalar_editor.h"

#include <QHBoxLayout>
#include <QLabel>

#include "ui/rows/number_field.h"
#include "ui/rows/value_slider.h"
#include "ui/theme/metrics.h"

namespace dermis {

ScalarEditor::ScalarEditor(const NumberRange& range, QWidget* parent) : ValueEditor(parent), m_range(range) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(metrics::kGap);
  m_prefix = new QLabel(this);
  m_prefix->setFixedWidth(metrics::kPrefixWidth);
  m_prefix->setProperty("quiet", true);
  m_prefix->hide();
  m_slider = new ValueSlider(range, this);
  m_field = new NumberField(range, this);
  m_field->setFixedWidth(metrics::kNumberWidth);
  auto* unit = new QLabel(range.unit, this);
  unit->setFixedWidth(metrics::kUnitWidth);
  unit->setProperty("quiet", true);
  row->addWidget(m_prefix);
  row->addWidget(m_slider, 1);
  row->addWidget(m_field);
  row->addWidget(unit);
  setFocusProxy(m_slider);

  const auto tell = [this](double number, Gesture gesture) {
    Q_EMIT numberEdited(number, gesture);
    Q_EMIT edited(ParameterValue(static_cast<float>(number)), gesture);
  };
  connect(m_slider, &ValueSlider::edited, this, tell);
  connect(m_field, &NumberField::edited, this, tell);
}

void ScalarEditor::showNumber(double number) {
  m_slider->showNumber(number);
  m_field->showNumber(number);
}

void ScalarEditor::showDefault(const ParameterValue& value) {
  showDefaultNumber(static_cast<double>(std::get<float>(value)));
}

void ScalarEditor::showDefaultNumber(double number) { m_slider->showDefault(number); }

void ScalarEditor::showMixed(bool mixed) {
  m_slider->showMixed(mixed);
  m_field->showMixed(mixed);
}

void ScalarEditor::setNumberRange(const NumberRange& range) {
  m_range = range;
  m_slider->setNumberRange(range);
  m_field->setNumberRange(range);
}

void ScalarEditor::setPrefix(const QString& text) {
  m_prefix->setText(text);
  m_prefix->setVisible(!text.isEmpty());
}

void ScalarEditor::nameControls(const QString& path, const QString& id) {
  m_slider->setAccessibleName(path);
  m_slider->setObjectName(id + QStringLiteral(".slider"));
  m_field->setAccessibleName(path);
  m_field->setObjectName(id + QStringLiteral(".number"));
}

}  // namespace dermis
