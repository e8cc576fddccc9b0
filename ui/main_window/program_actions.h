// What belongs to the program rather than to a scene: preferences, shortcuts, layouts, the guide.
#pragma once

#include <QObject>

#include "ui/preferences/shortcuts.h"

class QMainWindow;
class QMenu;

namespace dermis {

class Autosave;
class DockLayout;
class GuideWindow;
class Layouts;
class Preferences;
class Viewport;

class ProgramActions : public QObject {
  Q_OBJECT
 public:
  struct Parts {
    QMainWindow& window;
    Preferences& preferences;
    DockLayout& docks;
    Viewport& viewport;
    Autosave& autosave;
  };
  explicit ProgramActions(const Parts& parts);
  ~ProgramActions() override;

  void fillEditMenu(QMenu* menu);
  void fillWindowMenu(QMenu* menu);
  void fillHelpMenu(QMenu* menu);
  /// Once all menus are there.
  void finish();

  [[nodiscard]] Shortcuts& shortcuts() { return m_shortcuts; }
  [[nodiscard]] Layouts& layouts() { return *m_layouts; }
  /// Opens the guide, or brings it to the front.
  GuideWindow* showGuide(const QString& page = {});

 private:
  void apply();

  Parts m_parts;
  Shortcuts m_shortcuts;
  Layouts* m_layouts = nullptr;
  GuideWindow* m_guide = nullptr;
};

}  // namespace dermis
