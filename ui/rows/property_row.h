// One row of a panel: modified dot, label, editor; reset, copy and paste.
#pragma once

#include <QWidget>
#include <optional>

#include "ui/rows/value_editor.h"

class QLabel;

namespace dermis {

class PropertyRow : public QWidget {
  Q_OBJECT
 public:
  /// `group` and `label` make the accessible path "group › label"; `id` is the row's objectName.
  PropertyRow(const QString& group, const QString& label, const QString& id, ValueEditor* editor,
              QWidget* parent = nullptr);
  void showValue(const ParameterValue& value);
  /// With a default the row has a modified dot and can be reset.
  void setDefault(const ParameterValue& value);
  void setHelp(const QString& sentence);
  [[nodiscard]] ValueEditor* editor() const { return m_editor; }
  [[nodiscard]] bool isModified() const;
  /// Whether a search for `words` finds this row.
  [[nodiscard]] bool matches(const QString& words) const;
  void reset();

 Q_SIGNALS:
  void edited(const dermis::ParameterValue& value, dermis::Gesture gesture);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;

 private:
  void refreshDot();

  QString m_path;
  ValueEditor* m_editor = nullptr;
  QLabel* m_dot = nullptr;
  QLabel* m_label = nullptr;
  std::optional<ParameterValue> m_value;
  std::optional<ParameterValue> m_default;
};

}  // namespace dermis
