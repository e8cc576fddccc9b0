// The strip of snapshots: take, name, compare, restore, delete.
#pragma once

#include <QWidget>

class QListWidget;
class QToolButton;

namespace dermis {

class Snapshots;

class SnapshotsPanel : public QWidget {
  Q_OBJECT
 public:
  explicit SnapshotsPanel(Snapshots& snapshots, QWidget* parent = nullptr);
  [[nodiscard]] int selected() const;
  /// The one that is being compared with; -1: none.
  void showCompared(int index);
  [[nodiscard]] int compared() const { return m_compared; }

 Q_SIGNALS:
  void takeRequested();
  /// -1 ends the comparison.
  void compareRequested(int index);

 private:
  void refresh();
  void refreshButtons();

  Snapshots& m_snapshots;
  QListWidget* m_list = nullptr;
  QToolButton* m_take = nullptr;
  QToolButton* m_compare = nullptr;
  QToolButton* m_restore = nullptr;
  QToolButton* m_remove = nullptr;
  int m_compared = -1;
};

}  // namespace dermis
