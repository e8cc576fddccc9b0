// The table of a sum of Gaussians: variance and three weights a row, up to eight rows.
#pragma once

#include <array>

#include "ui/rows/value_editor.h"

class QLabel;
class QToolButton;

namespace dermis {

class NumberField;

class GaussiansEditor : public ValueEditor {
  Q_OBJECT
 public:
  explicit GaussiansEditor(const NumberRange& range, QWidget* parent = nullptr);
  void showValue(const ParameterValue& value) override;
  void nameControls(const QString& path, const QString& id) override;
  [[nodiscard]] bool wide() const override { return true; }

 private:
  struct Line {
    std::array<NumberField*, 4> fields{};
    QToolButton* remove = nullptr;
  };
  void tell(Gesture gesture);
  void refresh();

  GaussianTable m_shown;
  std::array<Line, kMaxGaussians> m_lines;
  QLabel* m_sums = nullptr;
  QToolButton* m_add = nullptr;
};

}  // namespace dermis
