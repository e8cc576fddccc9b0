// The window: assembles document, viewport, docks and menus; decides nothing.
#pragma once

#include <QElapsedTimer>
#include <QMainWindow>
#include <QTimer>
#include <filesystem>
#include <vector>

#include "ui/document/document.h"
#include "ui/document/loading.h"
#include "ui/jobs/picture_job.h"
#include "ui/jobs/task_runner.h"
#include "ui/jobs/time_left.h"
#include "ui/preferences/preferences.h"

class QLabel;
class QMenu;
class QProgressBar;
class QToolButton;

namespace dermis {

class CameraPanel;
class DiffusionPanel;
class DockLayout;
class EnvironmentPanel;
class Exports;
class FileActions;
class LightsPanel;
class LogPanel;
class MaterialPanel;
class MessageBar;
class ModelUnitBar;
class PictureScenes;
class PresetsPanel;
class ProgramActions;
class SafetyNet;
class TexturesPanel;
class ViewTools;
class Viewport;

class MainWindow : public QMainWindow {
  Q_OBJECT
 public:
  explicit MainWindow(QWidget* parent = nullptr);
  ~MainWindow() override;

  /// The embedded look, or what the files say.
  void open(const std::vector<std::filesystem::path>& files);
  void setPictureMetadata(PictureMetadata metadata);
  void savePicture(const PictureRequest& request);
  /// Opens any file by its kind; a scene asks about unsaved changes first.
  void openFile(const QString& path);

  [[nodiscard]] Document& document() { return m_document; }
  [[nodiscard]] Loading& loading() { return m_loading; }
  [[nodiscard]] TaskRunner& tasks() { return m_tasks; }
  [[nodiscard]] Viewport* viewport() const { return m_viewport; }
  [[nodiscard]] ViewTools* viewTools() const { return m_tools; }
  [[nodiscard]] FileActions* fileActions() const { return m_files; }
  [[nodiscard]] Preferences& preferences() { return m_preferences; }
  [[nodiscard]] ProgramActions* programActions() const { return m_program; }
  [[nodiscard]] SafetyNet* safetyNet() const { return m_safetyNet; }
  [[nodiscard]] MessageBar* messageBar() const { return m_messages; }

 protected:
  void showEvent(QShowEvent* event) override;
  void closeEvent(QCloseEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  void buildCentre();
  void buildDocks();
  void buildStatusBar();
  void connectParts();
  void refreshTitle();
  void refreshActivity();
  void showActivity();
  void tell(MessageKind kind, const QString& sentence);
  void askForPicture();
  void openDropped(const QStringList& paths, const QString& seen);
  /// What a drop on the slot `seen` goes to: it becomes the edited one, unless it is edited together with others.
  QStringList slotsFor(const QString& seen);
  /// What shows a length of the model says it in the unit of the preferences.
  void refreshLengths();

  // menus.cpp
  void buildMenus();
  void buildFileMenu();
  void buildEditMenu();
  void buildViewMenu();
  void buildViewModes(QMenu* menu);
  void buildLightMenu();
  void buildRenderMenu();
  void buildWindowMenu();
  void buildHelpMenu();

  Document m_document;
  TaskRunner m_tasks;
  Loading m_loading{m_document, m_tasks};
  Preferences m_preferences;
  FileActions* m_files = nullptr;
  SafetyNet* m_safetyNet = nullptr;
  ProgramActions* m_program = nullptr;
  Exports* m_exports = nullptr;
  PictureScenes* m_pictures = nullptr;
  DockLayout* m_docks = nullptr;
  Viewport* m_viewport = nullptr;
  ViewTools* m_tools = nullptr;
  MessageBar* m_messages = nullptr;
  ModelUnitBar* m_unit = nullptr;
  MaterialPanel* m_material = nullptr;
  TexturesPanel* m_textures = nullptr;
  LightsPanel* m_lights = nullptr;
  EnvironmentPanel* m_environment = nullptr;
  CameraPanel* m_camera = nullptr;
  DiffusionPanel* m_diffusion = nullptr;
  PresetsPanel* m_presets = nullptr;
  LogPanel* m_log = nullptr;
  QLabel* m_activity = nullptr;
  QLabel* m_about = nullptr;
  QProgressBar* m_progress = nullptr;
  QToolButton* m_cancel = nullptr;
  QString m_jobTitle;
  QTimer m_tellActivity;
  double m_jobFraction = 0.0;
  double m_pictureFraction = -1.0;
  TimeLeft m_timeLeft;
  QElapsedTimer m_clock;
};

}  // namespace dermis
