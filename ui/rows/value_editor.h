// What all editors of one value share: they show a value given to them and tell of edits; they never keep the state.
#pragma once

#include <QStringList>
#include <QWidget>
#include <optional>

#include "core/material/parameter_table.h"
#include "ui/rows/gesture.h"

namespace dermis {

/// The range a number may take and the range its slider covers.
struct NumberRange {
  double hardMin = 0.0, hardMax = 1.0;
  double softMin = 0.0, softMax = 1.0;
  QString unit;

  /// The step a slider rounds to: a thousandth of the decade that holds the soft range.
  [[nodiscard]] double step() const;
  /// Decimals that show that step.
  [[nodiscard]] int decimals() const;
};

class ValueEditor : public QWidget {
  Q_OBJECT
 public:
  using QWidget::QWidget;
  /// Shows a value without telling of an edit. The alternative must be the one this editor edits.
  virtual void showValue(const ParameterValue& value) = 0;
  /// Names the controls for assistive technology and for tests: `path` is "Subsurface › Scale", `id` its id.
  virtual void nameControls(const QString& path, const QString& id) = 0;
  /// The value a reset returns to, shown as a mark where the editor has a place for it.
  virtual void showDefault(const ParameterValue&) {}
  /// Several values are shown at once and differ: a dash instead of one of them.
  virtual void showMixed(bool) {}
  /// The component of a vector that is being edited, while `edited` tells of it; nothing where it is the whole value.
  [[nodiscard]] virtual std::optional<int> editedComponent() const { return std::nullopt; }
  /// What its numbers may be, where it edits numbers.
  [[nodiscard]] virtual std::optional<NumberRange> range() const { return std::nullopt; }
  /// The words it chooses among, where it edits a choice.
  [[nodiscard]] virtual QStringList words() const { return {}; }
  /// True where the row should put its label on a line of its own.
  [[nodiscard]] virtual bool wide() const { return false; }

 Q_SIGNALS:
  void edited(const dermis::ParameterValue& value, dermis::Gesture gesture);
};

/// The editor that suits a row of the parameter table.
[[nodiscard]] ValueEditor* makeEditor(const ParameterRow& row, QWidget* parent = nullptr);

}  // namespace dermis
