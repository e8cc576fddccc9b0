// Pictures of snapshots that the viewport doesn't show: while two presets are compared, what was kept is neither of
// them.
#pragma once

#include <QObject>

class QWidget;

namespace dermis {

class Snapshots;
class TaskRunner;

/// Draws them beside the event loop, one after another.
class SnapshotPictures : public QObject {
  Q_OBJECT
 public:
  /// They have the shape of `view`.
  SnapshotPictures(Snapshots& snapshots, TaskRunner& tasks, const QWidget& view, QObject* parent = nullptr);

 Q_SIGNALS:
  void problem(const QString& sentence);

 private:
  void drawNext();

  Snapshots& m_snapshots;
  TaskRunner& m_tasks;
  const QWidget& m_view;
};

}  // namespace dermis
