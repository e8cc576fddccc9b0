#include "ui/main_window/dock_layout.h"

#include <QApplication>
#include <QDockWidget>
#include <QMainWindow>
#include <QScreen>
#include <QSettings>
#include <QTimer>
#include <algorithm>
#include <utility>

namespace dermis {
namespace {
constexpr int kStateVersion = 2;
const QString kGeometryKey = QStringLiteral("window/geometry");
const QString kStateKey = QStringLiteral("window/state");
const QString kShownKey = QStringLiteral("window/shownState");
constexpr int kLeftWidth = 344;
constexpr int kRightWidth = 392;
constexpr QSize kRoomy(kLeftWidth + kRightWidth + 480, 720);  // where docks on both sides leave room for a picture
}  // namespace

DockLayout::DockLayout(QMainWindow& window) : QObject(&window), m_window(window) {
  window.setDockOptions(QMainWindow::AnimatedDocks | QMainWindow::AllowNestedDocks | QMainWindow::AllowTabbedDocks |
                        QMainWindow::GroupedDragging);
  window.setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
  window.setCorner(Qt::TopLeftCorner, Qt::LeftDockWidgetArea);
  window.setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
  window.setCorner(Qt::TopRightCorner, Qt::RightDockWidgetArea);
  window.setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
  connect(qApp, &QApplication::focusChanged, this, [this](QWidget*, QWidget* now) {
    for (QWidget* w = now; w != nullptr; w = w->parentWidget())
      if (auto* dock = qobject_cast<QDockWidget*>(w); m_docks.contains(dock)) m_used = dock;
  });
}

QDockWidget* DockLayout::add(const QString& title, const QString& name) {
  auto* dock = new QDockWidget(title, &m_window);
  dock->setObjectName(QStringLiteral("dock.") + name);
  dock->setAccessibleName(title);
  m_docks << dock;
  m_window.addDockWidget(Qt::RightDockWidgetArea, dock);
  // Whether a dock shares its place is only known once the layout has settled.
  const auto later = [this] { QTimer::singleShot(0, this, &DockLayout::refreshTitleBars); };
  connect(dock, &QDockWidget::topLevelChanged, this, later);
  connect(dock, &QDockWidget::dockLocationChanged, this, later);
  connect(dock, &QDockWidget::visibilityChanged, this, later);
  return dock;
}

QDockWidget* DockLayout::dock(const char* name) const {
  for (QDockWidget* dock : m_docks)
    if (dock->objectName() == QStringLiteral("dock.") + QLatin1String(name)) return dock;
  return nullptr;
}

void DockLayout::arrange() {
  for (QDockWidget* dock : m_docks) {
    dock->setFloating(false);
    m_window.removeDockWidget(dock);
  }
  const QSize screen = m_window.screen()->availableSize();
  if (screen.width() >= kRoomy.width() && screen.height() >= kRoomy.height())
    arrangeBothSides();
  else
    arrangeOneSide();
  for (const char* name : {"log", "history", "snapshots", "reference"}) {
    m_window.addDockWidget(Qt::BottomDockWidgetArea, dock(name));
    dock(name)->hide();
  }
  for (const char* name : {"history", "snapshots", "reference"}) m_window.tabifyDockWidget(dock("log"), dock(name));
  dock("material")->raise();
  refreshTitleBars();
}

void DockLayout::arrangeOneSide() {
  // On a small screen the picture has one side and all of the height.
  for (const char* name : {"material", "textures", "presets", "environment", "lights", "camera", "diffusion"}) {
    m_window.addDockWidget(Qt::RightDockWidgetArea, dock(name));
    dock(name)->show();
    if (dock(name) != dock("material")) m_window.tabifyDockWidget(dock("material"), dock(name));
  }
  m_window.resizeDocks({dock("material")}, {kRightWidth}, Qt::Horizontal);
}

void DockLayout::arrangeBothSides() {
  const auto put = [this](Qt::DockWidgetArea area, const char* name) {
    m_window.addDockWidget(area, dock(name));
    dock(name)->show();
  };
  put(Qt::LeftDockWidgetArea, "presets");
  put(Qt::LeftDockWidgetArea, "environment");
  m_window.splitDockWidget(dock("presets"), dock("environment"), Qt::Vertical);
  for (const char* name : {"lights", "camera"}) {
    put(Qt::LeftDockWidgetArea, name);
    m_window.tabifyDockWidget(dock("environment"), dock(name));
  }
  // The curves stand where they are seen while the material's sliders move.
  put(Qt::LeftDockWidgetArea, "diffusion");
  m_window.tabifyDockWidget(dock("presets"), dock("diffusion"));
  dock("presets")->raise();
  put(Qt::RightDockWidgetArea, "material");
  put(Qt::RightDockWidgetArea, "textures");
  m_window.tabifyDockWidget(dock("material"), dock("textures"));
  dock("environment")->raise();
  m_window.resizeDocks({dock("presets"), dock("material")}, {kLeftWidth, kRightWidth}, Qt::Horizontal);
  m_window.resizeDocks({dock("presets"), dock("environment")}, {480, 420}, Qt::Vertical);
}

void DockLayout::restore() {
  arrange();
  const QSettings settings;
  m_window.restoreGeometry(settings.value(kGeometryKey).toByteArray());
  m_window.restoreState(settings.value(kStateKey).toByteArray(), kStateVersion);
  m_shown = settings.value(kShownKey).toByteArray();
  // What stood well on another screen may not fit this one.
  const QSize least = m_window.minimumSizeHint();
  const QSize screen = m_window.screen()->availableSize();
  if (least.width() > screen.width() || least.height() > screen.height()) arrange();
  refreshTitleBars();
}

void DockLayout::save() const {
  QSettings settings;
  settings.setValue(kGeometryKey, m_window.saveGeometry());
  settings.setValue(kStateKey, state());
  settings.setValue(kShownKey, m_shown);
}

void DockLayout::reset() {
  m_shown.clear();
  arrange();
}

QByteArray DockLayout::state() const { return m_window.saveState(kStateVersion); }

void DockLayout::setState(const QByteArray& state) {
  m_window.restoreState(state, kStateVersion);
  refreshTitleBars();
}

void DockLayout::toggleAll() {
  const bool any = std::ranges::any_of(m_docks, [](const QDockWidget* dock) { return !dock->isHidden(); });
  if (any) {
    m_shown = state();
    for (QDockWidget* dock : m_docks) dock->hide();
  } else if (m_shown.isEmpty()) {
    arrange();  // each was closed by hand
  } else {
    setState(std::exchange(m_shown, {}));
  }
}

void DockLayout::toggleFloating() {
  if (!m_used || m_used->isHidden()) return;
  QDockWidget* dock = m_used;
  QWidget* focus = dock->focusWidget();
  dock->setFloating(!dock->isFloating());
  dock->raise();
  dock->activateWindow();
  if (focus != nullptr) focus->setFocus();
  m_used = dock;  // on its way the focus may have been elsewhere
}

void DockLayout::refreshTitleBars() {
  // A dock among tabs is named by its tab; a title bar would say it twice.
  for (QDockWidget* dock : m_docks) {
    const bool tabbed = !dock->isFloating() && !m_window.tabifiedDockWidgets(dock).isEmpty();
    const bool bare = dock->titleBarWidget() != nullptr;
    if (tabbed && !bare) dock->setTitleBarWidget(new QWidget(dock));
    if (!tabbed && bare) {
      QWidget* empty = dock->titleBarWidget();
      dock->setTitleBarWidget(nullptr);
      empty->deleteLater();
    }
  }
}

}  // namespace dermis
