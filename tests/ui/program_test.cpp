// What belongs to the program: preferences, themes, shortcuts, layouts, the guide, history, recent files.
#include <QAction>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDockWidget>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QProcess>
#include <QPushButton>
#include <QRegularExpression>
#include <QSettings>
#include <QStandardPaths>
#include <QTextBlock>
#include <QTextBrowser>
#include <QTranslator>
#include <QTreeWidget>
#include <QUndoView>

#include "ui/dialogs/preferences_dialog.h"
#include "ui/dialogs/shortcuts_dialog.h"
#include "ui/docks/history_panel.h"
#include "ui/docks/material_panel.h"
#include "ui/document/document.h"
#include "ui/document/loading.h"
#include "ui/editor_fixture.h"
#include "ui/help/guide_window.h"
#include "ui/jobs/task_runner.h"
#include "ui/main_window/layouts.h"
#include "ui/main_window/program_actions.h"
#include "ui/theme/theme.h"
#include "ui/translation.h"

namespace dermis {
namespace {

class Program : public Editor {
 protected:
  void TearDown() override {
    window->preferences().set(PreferenceValues{});
    window->viewport()->setTargetSamples(1);
    shortcuts().resetAll();
  }
  static Shortcuts& shortcuts() { return window->programActions()->shortcuts(); }
  static const Shortcuts::Entry& entry(const char* label) {
    for (const Shortcuts::Entry& e : shortcuts().entries())
      if (e.label == QLatin1String(label)) return e;
    ADD_FAILURE() << "no command " << label;
    return shortcuts().entries().first();
  }
};

TEST_F(Program, LengthsAreShownInTheChosenUnit) {
  EXPECT_EQ(lengthText(254.0, LengthUnit::Automatic), QStringLiteral("254 mm"));
  EXPECT_EQ(lengthText(2540.0, LengthUnit::Automatic), QStringLiteral("2.54 m"));
  EXPECT_EQ(lengthText(254.0, LengthUnit::Centimetres), QStringLiteral("25.4 cm"));
  EXPECT_EQ(lengthText(254.0, LengthUnit::Inches), QStringLiteral("10.0 in"));
}

TEST_F(Program, TheLightThemeIsLightAndPreferencesAreKept) {
  picture();
  const auto grey = [] {
    const QImage shot = window->grab().toImage();
    return qGray(shot.pixel(shot.width() / 2, 4));  // the menu bar
  };
  const int dark = grey();
  PreferencesDialog dialog(window->preferences());
  dialog.findChild<QComboBox*>(QStringLiteral("preferences.theme"))->setCurrentIndex(1);
  dialog.findChild<QComboBox*>(QStringLiteral("preferences.scale"))->setCurrentIndex(2);
  auto* buttons = dialog.findChild<QDialogButtonBox*>();
  buttons->button(QDialogButtonBox::Ok)->click();
  EXPECT_EQ(window->preferences().values().theme, ThemeChoice::Light);
  QTest::qWait(50);
  EXPECT_GT(grey(), dark + 100);
  EXPECT_GT(QApplication::palette().color(QPalette::Window).lightness(), 200);
  EXPECT_DOUBLE_EQ(storedInterfaceScale(), 1.25);
  EXPECT_EQ(Preferences().values(), window->preferences().values());  // read anew, as at the next start
  PreferencesDialog again(window->preferences());
  EXPECT_EQ(again.values(), window->preferences().values());
  again.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::RestoreDefaults)->click();
  EXPECT_EQ(again.values(), PreferenceValues{});
  again.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok)->click();
  QTest::qWait(50);
  EXPECT_NEAR(grey(), dark, 3);
}

TEST_F(Program, EveryCommandOfTheMenusIsListedOnce) {
  EXPECT_GT(shortcuts().entries().size(), 40);
  QStringList ids;
  for (const Shortcuts::Entry& e : shortcuts().entries()) {
    ids << e.id;
    // Words change with the language; what a person's keys are kept under must not.
    EXPECT_TRUE(QRegularExpression(QStringLiteral("^[a-z]+(\\.[A-Za-z0-9_-]+)+$")).match(e.id).hasMatch())
        << e.label.toStdString() << " is kept under '" << e.id.toStdString() << "'";
  }
  EXPECT_EQ(ids.removeDuplicates(), 0) << "two commands with one id would share their keys";
}

TEST_F(Program, KeysAreChangedKeptAndRefusedWhereTheyBelongToAnother) {
  const Shortcuts::Entry& model = entry("Open model");
  ShortcutsDialog dialog(shortcuts());
  auto* tree = dialog.findChild<QTreeWidget*>(QStringLiteral("shortcuts.list"));
  auto* keys = dialog.findChild<QKeySequenceEdit*>(QStringLiteral("shortcuts.keys"));
  auto* problem = dialog.findChild<QLabel*>(QStringLiteral("shortcuts.problem"));
  tree->setCurrentItem(tree->findItems(QStringLiteral("Open model"), Qt::MatchExactly).value(0));
  EXPECT_EQ(keys->keySequence(), QKeySequence(QStringLiteral("Ctrl+M")));
  const auto type = [&](const QKeySequence& sequence) {
    keys->setKeySequence(sequence);
    Q_EMIT keys->editingFinished();
  };
  type(QKeySequence::Save);
  EXPECT_TRUE(problem->text().contains(QStringLiteral("Save scene"))) << problem->text().toStdString();
  EXPECT_EQ(model.action->shortcut(), QKeySequence(QStringLiteral("Ctrl+M")));
  type(QKeySequence(Qt::Key_N));
  EXPECT_FALSE(problem->text().isEmpty()) << "N is held to see without subsurface";
  type(QKeySequence(QStringLiteral("Ctrl+Shift+M")));
  EXPECT_TRUE(problem->text().isEmpty());
  EXPECT_EQ(model.action->shortcut(), QKeySequence(QStringLiteral("Ctrl+Shift+M")));
  EXPECT_EQ(QSettings().value(QStringLiteral("shortcuts/") + model.id).toString(), QStringLiteral("Ctrl+Shift+M"));
  // A window of its own would take the stored keys over.
  QMenuBar menus;
  QMenu* file = menus.addMenu(QStringLiteral("&File"));
  QAction* same = file->addAction(QStringLiteral("Open &model…"));
  same->setObjectName(model.action->objectName());
  Shortcuts other;
  other.collect(&menus);
  EXPECT_EQ(same->shortcut(), QKeySequence(QStringLiteral("Ctrl+Shift+M")));
  dialog.findChild<QPushButton*>(QStringLiteral("shortcuts.clear"))->click();
  EXPECT_TRUE(model.action->shortcut().isEmpty());
  dialog.findChild<QPushButton*>(QStringLiteral("shortcuts.reset"))->click();
  EXPECT_EQ(model.action->shortcut(), QKeySequence(QStringLiteral("Ctrl+M")));
  EXPECT_FALSE(QSettings().contains(QStringLiteral("shortcuts/") + model.id));
}

TEST_F(Program, LayoutsAreKeptUnderNames) {
  auto* log = find<QDockWidget>(QStringLiteral("dock.log"));
  log->hide();
  Layouts& layouts = window->programActions()->layouts();
  layouts.save(QStringLiteral("Sculpt / quiet"));
  EXPECT_EQ(Layouts::names(), QStringList{QStringLiteral("Sculpt / quiet")});
  log->show();
  layouts.use(QStringLiteral("Sculpt / quiet"));
  EXPECT_TRUE(log->isHidden());
  Layouts::remove(QStringLiteral("Sculpt / quiet"));
  EXPECT_TRUE(Layouts::names().isEmpty());
}

TEST_F(Program, TheGuideHoldsThePagesTheirPicturesAndTheKeysAsTheyAre) {
  GuideWindow* guide = window->programActions()->showGuide();
  auto* text = guide->findChild<QTextBrowser*>(QStringLiteral("guide.text"));
  EXPECT_EQ(guide->page(), QStringLiteral("user-guide.md"));
  EXPECT_FALSE(text->loadResource(QTextDocument::ImageResource, QUrl(QStringLiteral("pictures/views.jpg"))).isNull());
  // The first picture is as wide as the page, or as it is itself.
  const auto widthOfTheFirstPicture = [text] {
    for (QTextBlock block = text->document()->begin(); block.isValid(); block = block.next())
      for (auto it = block.begin(); !it.atEnd(); ++it)
        if (const QTextImageFormat format = it.fragment().charFormat().toImageFormat(); format.isValid())
          return format.width();
    return 0.0;
  };
  EXPECT_TRUE(QTest::qWaitFor([&] { return widthOfTheFirstPicture() > 0.8 * text->viewport()->width(); }, kPatienceMs))
      << widthOfTheFirstPicture() << " of " << text->viewport()->width();
  auto* contents = guide->findChild<QTreeWidget*>(QStringLiteral("guide.contents"));
  for (int i = 0; i < contents->topLevelItemCount(); ++i) {
    contents->setCurrentItem(contents->topLevelItem(i));
    EXPECT_GT(text->toPlainText().size(), 400) << guide->page().toStdString();
  }
  shortcuts().set(entry("Open model"), QKeySequence(QStringLiteral("Ctrl+Alt+M")));
  guide->open(QStringLiteral("keys"));
  EXPECT_TRUE(text->toPlainText().contains(QStringLiteral("Ctrl+Alt+M")));
  auto* search = guide->findChild<QLineEdit*>(QStringLiteral("guide.search"));
  search->setText(QStringLiteral("haemoglobin"));
  EXPECT_EQ(text->textCursor().selectedText().toLower(), QStringLiteral("haemoglobin"));
  int shown = 0;
  for (int i = 0; i < contents->topLevelItemCount(); ++i) shown += contents->topLevelItem(i)->isHidden() ? 0 : 1;
  EXPECT_GT(shown, 0);
  EXPECT_LT(shown, contents->topLevelItemCount());
  search->clear();
  guide->hide();
}

TEST_F(Program, EveryParameterSaysWhatItIs) {
  int rows = 0;
  for (const PropertyRow* row : window->findChildren<PropertyRow*>()) {
    if (findParameter(row->objectName().toStdString()) == nullptr) continue;
    ++rows;
    EXPECT_FALSE(row->editor()->whatsThis().isEmpty()) << row->objectName().toStdString();
  }
  EXPECT_GT(rows, 30);
}

TEST_F(Program, TheHistoryNamesStatesAndGoesToThem) {
  auto* list = find<QUndoView>(QStringLiteral("history.list"));
  auto* state = find<QLabel>(QStringLiteral("history.state"));
  reveal(list);
  EXPECT_EQ(state->text(), QStringLiteral("As saved"));
  const std::size_t before = document().scene().lights.size();
  document().addLight(Light{});
  document().addLight(Light{});
  EXPECT_TRUE(state->text().startsWith(QStringLiteral("2 step")));
  ASSERT_EQ(list->model()->rowCount(), 3);
  QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualRect(list->model()->index(0, 0)).center());
  EXPECT_EQ(document().scene().lights.size(), before);
  EXPECT_FALSE(document().isModified());
  find<QWidget>(QStringLiteral("dock.history"))->hide();
}

TEST_F(Program, ASelectedPictureKeepsItsColours) {
  QPixmap orange(16, 16);
  orange.fill(QColor(200, 120, 40));
  const QImage shown = QIcon(orange).pixmap(QSize(16, 16), QIcon::Selected).toImage();
  EXPECT_EQ(shown.pixelColor(8, 8), QColor(200, 120, 40));
}

TEST_F(Program, TheSystemsThemeIsFollowedWhenItChanges) {
  bool dark = true;
  setSystemDarkProbe([&dark] { return dark; });
  PreferenceValues values;
  values.theme = ThemeChoice::System;
  window->preferences().set(values);
  const auto lightness = [] { return QApplication::palette().color(QPalette::Window).lightness(); };
  EXPECT_LT(lightness(), 128);
  dark = false;
  QEvent changed(QEvent::ThemeChange);
  QApplication::sendEvent(window->windowHandle(), &changed);
  EXPECT_TRUE(QTest::qWaitFor([&] { return lightness() > 200; }, 2000));
  dark = true;
  QApplication::sendEvent(window->windowHandle(), &changed);
  EXPECT_TRUE(QTest::qWaitFor([&] { return lightness() < 128; }, 2000));
  setSystemDarkProbe({});
  window->preferences().set(PreferenceValues{});
}

TEST_F(Program, ATranslationIsFoundByTheLocale) {
  const QTemporaryDir folder;
  write(
      folder, "dermis_hr.ts",
      R"(<?xml version="1.0" encoding="utf-8"?><!DOCTYPE TS><TS version="2.1" language="hr"><context>)"
      R"(<name>dermis::FileActions</name><message><source>Scenes</source><translation>Scene!</translation></message>)"
      R"(</context><context><name>tables</name><message><source>Roughness</source><translation>Hrapavost</translation>)"
      R"(</message><message><source>Specular</source><translation>Odsjaj</translation></message></context></TS>)");
  const QString compiler =
      QStandardPaths::findExecutable(QStringLiteral("lrelease"), {QStringLiteral("/usr/lib/qt6/bin")});
  ASSERT_FALSE(compiler.isEmpty()) << "lrelease is missing: install qt6-l10n-tools";
  const QString made = folder.filePath(QStringLiteral("dermis_hr.qm"));
  ASSERT_EQ(QProcess::execute(compiler, {QStringLiteral("-silent"), folder.filePath(QStringLiteral("dermis_hr.ts")),
                                         QStringLiteral("-qm"), made}),
            0);
  EXPECT_FALSE(loadTranslation(*qApp, QLocale(QStringLiteral("fi_FI")), folder.path()));
  const auto steps = [](int count) { return HistoryPanel::tr("%n step(s) after the saved state", nullptr, count); };
  EXPECT_EQ(steps(1), QStringLiteral("1 step after the saved state"));
  EXPECT_EQ(steps(2), QStringLiteral("2 steps after the saved state"));
  EXPECT_EQ(FileActions::tr("Scenes"), QStringLiteral("Scenes"));
  ASSERT_TRUE(loadTranslation(*qApp, QLocale(QStringLiteral("hr_HR")), folder.path()));
  EXPECT_EQ(FileActions::tr("Scenes"), QStringLiteral("Scene!"));
  {
    TaskRunner tasks;
    Document empty;
    Loading loading(empty, tasks);
    const MaterialPanel panel(empty, loading);
    const auto* row = panel.findChild<PropertyRow*>(QStringLiteral("specular.perceptual_roughness"));
    ASSERT_NE(row, nullptr);
    EXPECT_EQ(row->accessibleName(), QStringLiteral("Odsjaj › Hrapavost"));
    EXPECT_EQ(row->findChild<QLabel*>()->text(), QStringLiteral("Hrapavost"));
  }
  for (QTranslator* translator : qApp->findChildren<QTranslator*>()) delete translator;
  EXPECT_EQ(FileActions::tr("Scenes"), QStringLiteral("Scenes"));
}

TEST_F(Program, FilesThatHaveVanishedAreGreyInTheListOfRecentOnes) {
  const QTemporaryDir folder;
  const QString gone = folder.filePath(QStringLiteral("gone.dermis"));
  const QString there = QString::fromStdString(write(folder, "there.hdr", flatHdr(1, 2, 3)));
  window->fileActions()->remember(gone);
  window->fileActions()->remember(there);
  QMenu menu;
  window->fileActions()->fillRecentMenu(&menu);
  QHash<QString, bool> enabled;
  for (const QAction* action : menu.actions()) enabled.insert(action->text(), action->isEnabled());
  ASSERT_TRUE(enabled.contains(QStringLiteral("gone.dermis")) && enabled.contains(QStringLiteral("there.hdr")));
  EXPECT_FALSE(enabled[QStringLiteral("gone.dermis")]);
  EXPECT_TRUE(enabled[QStringLiteral("there.hdr")]);
}

}  // namespace
}  // namespace dermis
