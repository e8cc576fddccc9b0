#include "ui/main_window/program_actions.h"

#include <QAction>
#include <QApplication>
#include <QMainWindow>
#include <QMenu>
#include <QThreadPool>
#include <QWhatsThis>

#include "core/io/disk_cache.h"
#include "ui/dialogs/open_dialog.h"
#include "ui/dialogs/preferences_dialog.h"
#include "ui/dialogs/shortcuts_dialog.h"
#include "ui/document/autosave.h"
#include "ui/help/guide_window.h"
#include "ui/main_window/layouts.h"
#include "ui/preferences/preferences.h"
#include "ui/text.h"
#include "ui/theme/icons.h"
#include "ui/viewport/viewport.h"

namespace dermis {

ProgramActions::ProgramActions(const Parts& parts) : QObject(&parts.window), m_parts(parts) {
  m_layouts = new Layouts(parts.docks, &parts.window);
  connect(&m_parts.preferences, &Preferences::changed, this, &ProgramActions::apply);
}

ProgramActions::~ProgramActions() = default;

void ProgramActions::fillEditMenu(QMenu* menu) {
  menu->addSeparator();
  QAction* preferences = menu->addAction(tr("&Preferences…"));
  preferences->setObjectName(QStringLiteral("edit.preferences"));
  preferences->setShortcut(QKeySequence(QStringLiteral("Ctrl+,")));
  connect(preferences, &QAction::triggered, this,
          [this] { openDialog(new PreferencesDialog(m_parts.preferences, &m_parts.window)); });
  QAction* shortcuts = menu->addAction(tr("&Keyboard shortcuts…"));
  shortcuts->setObjectName(QStringLiteral("edit.shortcuts"));
  connect(shortcuts, &QAction::triggered, this,
          [this] { openDialog(new ShortcutsDialog(m_shortcuts, &m_parts.window)); });
}

void ProgramActions::fillWindowMenu(QMenu* menu) { m_layouts->fillMenu(menu); }

void ProgramActions::fillHelpMenu(QMenu* menu) {
  QAction* guide = menu->addAction(themeIcon("info"), tr("&Guide"));
  guide->setObjectName(QStringLiteral("help.guide"));
  guide->setShortcut(QKeySequence(Qt::Key_F1));
  connect(guide, &QAction::triggered, this, [this] { showGuide(); });
  QAction* keys = menu->addAction(tr("&Keyboard shortcuts"));
  keys->setObjectName(QStringLiteral("help.keys"));
  connect(keys, &QAction::triggered, this, [this] { showGuide(QStringLiteral("keys")); });
  QAction* what = QWhatsThis::createAction(this);
  what->setObjectName(QStringLiteral("help.whatsThis"));
  what->setText(tr("&What is this?"));
  menu->addAction(what);
  menu->addSeparator();
}

void ProgramActions::finish() {
  m_shortcuts.collect(m_parts.window.menuBar());
  m_shortcuts.collectLoose(m_parts.window);
  apply();
}

GuideWindow* ProgramActions::showGuide(const QString& page) {
  if (m_guide == nullptr) m_guide = new GuideWindow(m_shortcuts, &m_parts.window);
  if (!page.isEmpty()) m_guide->open(page);
  m_guide->show();
  m_guide->raise();
  m_guide->activateWindow();
  return m_guide;
}

void ProgramActions::apply() {
  const PreferenceValues& values = m_parts.preferences.values();
  if (auto* application = qobject_cast<QApplication*>(QCoreApplication::instance()))
    applyTheme(*application, values.theme);
  m_parts.autosave.setIntervalMs(values.autosaveSeconds * 1000);
  m_parts.viewport.setTargetSamples(values.stillSamples);
  m_parts.viewport.setStatisticsVisible(values.statistics);
  const std::filesystem::path folder = userCacheFolder();
  if (folder.empty()) return;
  const auto most = static_cast<std::uintmax_t>(values.cacheMegabytes) << 20U;
  // The renderer keeps to limits of its own while it runs; what a person allows is looked after beside it.
  QThreadPool::globalInstance()->start([folder, most] {
    std::error_code ignored;
    trimDiskCache(folder / "bakes", "", most * 3 / 4);
    trimDiskCache(folder / "thumbnails", "", most / 4);
  });
}

}  // namespace dermis
