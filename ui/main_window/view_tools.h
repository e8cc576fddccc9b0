// What stands over and beside the picture, put together: gizmos, split view and snapshots, readout, ruler, bookmarks,
// the camera's history, things to judge light by.
#pragma once

#include <QObject>
#include <filesystem>
#include <memory>

#include "ui/document/loading.h"
#include "ui/viewport/measure_tool.h"
#include "ui/viewport/split_handle.h"

class QAction;
class QMenu;

namespace dermis {

class BookmarksBox;
class CameraHistory;
class CameraPanel;
class DockLayout;
class Document;
class HoldKey;
class LightGizmos;
class LightsPanel;
class PickReadout;
class ReferencePhoto;
class RigEdit;
class RigGizmos;
class EnvironmentPanel;
class Snapshots;
class SnapshotsPanel;
class TaskRunner;
class Viewport;

class ViewTools : public QObject {
  Q_OBJECT
 public:
  ViewTools(Document& document, TaskRunner& tasks, Viewport& viewport, QWidget& window);
  /// What stands beside the viewport when it is wanted there.
  [[nodiscard]] QWidget* besideView(QWidget* parent);
  void addDocks(DockLayout& docks);
  void connectPanels(LightsPanel& lights, CameraPanel& camera, EnvironmentPanel& environment);
  void fillViewMenu(QMenu* menu);
  void fillLightMenu(QMenu* menu);

  [[nodiscard]] LightGizmos& gizmos() { return *m_gizmos; }
  [[nodiscard]] RigGizmos& rigGizmos() { return *m_rigGizmos; }
  [[nodiscard]] RigEdit& rig() { return *m_rig; }
  [[nodiscard]] PickReadout& readout() { return *m_readout; }
  [[nodiscard]] Snapshots& snapshots() { return *m_snapshots; }
  [[nodiscard]] CameraHistory& cameraHistory() { return *m_history; }
  [[nodiscard]] MeasureTool& ruler() { return m_ruler; }
  [[nodiscard]] ReferencePhoto& reference() { return *m_reference; }

  void takeSnapshot();
  /// -1 ends the comparison.
  void compareWithSnapshot(int index);
  enum class Side { Left, Right };
  /// The look as it is now, but for the current slot, which wears a preset. On the left it stands instead of the
  /// document until the comparison ends.
  void compareWithPreset(const std::string& preset, Side side = Side::Right);

 Q_SIGNALS:
  void message(dermis::MessageKind kind, const QString& sentence);

 private:
  QAction* add(QMenu* menu, const QString& label, const char* name, const QKeySequence& keys,
               const std::function<void()>& does);
  QAction* addSwitch(QMenu* menu, const QString& label, const char* name, const QKeySequence& keys, bool on,
                     const std::function<void(bool)>& does);
  void fillCompareMenu(QMenu* menu);
  void fillBookmarksMenu(QMenu* menu);
  /// The snapshot that is compared with has another place in the strip now, or is gone.
  void followSnapshots();
  void compare(Side side, const std::shared_ptr<const ResolvedScene>& scene, const QString& name);

  struct Compared {
    std::shared_ptr<const ResolvedScene> scene;
    QString name;
  };
  Compared m_left, m_right;  ///< no scene on the left: the document
  Document& m_document;
  TaskRunner& m_tasks;
  Viewport& m_viewport;
  QWidget& m_window;
  LightGizmos* m_gizmos = nullptr;
  RigEdit* m_rig = nullptr;
  RigGizmos* m_rigGizmos = nullptr;
  PickReadout* m_readout = nullptr;
  SplitHandle m_split;
  MeasureTool m_ruler;
  ReferencePhoto* m_reference = nullptr;
  CameraHistory* m_history = nullptr;
  BookmarksBox* m_bookmarks = nullptr;
  Snapshots* m_snapshots = nullptr;
  SnapshotsPanel* m_strip = nullptr;
  QWidget* m_stripDock = nullptr;
  HoldKey* m_keyLight = nullptr;
};

}  // namespace dermis
