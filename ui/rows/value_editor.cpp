#include "ui/rows/value_editor.h"

#include <algorithm>
#include <cmath>

#include "core/material/parameter_docs.h"
#include "ui/rows/choice_editors.h"
#include "ui/rows/colour_editor.h"
#include "ui/rows/gaussians_editor.h"
#include "ui/rows/scalar_editor.h"
#include "ui/rows/vector_editor.h"
#include "ui/translation.h"

namespace dermis {

double NumberRange::step() const {
  const double range = std::max(softMax - softMin, 1e-6);
  return std::pow(10.0, std::ceil(std::log10(range) - 1e-9)) / 1000.0;
}

int NumberRange::decimals() const { return std::clamp(static_cast<int>(std::lround(-std::log10(step()))), 0, 5); }

ValueEditor* makeEditor(const ParameterRow& row, QWidget* parent) {
  const NumberRange range{row.hardMin, row.hardMax, row.softMin, row.softMax,
                          QString::fromUtf8(row.unit.data(), static_cast<qsizetype>(row.unit.size()))};
  switch (row.type) {
    case ParameterType::Float:
      return new ScalarEditor(range, parent);
    case ParameterType::Vec2:
      return new VectorEditor(2, range, {}, parent);
    case ParameterType::Vec3:
      return new VectorEditor(3, range, {QStringLiteral("R"), QStringLiteral("G"), QStringLiteral("B")}, parent);
    case ParameterType::Colour:
      return new ColourEditor(false, range, parent);
    case ParameterType::OptionalColour:
      return new ColourEditor(true, range, parent);
    case ParameterType::Enum: {
      QStringList words;
      for (const std::string_view word : row.words) words << tableText(choiceLabel(word));
      return new ChoiceEditor(words, parent);
    }
    case ParameterType::Bool:
      return new SwitchEditor(parent);
    case ParameterType::Gaussians:
      return new GaussiansEditor(range, parent);
  }
  return nullptr;
}

}  // namespace dermis
