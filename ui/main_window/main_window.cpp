#include "ui/main_window/main_window.h"

#include <QCloseEvent>
#include <QDockWidget>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QMimeData>
#include <QProgressBar>
#include <QScreen>
#include <QStandardPaths>
#include <QStatusBar>
#include <QTimer>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/browse/preset_list.h"
#include "ui/docks/camera_panel.h"
#include "ui/docks/diffusion_panel.h"
#include "ui/docks/dropped_paths.h"
#include "ui/docks/environment_panel.h"
#include "ui/docks/history_panel.h"
#include "ui/docks/lights_panel.h"
#include "ui/docks/log_panel.h"
#include "ui/docks/material_panel.h"
#include "ui/docks/presets_panel.h"
#include "ui/docks/rig_box.h"
#include "ui/docks/slot_drag.h"
#include "ui/docks/textures_panel.h"
#include "ui/document/rig_edit.h"
#include "ui/main_window/dock_layout.h"
#include "ui/main_window/dropped_files.h"
#include "ui/main_window/exports.h"
#include "ui/main_window/file_actions.h"
#include "ui/main_window/keep_on_screen.h"
#include "ui/main_window/message_bar.h"
#include "ui/main_window/model_unit_bar.h"
#include "ui/main_window/picture_scenes.h"
#include "ui/main_window/program_actions.h"
#include "ui/main_window/safety_net.h"
#include "ui/main_window/view_tools.h"
#include "ui/rows/accessible_values.h"
#include "ui/rows/number_text.h"
#include "ui/rows/property_row.h"
#include "ui/text.h"
#include "ui/viewport/pick_readout.h"
#include "ui/viewport/viewport.h"

namespace dermis {
namespace {
// Software drivers compose the whole window again for a word in the status bar: what is over soon isn't told, and the
// rest not at every step.
constexpr int kTellActivityAfterMs = 500;
constexpr int kTellActivityEveryMs = 150;
}  // namespace

MainWindow::MainWindow(QWidget* parent) : QMainWindow(parent) {
  installAccessibleValues();
  setObjectName(QStringLiteral("mainWindow"));
  setAcceptDrops(true);
  resize(QSize(1600, 1000).boundedTo(screen()->availableSize()));
  m_files = new FileActions(m_document, m_loading, this);
  m_safetyNet = new SafetyNet(m_document, m_loading, this);
  m_exports = new Exports(m_document, m_tasks, *this);
  m_pictures = new PictureScenes(m_loading, m_tasks, *this);
  buildCentre();
  buildDocks();
  buildStatusBar();
  m_program = new ProgramActions({*this, m_preferences, *m_docks, *m_viewport, m_safetyNet->autosave()});
  buildMenus();
  connectParts();
  m_docks->restore();
  refreshTitle();
  m_viewport->setFocus();
}

MainWindow::~MainWindow() = default;

void MainWindow::buildCentre() {
  auto* centre = new QWidget(this);
  auto* column = new QVBoxLayout(centre);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  m_messages = new MessageBar(centre);
  m_viewport = new Viewport(m_document, centre);
  m_unit = new ModelUnitBar(m_document, centre);
  column->addWidget(m_messages);
  column->addWidget(m_unit);
  m_tools = new ViewTools(m_document, m_tasks, *m_viewport, *this);
  auto* row = new QHBoxLayout();
  row->setSpacing(1);
  row->addWidget(m_viewport, 1);
  row->addWidget(m_tools->besideView(centre), 1);
  column->addLayout(row, 1);
  setCentralWidget(centre);
}

void MainWindow::buildDocks() {
  m_docks = new DockLayout(*this);
  m_presets =
      m_docks->addPanel<PresetsPanel>(tr("Presets"), QStringLiteral("presets"), m_document, m_loading, m_preferences);
  m_environment = m_docks->addPanel<EnvironmentPanel>(tr("Environment"), QStringLiteral("environment"), m_document,
                                                      m_loading, m_preferences);
  m_lights = m_docks->addPanel<LightsPanel>(tr("Lights"), QStringLiteral("lights"), m_document);
  m_camera = m_docks->addPanel<CameraPanel>(tr("Camera && view"), QStringLiteral("camera"), m_document);
  m_diffusion = m_docks->addPanel<DiffusionPanel>(tr("Diffusion"), QStringLiteral("diffusion"), m_document);
  m_material = m_docks->addPanel<MaterialPanel>(tr("Material"), QStringLiteral("material"), m_document, m_loading);
  m_textures = m_docks->addPanel<TexturesPanel>(tr("Texture maps"), QStringLiteral("textures"), m_document, m_loading);
  m_log = m_docks->addPanel<LogPanel>(tr("Log"), QStringLiteral("log"));
  m_docks->addPanel<HistoryPanel>(tr("History"), QStringLiteral("history"), m_document.undoStack());
  connect(qobject_cast<QDockWidget*>(m_diffusion->parentWidget()), &QDockWidget::visibilityChanged, m_diffusion,
          &DiffusionPanel::setSeen);
  connect(qobject_cast<QDockWidget*>(m_textures->parentWidget()), &QDockWidget::visibilityChanged, m_textures,
          &TexturesPanel::setSeen);
  m_tools->addDocks(*m_docks);
  m_tools->connectPanels(*m_lights, *m_camera, *m_environment);
}

void MainWindow::buildStatusBar() {
  m_about = new QLabel(this);
  m_activity = new QLabel(this);
  m_activity->setObjectName(QStringLiteral("status.activity"));
  m_progress = new QProgressBar(this);
  m_progress->setTextVisible(false);
  m_progress->setFixedWidth(140);
  m_progress->setAccessibleName(tr("Progress"));
  m_cancel = new QToolButton(this);
  m_cancel->setObjectName(QStringLiteral("status.cancel"));
  m_cancel->setText(tr("Cancel"));
  statusBar()->setSizeGripEnabled(false);
  statusBar()->setContentsMargins(8, 0, 8, 0);
  statusBar()->addWidget(m_about, 1);
  statusBar()->addPermanentWidget(m_activity);
  statusBar()->addPermanentWidget(m_progress);
  statusBar()->addPermanentWidget(m_cancel);
  connect(m_cancel, &QToolButton::clicked, this, [this] {
    m_exports->forgetWaiting();
    m_loading.cancel();
    m_viewport->cancelJobs();
    m_pictureFraction = -1.0;
    refreshActivity();
  });
  refreshActivity();
}

void MainWindow::connectParts() {
  connect(&m_loading, &Loading::message, this, &MainWindow::tell);
  connect(&m_loading, &Loading::modelOpened, m_unit, qOverload<const QString&, const QString&>(&ModelUnitBar::ask));
  connect(&m_loading, &Loading::fileUsed, m_files, &FileActions::remember);
  connect(m_viewport, &Viewport::message, this, &MainWindow::tell);
  connect(m_tools, &ViewTools::message, this, &MainWindow::tell);
  connect(m_exports, &Exports::message, this, &MainWindow::tell);
  connect(&m_tasks, &TaskRunner::problem, this,
          [this](const QString& sentence) { tell(MessageKind::Error, sentence); });
  m_loading.setMayDiscard([this] { return m_files->mayDiscard(); });
  connect(m_exports, &Exports::progressed, this, [this](double fraction) {
    m_pictureFraction = fraction;
    refreshActivity();
  });
  connect(m_camera, &CameraPanel::problem, this,
          [this](const QString& sentence) { tell(MessageKind::Error, sentence); });
  // A row tells what was pasted in vain, whichever dock it stands in.
  for (PropertyRow* row : findChildren<PropertyRow*>())
    connect(row, &PropertyRow::problem, this, [this](const QString& sentence) { tell(MessageKind::Error, sentence); });
  connect(m_viewport, &Viewport::jobProgress, this, [this](const QString& what, double fraction) {
    m_jobTitle = what;
    m_jobFraction = fraction;
    refreshActivity();
  });
  connect(&m_tasks, &TaskRunner::activityChanged, this, &MainWindow::refreshActivity);
  m_tellActivity.setSingleShot(true);
  connect(&m_tellActivity, &QTimer::timeout, this, &MainWindow::showActivity);
  connect(&m_document, &Document::titleChanged, this, &MainWindow::refreshTitle);
  connect(&m_document, &Document::changed, this, [this](Change what) {
    if ((what != Change::Everything && what != Change::Unit) || !m_document.isReady()) return;
    refreshLengths();
  });
  connect(&m_loading, &Loading::framingWanted, m_viewport, &Viewport::frameAll);
  connect(&m_preferences, &Preferences::changed, this, &MainWindow::refreshLengths);
  refreshLengths();
  connect(m_camera, &CameraPanel::viewRequested, m_viewport, &Viewport::showNamedView);
  connect(m_camera, &CameraPanel::aovChosen, m_viewport, &Viewport::setAov);
  connect(m_viewport, &Viewport::aovChanged, m_camera, &CameraPanel::showAov);
  connect(m_viewport, &Viewport::pictureResized, m_diffusion,
          [this](const QSize& pixels) { m_diffusion->setPictureHeight(pixels.height()); });
  connect(m_environment, &EnvironmentPanel::chooseFileRequested, m_files, &FileActions::chooseEnvironment);
  connect(m_environment->rigBox(), &RigBox::saveRequested, m_files, [this] { m_files->saveRig(m_tools->rig().rig()); });
  connect(m_material, &MaterialPanel::savePresetRequested, m_files, &FileActions::savePreset);
  connect(m_presets, &PresetsPanel::compareRequested, m_tools, [this](const QString& path, bool left) {
    m_tools->compareWithPreset(path.toStdString(), left ? ViewTools::Side::Left : ViewTools::Side::Right);
  });
  connect(m_presets, &PresetsPanel::saveRequested, m_files, &FileActions::savePreset);
  connect(m_presets, &PresetsPanel::saveAsRequested, m_files, &FileActions::savePresetAs);
}

void MainWindow::setPictureMetadata(PictureMetadata metadata) { m_exports->setMetadata(std::move(metadata)); }

void MainWindow::open(const std::vector<std::filesystem::path>& files) { m_loading.openAtStart(files); }

void MainWindow::openFile(const QString& path) { m_files->open(path); }

void MainWindow::tell(MessageKind kind, const QString& sentence) {
  m_log->add(kind, sentence);
  if (kind == MessageKind::Info)
    statusBar()->showMessage(sentence, 5000);
  else
    m_messages->showMessage(kind, sentence);
}

void MainWindow::refreshTitle() {
  setWindowTitle(tr("%1[*] — Dermis").arg(m_document.displayName()));
  setWindowModified(m_document.isModified());
}

void MainWindow::refreshActivity() {
  const bool busy = !m_tasks.title().isEmpty() || !m_jobTitle.isEmpty();
  m_presets->thumbnails().hold(busy);
  if (!busy) {
    m_tellActivity.stop();
    showActivity();
  } else if (!m_tellActivity.isActive()) {
    m_tellActivity.start(m_progress->isVisible() ? kTellActivityEveryMs : kTellActivityAfterMs);
  }
}

void MainWindow::showActivity() {
  const QString loading = m_tasks.title();
  const bool busy = !loading.isEmpty() || !m_jobTitle.isEmpty();
  m_progress->setVisible(busy);
  m_cancel->setVisible(busy);
  if (!m_tasks.busy(QStringLiteral("picture"))) m_pictureFraction = -1.0;
  const double fraction = m_pictureFraction >= 0.0 ? m_pictureFraction
                          : loading.isEmpty()      ? m_jobFraction
                                                   : m_tasks.fraction();
  m_progress->setRange(0, fraction < 0.0 ? 0 : 1000);
  if (fraction >= 0.0) m_progress->setValue(static_cast<int>(fraction * 1000.0));
  const QString title = !loading.isEmpty() ? loading : m_jobTitle;
  if (!m_clock.isValid()) m_clock.start();
  if (busy && fraction >= 0.0)
    m_timeLeft.update(title, fraction, static_cast<double>(m_clock.elapsed()) * 1e-3);
  else
    m_timeLeft.clear();
  const QString left = m_timeLeft.text();
  m_activity->setText(left.isEmpty() ? title : tr("%1 · %2").arg(title, left));
}

// --- pictures
// ---------------------------------------------------------------------------------------------------------

void MainWindow::askForPicture() { m_exports->ask(*m_viewport); }

void MainWindow::savePicture(const PictureRequest& request) { m_exports->draw(request); }

// --- closing and dropping
// ---------------------------------------------------------------------------------------------

void MainWindow::refreshLengths() {
  const LengthUnit unit = m_preferences.values().unit;
  m_tools->ruler().setUnit(unit);
  if (!m_document.isReady()) return;
  const Model& model = *m_document.model();
  const double height = static_cast<double>(model.bounds.max.y - model.bounds.min.y) *
                        static_cast<double>(m_document.millimetresPerUnit());
  m_about->setText(
      tr("%1 triangles   ·   %2 tall").arg(groupedNumber(model.indices.size() / 3)).arg(lengthText(height, unit)));
}

void MainWindow::showEvent(QShowEvent* event) {
  QMainWindow::showEvent(event);
  // What a window manager's frame adds is known a moment later; the status bar must not lie below the screen.
  constexpr int kFrameIsThereMs = 100;
  if (event->spontaneous()) return;
  auto* timer = new QTimer(this);
  timer->setSingleShot(true);
  connect(timer, &QTimer::timeout, this, [this, timer] {
    timer->deleteLater();
    keepOnScreen(*this);
  });
  timer->start(kFrameIsThereMs);
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (!m_files->mayDiscard()) {
    event->ignore();
    return;
  }
  m_exports->forgetWaiting();
  m_tasks.cancelAll();
  m_docks->save();
  m_safetyNet->autosave().discard();
  event->accept();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (!draggedPreset(event->mimeData()).isEmpty() || !draggedSlot(event->mimeData()).isEmpty())
    event->acceptProposedAction();
  if (event->mimeData()->hasUrls() && event->mimeData()->urls().first().isLocalFile()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  event->acceptProposedAction();
  // On the slot that is seen there, and on those edited with it; beside the picture, on the current ones.
  const QPointF at = m_viewport->mapFrom(this, event->position());
  const QString seen = m_viewport->rect().contains(at.toPoint()) ? m_tools->readout().slotAt(at) : QString();
  if (const QString preset = draggedPreset(event->mimeData()); !preset.isEmpty())
    m_presets->apply(preset, slotsFor(seen));
  else if (const QString slot = draggedSlot(event->mimeData()); !slot.isEmpty() && !seen.isEmpty())
    m_document.dressAs(slot, m_document.editedSlots().contains(seen) ? m_document.editedSlots() : QStringList{seen});
  else
    openDropped(localPaths(event->mimeData()), seen);
}

QStringList MainWindow::slotsFor(const QString& seen) {
  if (!seen.isEmpty() && !m_document.editedSlots().contains(seen)) m_document.setCurrentSlot(seen);
  return m_document.editedSlots();
}

void MainWindow::openDropped(const QStringList& paths, const QString& seen) {
  std::vector<std::string> all;
  for (const QString& slot : m_document.slotNames()) all.push_back(slot.toStdString());
  const DropPlan plan = planDrop(paths, (seen.isEmpty() ? m_document.currentSlot() : seen).toStdString(), all);
  for (const QString& path : plan.open) m_files->open(path);
  if (!plan.maps.empty()) m_loading.assignByName(slotsFor(seen), plan.maps);
  for (const QString& path : plan.pictures)
    m_pictures->offer(
        toPath(path), [this] { return m_files->mayDiscard(); }, [this, path] { m_files->open(path); });
  QStringList names;
  for (const QString& path : plan.leftOut) names << QFileInfo(path).fileName();
  if (!names.isEmpty())
    tell(MessageKind::Warning,
         tr("Not opened: %1. Of each kind one file is taken, and a scene brings all its own; drop the others by "
            "themselves.")
             .arg(names.join(QStringLiteral(", "))));
}

}  // namespace dermis
