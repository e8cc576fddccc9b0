// The menus of the main window. Every command has a shortcut where hands expect one.
#include <QActionGroup>
#include <QApplication>
#include <QDockWidget>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>

#include "core/scene/cameras.h"
#include "ui/docks/lights_panel.h"
#include "ui/docks/material_clipboard.h"
#include "ui/docks/material_panel.h"
#include "ui/docks/textures_panel.h"
#include "ui/main_window/dock_layout.h"
#include "ui/main_window/file_actions.h"
#include "ui/main_window/main_window.h"
#include "ui/main_window/model_unit_bar.h"
#include "ui/main_window/program_actions.h"
#include "ui/main_window/view_tools.h"
#include "ui/text.h"
#include "ui/theme/icons.h"
#include "ui/translation.h"
#include "ui/viewport/hold_key.h"
#include "ui/viewport/view_modes.h"
#include "ui/viewport/viewport.h"

namespace dermis {
namespace {

/// `id` names the command whatever the language: the keys that a person gives it are kept under it.
template <class Slot>
QAction* add(QMenu* menu, const QString& id, const char* icon, const QString& label, const QKeySequence& keys,
             QObject* context, Slot slot) {
  QAction* action = menu->addAction(label);
  action->setObjectName(id);
  if (icon != nullptr) action->setIcon(themeIcon(icon));
  action->setShortcut(keys);
  QObject::connect(action, &QAction::triggered, context, slot);
  return action;
}

}  // namespace

void MainWindow::buildMenus() {
  buildFileMenu();
  buildEditMenu();
  buildViewMenu();
  buildLightMenu();
  buildRenderMenu();
  buildWindowMenu();
  buildHelpMenu();
  m_program->finish();
}

void MainWindow::buildFileMenu() {
  QMenu* menu = menuBar()->addMenu(tr("&File"));
  add(menu, QStringLiteral("file.new"), "new", tr("&New"), QKeySequence::New, this, [this] { m_files->newScene(); });
  add(menu, QStringLiteral("file.open"), "open", tr("&Open…"), QKeySequence::Open, this, [this] { m_files->open(); });
  QMenu* recent = menu->addMenu(tr("Open &recent"));
  recent->setToolTipsVisible(true);
  recent->setProperty("changing", true);
  connect(recent, &QMenu::aboutToShow, this, [this, recent] { m_files->fillRecentMenu(recent); });
  add(menu, QStringLiteral("file.openModel"), nullptr, tr("Open &model…"), QKeySequence(QStringLiteral("Ctrl+M")), this,
      [this] { m_files->openModel(); });
  add(menu, QStringLiteral("file.modelUnit"), nullptr, tr("Model &unit…"), {}, this, [this] { m_unit->ask(); });
  add(menu, QStringLiteral("file.environment"), "environment", tr("Choose &environment…"),
      QKeySequence(QStringLiteral("Ctrl+E")), this, [this] { m_files->chooseEnvironment(); });
  add(menu, QStringLiteral("file.maps"), nullptr, tr("Choose a &folder of maps…"), {}, this,
      [this] { m_textures->chooseFolder(); });
  menu->addSeparator();
  add(menu, QStringLiteral("file.save"), "save", tr("&Save scene"), QKeySequence::Save, this,
      [this] { m_files->save(); });
  add(menu, QStringLiteral("file.saveAs"), nullptr, tr("Save scene &as…"), QKeySequence(QStringLiteral("Ctrl+Shift+S")),
      this, [this] { m_files->saveAs(); });
  menu->addSeparator();
  add(menu, QStringLiteral("file.savePreset"), "preset", tr("Save &preset"), QKeySequence(QStringLiteral("Ctrl+P")),
      this, [this] { m_files->savePreset(); });
  add(menu, QStringLiteral("file.savePresetAs"), nullptr, tr("Save preset as…"),
      QKeySequence(QStringLiteral("Ctrl+Shift+P")), this, [this] { m_files->savePresetAs(); });
  menu->addSeparator();
  add(menu, QStringLiteral("file.quit"), nullptr, tr("&Quit"), QKeySequence::Quit, this, [this] { close(); });
}

void MainWindow::buildEditMenu() {
  QMenu* menu = menuBar()->addMenu(tr("&Edit"));
  QAction* undo = m_document.undoStack().createUndoAction(this, tr("&Undo"));
  undo->setObjectName(QStringLiteral("edit.undo"));
  undo->setShortcut(QKeySequence::Undo);
  undo->setIcon(themeIcon("undo"));
  QAction* redo = m_document.undoStack().createRedoAction(this, tr("&Redo"));
  redo->setObjectName(QStringLiteral("edit.redo"));
  redo->setShortcuts({QKeySequence(QStringLiteral("Ctrl+Shift+Z")), QKeySequence(QStringLiteral("Ctrl+Y"))});
  redo->setIcon(themeIcon("redo"));
  menu->addAction(undo);
  menu->addAction(redo);
  menu->addSeparator();
  menu->addAction(m_material->clipboard()->copyMaterialAction());
  menu->addAction(m_material->clipboard()->pasteAction());
  menu->addSeparator();
  add(menu, QStringLiteral("edit.find"), "search", tr("&Find parameter"), QKeySequence::Find, this,
      [this] { m_material->focusSearch(); });
  add(menu, QStringLiteral("edit.revert"), "reset", tr("Re&vert material to its preset"), {}, this,
      [this] { m_loading.revertToPreset(m_document.editedSlots()); });
  m_program->fillEditMenu(menu);
}

void MainWindow::buildViewMenu() {
  QMenu* menu = menuBar()->addMenu(tr("&View"));
  add(menu, QStringLiteral("view.frame"), "frame", tr("&Frame"), QKeySequence(Qt::Key_F), this,
      [this] { m_viewport->frameAll(); });
  QMenu* views = menu->addMenu(tr("&Ready-made views"));
  for (const NamedCameraRow& row : namedCameras()) {
    // 1 to 4 are the four views of the published program.
    static const QStringList kNumbered = {QStringLiteral("top-right"), QStringLiteral("top-left"),
                                          QStringLiteral("bottom-right"), QStringLiteral("bottom-left")};
    const QString id = text(row.id);
    const qsizetype number = kNumbered.indexOf(id) + 1;
    add(views, QStringLiteral("view.camera.") + id, nullptr, tableText(row.label),
        number > 0 ? QKeySequence(QString::number(number)) : QKeySequence(), this,
        [this, id] { m_viewport->showNamedView(id); });
  }
  menu->addSeparator();
  buildViewModes(menu);
  m_tools->fillViewMenu(menu);
  menu->addSeparator();
  QAction* statistics =
      add(menu, QStringLiteral("view.statistics"), nullptr, tr("S&tatistics"), {}, this, [this](bool on) {
        PreferenceValues values = m_preferences.values();
        values.statistics = on;
        m_preferences.set(values);
      });
  statistics->setCheckable(true);
  statistics->setChecked(m_preferences.values().statistics);
  connect(&m_preferences, &Preferences::changed, statistics,
          [this, statistics] { statistics->setChecked(m_preferences.values().statistics); });
}

void MainWindow::buildViewModes(QMenu* menu) {
  auto* group = new QActionGroup(this);
  for (const ViewMode& mode : viewModes()) {
    QAction* action = add(menu, QStringLiteral("view.show.") + text(toString(mode.aov)), nullptr, mode.label, {}, this,
                          [this, aov = mode.aov] { m_viewport->setAov(aov); });
    action->setStatusTip(mode.help);
    action->setCheckable(true);
    action->setChecked(mode.aov == m_viewport->aov());
    action->setData(static_cast<int>(mode.aov));
    group->addAction(action);
  }
  connect(m_viewport, &Viewport::aovChanged, group, [group](Aov aov) {
    for (QAction* action : group->actions()) action->setChecked(action->data().toInt() == static_cast<int>(aov));
  });
  menu->addSeparator();
  const auto step = [this](int steps) { m_viewport->setAov(nextView(m_viewport->aov(), steps)); };
  add(menu, QStringLiteral("view.next"), nullptr, tr("&Next of these"), QKeySequence(Qt::Key_B), this,
      [step] { step(1); });
  add(menu, QStringLiteral("view.previous"), nullptr, tr("Pre&vious of these"), QKeySequence(Qt::SHIFT | Qt::Key_B),
      this, [step] { step(-1); });
  // The key shows it while it is held; the entry keeps it, for hands that can't hold one.
  QAction* without = add(menu, QStringLiteral("view.withoutSubsurface"), nullptr, tr("&Without subsurface"), {}, this,
                         [this](bool on) { m_viewport->setWithoutSubsurface(on); });
  without->setCheckable(true);
  auto* hold = new HoldKey(QStringLiteral("view.seeWithoutSubsurface"), tr("See without subsurface"),
                           QKeySequence(Qt::Key_N), *this);
  const auto name = [hold, without] {
    const QString key = hold->key().toString(QKeySequence::NativeText);
    without->setText(key.isEmpty() ? tr("&Without subsurface")
                                   : tr("&Without subsurface") + QLatin1Char('\t') + tr("hold %1").arg(key));
  };
  connect(hold, &HoldKey::keyChanged, without, name);
  name();
  connect(hold, &HoldKey::held, this,
          [this, without](bool down) { m_viewport->setWithoutSubsurface(down != without->isChecked()); });
}

void MainWindow::buildLightMenu() {
  QMenu* menu = menuBar()->addMenu(tr("&Light"));
  add(menu, QStringLiteral("light.addPoint"), "light", tr("Add &point light"), {}, this,
      [this] { m_lights->addLight(LightType::Point); });
  add(menu, QStringLiteral("light.addDirectional"), "sun", tr("Add &directional light"), {}, this,
      [this] { m_lights->addLight(LightType::Directional); });
  add(menu, QStringLiteral("light.addSpot"), "spot", tr("Add &spot light"), {}, this,
      [this] { m_lights->addLight(LightType::Spot); });
  add(menu, QStringLiteral("light.remove"), "remove", tr("&Remove selected light"), {}, this,
      [this] { m_lights->removeSelected(); });
  m_tools->fillLightMenu(menu);
  menu->addSeparator();
  add(menu, QStringLiteral("light.environment"), "environment", tr("Choose &environment…"), {}, this,
      [this] { m_files->chooseEnvironment(); });
  add(menu, QStringLiteral("light.resetRotation"), "reset", tr("Reset environment r&otation"), {}, this, [this] {
    EnvironmentSource next = m_document.scene().environment;
    next.rotationDegrees = 0.0F;
    m_document.setEnvironmentSettings(next, tr("Rotate environment"), newGesture());
  });
}

void MainWindow::buildRenderMenu() {
  QMenu* menu = menuBar()->addMenu(tr("&Render"));
  add(menu, QStringLiteral("render.savePicture"), "camera", tr("&Save a picture…"), QKeySequence(Qt::Key_F12), this,
      [this] { askForPicture(); });
  menu->addSeparator();
  QMenu* samples = menu->addMenu(tr("&Samples while still"));
  auto* group = new QActionGroup(this);
  for (const int count : {1, 16, 64, 256}) {
    QAction* action = add(samples, QStringLiteral("render.samples.%1").arg(count), nullptr, QString::number(count), {},
                          this, [this, count] {
                            PreferenceValues values = m_preferences.values();
                            values.stillSamples = count;
                            m_preferences.set(values);
                          });
    action->setCheckable(true);
    const auto show = [this, action, count] { action->setChecked(count == m_preferences.values().stillSamples); };
    connect(&m_preferences, &Preferences::changed, action, show);
    show();
    group->addAction(action);
  }
}

void MainWindow::buildWindowMenu() {
  QMenu* menu = menuBar()->addMenu(tr("&Window"));
  for (QDockWidget* dock : m_docks->docks()) {
    QAction* action = dock->toggleViewAction();
    action->setObjectName(QStringLiteral("window.") + dock->objectName());
    menu->addAction(action);
  }
  menu->addSeparator();
  add(menu, QStringLiteral("window.toggleAll"), nullptr, tr("&Hide or show all panels"),
      QKeySequence(QStringLiteral("Ctrl+Tab")), this, [this] { m_docks->toggleAll(); });
  add(menu, QStringLiteral("window.float"), nullptr, tr("&Float or dock the panel in use"),
      QKeySequence(QStringLiteral("Ctrl+Shift+D")), this, [this] { m_docks->toggleFloating(); });
  m_program->fillWindowMenu(menu);
  add(menu, QStringLiteral("window.reset"), nullptr, tr("&Reset layout"), {}, this, [this] { m_docks->reset(); });
}

void MainWindow::buildHelpMenu() {
  QMenu* menu = menuBar()->addMenu(tr("&Help"));
  m_program->fillHelpMenu(menu);
  add(menu, QStringLiteral("help.about"), "info", tr("&About Dermis"), {}, this, [this] {
    QString gl = tr("No OpenGL");
    if (const auto info = m_viewport->glInfo())
      gl = QStringLiteral("%1<br>OpenGL %2").arg(text(info->renderer), text(info->version));
    QMessageBox::about(this, tr("About Dermis"),
                       tr("<b>Dermis %1</b><br>An editor for physically based skin.<br><br>%2<br>Qt %3")
                           .arg(QStringLiteral(DERMIS_VERSION), gl, QLatin1String(qVersion())));
  });
}

}  // namespace dermis
