// Editors of two or three numbers: sliders below each other, or fields beside each other.
#pragma once

#include <QStringList>
#include <glm/glm.hpp>
#include <vector>

#include "ui/rows/value_editor.h"

namespace dermis {

class NumberField;
class ScalarEditor;

/// One slider a component, with a letter before each.
class VectorEditor : public ValueEditor {
  Q_OBJECT
 public:
  VectorEditor(int components, const NumberRange& range, const QStringList& letters, QWidget* parent = nullptr);
  void showValue(const ParameterValue& value) override;
  void showDefault(const ParameterValue& value) override;
  void showMixed(bool mixed) override;
  void nameControls(const QString& path, const QString& id) override;
  [[nodiscard]] std::optional<int> editedComponent() const override { return m_edited; }
  [[nodiscard]] std::optional<NumberRange> range() const override { return m_range; }

 private:
  NumberRange m_range;
  std::optional<int> m_edited;
  QStringList m_letters;
  std::vector<ScalarEditor*> m_components;
  glm::vec3 m_shown{0.0F};
};

/// Three number fields beside each other: positions and directions.
class TripleEditor : public ValueEditor {
  Q_OBJECT
 public:
  explicit TripleEditor(const NumberRange& range, QWidget* parent = nullptr);
  void showValue(const ParameterValue& value) override;
  void nameControls(const QString& path, const QString& id) override;
  [[nodiscard]] std::optional<NumberRange> range() const override { return m_range; }

 private:
  NumberRange m_range;
  std::vector<NumberField*> m_fields;
  glm::vec3 m_shown{0.0F};
};

}  // namespace dermis
