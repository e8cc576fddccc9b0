// Edit › Shortcuts: every command of the menus, and the keys that call it.
#pragma once

#include <QDialog>

#include "ui/preferences/shortcuts.h"

class QKeySequenceEdit;
class QLabel;
class QLineEdit;
class QPushButton;
class QTreeWidget;

namespace dermis {

class ShortcutsDialog : public QDialog {
  Q_OBJECT
 public:
  explicit ShortcutsDialog(Shortcuts& shortcuts, QWidget* parent = nullptr);

 private:
  void buildEditor();
  void fill();
  void filter();
  void refresh();
  void showSelected();
  void apply(const QString& problem);
  [[nodiscard]] const Shortcuts::Entry* selected() const;

  Shortcuts& m_shortcuts;
  QLineEdit* m_search = nullptr;
  QTreeWidget* m_tree = nullptr;
  QKeySequenceEdit* m_keys = nullptr;
  QPushButton* m_clear = nullptr;
  QPushButton* m_reset = nullptr;
  QPushButton* m_resetAll = nullptr;
  QLabel* m_problem = nullptr;
};

}  // namespace dermis
