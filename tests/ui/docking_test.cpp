// Docks: hidden and brought back together, put back, remembered over a restart, torn off while somebody edits in them.
#include <QDockWidget>
#include <QMenu>

#include "ui/editor_fixture.h"
#include "ui/main_window/dock_layout.h"

namespace dermis {
namespace {

class Docking : public Editor {
 protected:
  void SetUp() override {
    Editor::SetUp();
    docks().reset();
    QApplication::processEvents();
  }
  void TearDown() override {
    docks().reset();
    QApplication::processEvents();
  }
  DockLayout& docks() { return *window->findChild<DockLayout*>(); }
  QDockWidget* dock(const char* name) { return find<QDockWidget>(QStringLiteral("dock.") + QLatin1String(name)); }
  QStringList shown() const {
    QStringList names;
    for (const QDockWidget* each : window->findChildren<QDockWidget*>())
      if (!each->isHidden()) names << each->objectName();
    names.sort();
    return names;
  }
  static void press(const char* action) {
    auto* found = window->findChild<QAction*>(QLatin1String(action));
    ASSERT_NE(found, nullptr) << action;
    found->trigger();
    QApplication::processEvents();
  }
};

TEST_F(Docking, CtrlTabHidesAllAndBringsTheSameBack) {
  dock("textures")->raise();
  dock("diffusion")->hide();
  QApplication::processEvents();
  const QStringList before = shown();
  const QSize picture = window->viewport()->size();
  press("window.toggleAll");
  EXPECT_TRUE(shown().isEmpty());
  EXPECT_GT(window->viewport()->width(), picture.width());
  press("window.toggleAll");
  EXPECT_EQ(shown(), before);
  // The tab that was in front is again.
  EXPECT_TRUE(QTest::qWaitFor([this] { return !dock("textures")->visibleRegion().isEmpty(); }, 3000));
  EXPECT_TRUE(dock("material")->visibleRegion().isEmpty());
}

TEST_F(Docking, CtrlTabBringsDocksBackThatWereClosedByHand) {
  for (QDockWidget* each : window->findChildren<QDockWidget*>()) each->close();
  ASSERT_TRUE(shown().isEmpty());
  press("window.toggleAll");
  EXPECT_FALSE(dock("material")->isHidden());
  EXPECT_FALSE(dock("presets")->isHidden());
}

TEST_F(Docking, HiddenDocksComeBackAfterARestart) {
  const QStringList before = shown();
  press("window.toggleAll");
  docks().save();
  {
    MainWindow again;
    for (const QDockWidget* each : again.findChildren<QDockWidget*>()) EXPECT_TRUE(each->isHidden());
    again.findChild<DockLayout*>()->toggleAll();
    QStringList names;
    for (const QDockWidget* each : again.findChildren<QDockWidget*>())
      if (!each->isHidden()) names << each->objectName();
    names.sort();
    EXPECT_EQ(names, before);
  }
  docks().reset();
  docks().save();
}

TEST_F(Docking, AnArrangementIsRememberedOverARestart) {
  window->addDockWidget(Qt::LeftDockWidgetArea, dock("material"));
  dock("log")->show();
  dock("camera")->hide();
  docks().save();
  {
    const MainWindow again;
    const auto* material = again.findChild<QDockWidget*>(QStringLiteral("dock.material"));
    EXPECT_EQ(again.dockWidgetArea(const_cast<QDockWidget*>(material)), Qt::LeftDockWidgetArea);
    EXPECT_FALSE(again.findChild<QDockWidget*>(QStringLiteral("dock.log"))->isHidden());
    EXPECT_TRUE(again.findChild<QDockWidget*>(QStringLiteral("dock.camera"))->isHidden());
  }
  docks().reset();
  docks().save();
}

TEST_F(Docking, ResetPutsEachWhereItWasAtFirst) {
  const QStringList before = shown();
  dock("material")->setFloating(true);
  dock("presets")->close();
  window->addDockWidget(Qt::RightDockWidgetArea, dock("lights"));
  press("window.reset");
  EXPECT_EQ(shown(), before);
  EXPECT_FALSE(dock("material")->isFloating());
  EXPECT_EQ(window->dockWidgetArea(dock("lights")), Qt::LeftDockWidgetArea);
}

TEST_F(Docking, AnEditInADockThatFloatsIsSeenAndUndone) {
  dock("material")->setFloating(true);
  dock("material")->show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(dock("material"), kPatienceMs));
  const QImage before = picture();
  const Scene start = document().scene();
  auto* slider = find<ValueSlider>(QStringLiteral("specular.perceptual_roughness.slider"));
  reveal(slider);
  drag(slider, slider->handleCentre(), -60);
  EXPECT_EQ(undo().count(), 1);
  EXPECT_NE(document().scene(), start);
  EXPECT_GT(meanDifference(before, picture()), 0.05F);
  // The keys of the window work in a dock of its own.
  dock("material")->activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(dock("material"), kPatienceMs));
  slider->setFocus();
  QTest::keyClick(slider, Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(document().scene(), start);
  EXPECT_LT(meanDifference(before, picture()), 0.05F);
  dock("material")->setFloating(false);
}

}  // namespace
}  // namespace dermis
