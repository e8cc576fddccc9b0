#include "ui/rows/vector_editor.h"

#include <QHBoxLayout>
#include <QVBoxLayout>

#include "ui/rows/number_field.h"
#include "ui/rows/scalar_editor.h"
#include "ui/theme/metrics.h"

namespace dermis {
namespace {

glm::vec3 componentsOf(const ParameterValue& value) {
  if (const auto* two = std::get_if<glm::vec2>(&value)) return {*two, 0.0F};
  return std::get<glm::vec3>(value);
}

}  // namespace

VectorEditor::VectorEditor(int components, const NumberRange& range, const QStringList& letters, QWidget* parent)
    : ValueEditor(parent), m_range(range), m_letters(letters) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(2);
  while (m_letters.size() < components) m_letters << QString::number(m_letters.size() + 1);
  for (int i = 0; i < components; ++i) {
    auto* one = new ScalarEditor(range, this);
    one->setPrefix(m_letters[i]);
    column->addWidget(one);
    m_components.push_back(one);
    connect(one, &ScalarEditor::numberEdited, this, [this, i](double number, Gesture gesture) {
      glm::vec3 next = m_shown;
      next[i] = static_cast<float>(number);
      m_shown = next;
      m_edited = i;
      Q_EMIT edited(m_components.size() == 2 ? ParameterValue(glm::vec2(next)) : ParameterValue(next), gesture);
      m_edited.reset();
    });
  }
}

void VectorEditor::showValue(const ParameterValue& value) {
  m_shown = componentsOf(value);
  for (std::size_t i = 0; i < m_components.size(); ++i)
    m_components[i]->showNumber(static_cast<double>(m_shown[static_cast<int>(i)]));
}

void VectorEditor::showDefault(const ParameterValue& value) {
  const glm::vec3 numbers = componentsOf(value);
  for (std::size_t i = 0; i < m_components.size(); ++i)
    m_components[i]->showDefaultNumber(static_cast<double>(numbers[static_cast<int>(i)]));
}

void VectorEditor::showMixed(bool mixed) {
  for (ScalarEditor* one : m_components) one->showMixed(mixed);
}

void VectorEditor::nameControls(const QString& path, const QString& id) {
  for (std::size_t i = 0; i < m_components.size(); ++i) {
    const QString letter = m_letters[static_cast<qsizetype>(i)];
    m_components[i]->nameControls(path + QLatin1Char(' ') + letter, id + QLatin1Char('.') + letter.toLower());
  }
}

TripleEditor::TripleEditor(const NumberRange& range, QWidget* parent) : ValueEditor(parent), m_range(range) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(metrics::kGap);
  for (int i = 0; i < 3; ++i) {
    auto* field = new NumberField(range, this);
    field->setMinimumWidth(48);
    row->addWidget(field, 1);
    m_fields.push_back(field);
    connect(field, &NumberField::edited, this, [this, i](double number, Gesture gesture) {
      m_shown[i] = static_cast<float>(number);
      Q_EMIT edited(ParameterValue(m_shown), gesture);
    });
  }
}

void TripleEditor::showValue(const ParameterValue& value) {
  m_shown = std::get<glm::vec3>(value);
  for (int i = 0; i < 3; ++i) m_fields[static_cast<std::size_t>(i)]->showNumber(static_cast<double>(m_shown[i]));
}

void TripleEditor::nameControls(const QString& path, const QString& id) {
  static constexpr const char* kLetters = "XYZ";
  for (std::size_t i = 0; i < 3; ++i) {
    const QChar letter = QLatin1Char(kLetters[i]);
    m_fields[i]->setAccessibleName(path + QLatin1Char(' ') + letter);
    m_fields[i]->setObjectName(id + QLatin1Char('.') + letter.toLower());
  }
}

}  // namespace dermis
