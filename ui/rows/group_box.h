// A group of rows under a heading that folds it away; what was folded is remembered.
#pragma once

#include <QWidget>

class QToolButton;
class QVBoxLayout;

namespace dermis {

class GroupBox : public QWidget {
  Q_OBJECT
 public:
  /// `key` names the remembered state; empty: not remembered.
  GroupBox(const QString& title, const QString& key, QWidget* parent = nullptr);
  void addRow(QWidget* row);
  void clearRows();
  /// For the heading's context menu.
  void addHeadActions(const QList<QAction*>& actions);
  [[nodiscard]] bool isOpen() const { return m_open; }
  void setOpen(bool open);
  /// While a search is on, a group with hits is open whatever was remembered.
  void setForcedOpen(bool forced);

 private:
  void refresh();

  QString m_key;
  bool m_open = true;
  bool m_forced = false;
  QToolButton* m_head = nullptr;
  QWidget* m_body = nullptr;
  QVBoxLayout* m_rows = nullptr;
};

}  // namespace dermis
