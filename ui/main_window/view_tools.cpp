#include "ui/main_window/view_tools.h"

#include <QAction>
#include <QCoreApplication>
#include <QDockWidget>
#include <QMainWindow>
#include <QMenu>
#include <QSettings>
#include <algorithm>

#include "core/io/asset_loader.h"
#include "core/material/builtin_presets.h"
#include "core/material/preset_io.h"
#include "ui/docks/bookmarks_box.h"
#include "ui/docks/camera_panel.h"
#include "ui/docks/environment_panel.h"
#include "ui/docks/lights_panel.h"
#include "ui/docks/reference_panel.h"
#include "ui/docks/rig_box.h"
#include "ui/document/document.h"
#include "ui/document/lamp_sets.h"
#include "ui/document/material_images.h"
#include "ui/document/rig_edit.h"
#include "ui/jobs/task_runner.h"
#include "ui/main_window/camera_menu.h"
#include "ui/main_window/dock_layout.h"
#include "ui/snapshots/snapshot_pictures.h"
#include "ui/snapshots/snapshots.h"
#include "ui/snapshots/snapshots_panel.h"
#include "ui/text.h"
#include "ui/theme/icons.h"
#include "ui/translation.h"
#include "ui/viewport/camera_history.h"
#include "ui/viewport/hold_key.h"
#include "ui/viewport/light_gizmos.h"
#include "ui/viewport/pick_readout.h"
#include "ui/viewport/rig_gizmos.h"
#include "ui/viewport/viewport.h"

namespace dermis {
namespace {
constexpr double kSplitStep = 0.02;
}

ViewTools::ViewTools(Document& document, TaskRunner& tasks, Viewport& viewport, QWidget& window)
    : QObject(&window),
      m_document(document),
      m_tasks(tasks),
      m_viewport(viewport),
      m_window(window),
      m_split(viewport),
      m_ruler(document, viewport) {
  m_gizmos = new LightGizmos(document, viewport);
  m_rig = new RigEdit(document, tasks, this);
  m_rigGizmos = new RigGizmos(document, *m_rig, viewport);
  connect(&viewport, &Viewport::jobProgress, m_rig,
          [this](const QString& what) { m_rig->setPictureBusy(!what.isEmpty()); });
  m_readout = new PickReadout(document, viewport);
  m_history = new CameraHistory(document, viewport);
  m_snapshots = new Snapshots(document, this);
  connect(m_snapshots, &Snapshots::changed, this, &ViewTools::followSnapshots);
  auto* pictures = new SnapshotPictures(*m_snapshots, tasks, viewport, this);
  connect(pictures, &SnapshotPictures::problem, this,
          [this](const QString& sentence) { Q_EMIT message(MessageKind::Error, sentence); });
  m_keyLight = new HoldKey(QStringLiteral("light.moveKeyLight"), tr("Move the key light with the pointer"),
                           QKeySequence(Qt::Key_L), window);
  connect(m_keyLight, &HoldKey::held, m_gizmos, &LightGizmos::holdKeyLight);
  connect(m_gizmos, &LightGizmos::message, this,
          [this](const QString& sentence) { Q_EMIT message(MessageKind::Info, sentence); });
  viewport.addTool(&m_ruler);
  viewport.addTool(&m_split);
  viewport.addTool(m_gizmos);
  viewport.addTool(m_rigGizmos);
  viewport.addTool(m_readout);
  m_reference = new ReferencePhoto(viewport, tasks);
  viewport.addTool(m_reference);
  connect(m_reference, &ReferencePhoto::problem, this,
          [this](const QString& sentence) { Q_EMIT message(MessageKind::Error, sentence); });
  connect(&viewport, &Viewport::clicked, this, [this](const QPointF& at, Qt::KeyboardModifiers keys) {
    if (keys == Qt::AltModifier) m_readout->selectSlot(at);
    if (keys == Qt::ControlModifier) m_readout->pin(at);
  });
  connect(&viewport, &Viewport::comparisonChanged, this, [this] {
    if (m_viewport.compared() != nullptr) return;
    m_left = m_right = {};
    if (m_strip != nullptr) m_strip->showCompared(-1);
  });
}

QWidget* ViewTools::besideView(QWidget* parent) { return new ReferenceView(*m_reference, parent); }

void ViewTools::addDocks(DockLayout& docks) {
  docks.addPanel<ReferencePanel>(tr("Reference"), QStringLiteral("reference"), *m_reference);
  m_strip = docks.addPanel<SnapshotsPanel>(tr("Snapshots"), QStringLiteral("snapshots"), *m_snapshots);
  m_stripDock = qobject_cast<QDockWidget*>(m_strip->parentWidget());
  connect(m_strip, &SnapshotsPanel::takeRequested, this, &ViewTools::takeSnapshot);
  connect(m_strip, &SnapshotsPanel::compareRequested, this, &ViewTools::compareWithSnapshot);
}

void ViewTools::connectPanels(LightsPanel& lights, CameraPanel& camera, EnvironmentPanel& environment) {
  environment.rigBox()->setEdit(*m_rig);
  connect(&lights, &LightsPanel::selectionChanged, m_gizmos, &LightGizmos::select);
  connect(m_gizmos, &LightGizmos::selectionChanged, &lights, &LightsPanel::select);
  m_bookmarks = camera.bookmarks();
  connect(m_bookmarks, &BookmarksBox::visited, m_history, &CameraHistory::note);
}

QAction* ViewTools::add(QMenu* menu, const QString& label, const char* name, const QKeySequence& keys,
                        const std::function<void()>& does) {
  QAction* action = menu->addAction(label);
  action->setObjectName(QLatin1String(name));
  action->setShortcut(keys);
  connect(action, &QAction::triggered, this, does);
  return action;
}

QAction* ViewTools::addSwitch(QMenu* menu, const QString& label, const char* name, const QKeySequence& keys, bool on,
                              const std::function<void(bool)>& does) {
  QAction* action = menu->addAction(label);
  action->setObjectName(QLatin1String(name));
  action->setShortcut(keys);
  action->setCheckable(true);
  action->setChecked(on);
  connect(action, &QAction::toggled, this, does);
  return action;
}

void ViewTools::fillViewMenu(QMenu* menu) {
  menu->addSeparator();
  fillCameraMenu(menu->addMenu(tr("Mov&e the camera")), m_document, m_viewport);
  fillBookmarksMenu(menu->addMenu(tr("Camera &bookmarks")));
  QAction* back =
      add(menu, tr("Camera bac&k"), "view.back", QKeySequence(Qt::ALT | Qt::Key_Left), [this] { m_history->back(); });
  QAction* forward = add(menu, tr("Camera f&orward"), "view.forward", QKeySequence(Qt::ALT | Qt::Key_Right),
                         [this] { m_history->forward(); });
  connect(menu, &QMenu::aboutToShow, this, [this, back, forward] {
    back->setEnabled(m_history->canGoBack());
    forward->setEnabled(m_history->canGoForward());
  });
  // A shortcut has to work whatever the menu said when it was last open.
  connect(menu, &QMenu::aboutToHide, this, [back, forward] {
    back->setEnabled(true);
    forward->setEnabled(true);
  });
  menu->addSeparator();
  add(menu, tr("Ta&ke a snapshot"), "view.takeSnapshot", QKeySequence(QStringLiteral("Ctrl+T")),
      [this] { takeSnapshot(); });
  fillCompareMenu(menu->addMenu(tr("Co&mpare")));
  menu->addSeparator();
  addSwitch(menu, tr("Grey and chrome ba&lls"), "view.balls", {}, false, [this](bool on) {
    ReferenceObjects next = m_viewport.references();
    next.balls = on;
    m_viewport.setReferences(next);
  });
  addSwitch(menu, tr("Colour c&hart"), "view.chart", {}, false, [this](bool on) {
    ReferenceObjects next = m_viewport.references();
    next.chart = on;
    m_viewport.setReferences(next);
  });
  QAction* ruler = addSwitch(menu, tr("R&uler"), "view.ruler", QKeySequence(Qt::Key_M), false,
                             [this](bool on) { m_ruler.setEnabled(on); });
  add(menu, tr("Ruler from or to the middle of the picture"), "view.rulerMiddle", QKeySequence(Qt::SHIFT | Qt::Key_M),
      [this, ruler] {
        ruler->setChecked(true);
        if (!m_ruler.markMiddle())
          Q_EMIT message(MessageKind::Info, tr("The model is not in the middle of the picture: turn or move the "
                                               "camera until what is to be measured is."));
      });
  const bool reads = QSettings().value(QStringLiteral("view/readout"), true).toBool();
  m_readout->setEnabled(reads);
  addSwitch(menu, tr("Pixel &readout"), "view.readout", {}, reads, [this](bool on) {
    QSettings().setValue(QStringLiteral("view/readout"), on);
    m_readout->setEnabled(on);
  });
  add(menu, tr("P&in what is under the pointer"), "view.pin", QKeySequence(Qt::Key_I),
      [this] { m_readout->pinHere(); });
  add(menu, tr("Cle&ar pins"), "view.clearPins", QKeySequence(Qt::SHIFT | Qt::Key_I),
      [this] { m_readout->clearPins(); });
}

void ViewTools::fillLightMenu(QMenu* menu) {
  QMenu* sets = menu->addMenu(tr("&Set of lamps"));
  sets->setToolTipsVisible(true);
  for (const LampSet& set : lampSets()) {
    QAction* action = add(sets, QCoreApplication::translate("lamps", set.label), set.id, {},
                          [this, id = QLatin1String(set.id)] { useLampSet(m_document, id); });
    action->setObjectName(QStringLiteral("light.set.") + QLatin1String(set.id));
    action->setToolTip(QCoreApplication::translate("lamps", set.help));
  }
  const bool shown = QSettings().value(QStringLiteral("view/gizmos"), true).toBool();
  m_gizmos->setEnabled(shown);
  m_rigGizmos->setEnabled(shown);
  addSwitch(menu, tr("Light &handles in the picture"), "light.gizmos", QKeySequence(Qt::Key_G), shown, [this](bool on) {
    QSettings().setValue(QStringLiteral("view/gizmos"), on);
    m_gizmos->setEnabled(on);
    m_rigGizmos->setEnabled(on);
  });
}

// --- bookmarks
// ------------------------------------------------------------------------------------------------------

void ViewTools::fillBookmarksMenu(QMenu* menu) {
  menu->setProperty("changing", true);  // its entries are the scene's
  connect(menu, &QMenu::aboutToShow, this, [this, menu] {
    menu->clear();
    add(menu, tr("&Add bookmark"), "view.addBookmark", {}, [this] { m_bookmarks->addHere(); });
    menu->addSeparator();
    const auto& bookmarks = m_document.scene().bookmarks;
    for (std::size_t i = 0; i < bookmarks.size(); ++i)
      connect(menu->addAction(text(bookmarks[i].name)), &QAction::triggered, this,
              [this, i] { m_bookmarks->goTo(static_cast<int>(i)); });
  });
}

// --- comparing
// ------------------------------------------------------------------------------------------------------

void ViewTools::takeSnapshot() {
  // Left of two presets that are compared the document isn't seen: its picture follows.
  m_snapshots->take(m_viewport.comparedLeft() != nullptr ? QImage() : m_viewport.picture());
  if (m_stripDock == nullptr || !m_stripDock->isHidden()) return;
  m_stripDock->show();
  // As high as one row of pictures: the rest is the viewport's.
  auto* window = qobject_cast<QMainWindow*>(&m_window);
  auto* dock = qobject_cast<QDockWidget*>(m_stripDock);
  if (window != nullptr && dock != nullptr)
    window->resizeDocks({dock}, {dock->minimumSizeHint().height()}, Qt::Vertical);
}

void ViewTools::compare(Side side, const std::shared_ptr<const ResolvedScene>& scene, const QString& name) {
  (side == Side::Left ? m_left : m_right) = {scene, name};
  // Something stands on the right of it.
  if (!m_right.scene) m_right = {m_document.snapshot(), tr("Now")};
  m_split.setNames(m_left.scene ? m_left.name : tr("Now"), m_right.name);
  m_viewport.compareWith(m_right.scene, m_left.scene);
}

void ViewTools::compareWithSnapshot(int index) {
  const auto& all = m_snapshots->all();
  if (index < 0 || index >= static_cast<int>(all.size())) {
    m_viewport.compareWith(nullptr);
    return;
  }
  const Snapshot& snapshot = all[static_cast<std::size_t>(index)];
  compare(Side::Right, snapshot.scene, snapshot.name);
  m_strip->showCompared(index);
}

void ViewTools::followSnapshots() {
  if (m_strip == nullptr || m_strip->compared() < 0) return;
  const auto& all = m_snapshots->all();
  const auto found = std::ranges::find(all, m_viewport.compared(), [](const Snapshot& s) { return s.scene.get(); });
  compareWithSnapshot(found == all.end() ? -1 : static_cast<int>(found - all.begin()));
}

void ViewTools::compareWithPreset(const std::string& preset, Side side) {
  const std::shared_ptr<const ResolvedScene> now = m_document.snapshot();
  const qsizetype slot = m_document.slotNames().indexOf(m_document.currentSlot());
  if (!now || slot < 0) return;
  m_tasks.run(
      QStringLiteral("compare"), tr("Loading preset"),
      [preset](std::stop_token stop) -> Result<ResolvedMaterial> {
        Warnings warnings;  // told when the preset is put on
        const Result<Material> material = loadPreset(preset, warnings);
        if (!material) return tl::unexpected(material.error());
        ResolveOptions options;
        options.stop = stop;
        return decodeMaps(*material, nullptr, options, warnings);
      },
      [this, now, slot, side](const Result<ResolvedMaterial>& material) {
        if (!material) {
          if (material.error().kind != Error::Kind::Cancelled)
            Q_EMIT message(MessageKind::Error, text(material.error().message));
          return;
        }
        auto scene = std::make_shared<ResolvedScene>(*now);
        scene->slots.at(static_cast<std::size_t>(slot)) = *material;
        compare(side, scene, text(material->material.name));
        if (side == Side::Right) m_strip->showCompared(-1);
      });
}

void ViewTools::fillCompareMenu(QMenu* menu) {
  add(menu, tr("With the selected &snapshot"), "view.compareSnapshot", QKeySequence(Qt::Key_C), [this] {
    const bool on = m_viewport.compared() == nullptr;
    compareWithSnapshot(on ? m_strip->selected() : -1);
  });
  QMenu* presets = menu->addMenu(tr("With a &preset on the current slot"));
  for (const BuiltinPreset& row : builtinPresets())
    add(presets, tableText(row.name), ("view.comparePreset." + row.id).c_str(), {},
        [this, id = row.id] { compareWithPreset("builtin:" + id); });
  const auto move = [this](double by) {
    if (m_viewport.compared() != nullptr) m_viewport.setSplit(m_viewport.split() + by);
  };
  onPicture(m_viewport, add(menu, tr("Split further &left"), "view.splitLeft", QKeySequence(Qt::CTRL | Qt::Key_Left),
                            [move] { move(-kSplitStep); }));
  onPicture(m_viewport, add(menu, tr("Split further &right"), "view.splitRight", QKeySequence(Qt::CTRL | Qt::Key_Right),
                            [move] { move(kSplitStep); }));
  add(menu, tr("&End comparison"), "view.compareEnd", {}, [this] { m_viewport.compareWith(nullptr); });
}

}  // namespace dermis
