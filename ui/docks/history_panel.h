// The History dock: what was done, what was undone, and which state is the saved one.
#pragma once

#include <QUndoView>
#include <QWidget>

class QUndoStack;

namespace dermis {

class HistoryPanel : public QWidget {
  Q_OBJECT
 public:
  explicit HistoryPanel(QUndoStack& stack, QWidget* parent = nullptr);
};

}  // namespace dermis
