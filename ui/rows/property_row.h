// One row of a panel: modified dot, label, editor; reset, copy and paste.
#pragma once

#include <QWidget>
#include <optional>

#include "core/base/result.h"
#include "ui/rows/value_editor.h"

class QLabel;
class QMenu;

namespace dermis {

class ModifiedDot;

class PropertyRow : public QWidget {
  Q_OBJECT
 public:
  /// `group` and `label` make the accessible path "group › label"; `id` is the row's objectName.
  PropertyRow(const QString& group, const QString& label, const QString& id, ValueEditor* editor,
              QWidget* parent = nullptr);
  void showValue(const ParameterValue& value);
  /// Several things are shown at once and differ here; `values` says how, empty: they don't.
  void showDifferences(const QString& values);
  /// With a default the row has a modified dot and can be reset.
  void setDefault(const ParameterValue& value);
  /// The preset's value, where there is a preset: the dot says more when it differs from that.
  void setPresetValue(const std::optional<ParameterValue>& value);
  /// The table's row: an enum's words and the unit of what is pasted.
  void setParameter(const ParameterRow& parameter) { m_parameter = &parameter; }
  void setHelp(const QString& sentence);
  [[nodiscard]] ValueEditor* editor() const { return m_editor; }
  [[nodiscard]] bool isModified() const;
  [[nodiscard]] bool differsFromPreset() const;
  /// Whether a search for `words` finds this row.
  [[nodiscard]] bool matches(const QString& words) const;
  void reset();
  void resetToPreset();
  /// To and from the clipboard, as text.
  void copy() const;
  void paste();
  /// The context menu; actions added to the row stand at its end.
  void fillMenu(QMenu& menu);

 Q_SIGNALS:
  void edited(const dermis::ParameterValue& value, dermis::Gesture gesture);
  /// What was pasted fits not: one sentence.
  void problem(const QString& sentence);

 protected:
  bool event(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void refreshDot();
  struct Description;
  /// The table's row, or what the editor knows of a value that is not in the table.
  void describe(Description& description) const;
  [[nodiscard]] Result<ParameterValue> clipboardValue() const;

  QString m_path;
  QString m_name;
  QString m_group;
  ValueEditor* m_editor = nullptr;
  ModifiedDot* m_dot = nullptr;
  QLabel* m_label = nullptr;
  const ParameterRow* m_parameter = nullptr;
  std::optional<ParameterValue> m_value;
  std::optional<ParameterValue> m_default;
  std::optional<ParameterValue> m_preset;
  QString m_differences;
};

}  // namespace dermis
