// Keys that are in no menu are changed like the others: those that are held, those that fly, those of lists.
#include <QDockWidget>
#include <QLineEdit>
#include <QListWidget>

#include "ui/editor_fixture.h"
#include "ui/main_window/program_actions.h"
#include "ui/main_window/view_tools.h"
#include "ui/snapshots/snapshots.h"
#include "ui/viewport/measure_tool.h"

namespace dermis {
namespace {

class OwnKeys : public PictureEditor {
 protected:
  void TearDown() override { shortcuts().resetAll(); }
  static Shortcuts& shortcuts() { return window->programActions()->shortcuts(); }
  static const Shortcuts::Entry& entry(const char* id) {
    static const Shortcuts::Entry kNone;
    for (const Shortcuts::Entry& each : shortcuts().entries())
      if (each.id == QLatin1String(id)) return each;
    ADD_FAILURE() << id << " is not listed";
    return kNone;
  }
};

TEST_F(OwnKeys, NoTwoCommandsHaveTheSameKeys) {
  for (const Shortcuts::Entry& a : shortcuts().entries())
    for (const Shortcuts::Entry& b : shortcuts().entries()) {
      if (&a == &b || a.whileFlying != b.whileFlying) continue;
      for (const QKeySequence& keys : a.action->shortcuts())
        EXPECT_FALSE(b.action->shortcuts().contains(keys))
            << a.id.toStdString() << " and " << b.id.toStdString() << ": " << keys.toString().toStdString();
    }
}

TEST_F(OwnKeys, AKeyThatIsHeldCanBeAnother) {
  EXPECT_EQ(shortcuts().set(entry("view.seeWithoutSubsurface"), QKeySequence(Qt::Key_K)), QString());
  QTest::keyPress(viewport(), Qt::Key_N);
  EXPECT_FALSE(viewport()->withoutSubsurface());
  QTest::keyRelease(viewport(), Qt::Key_N);
  QTest::keyPress(viewport(), Qt::Key_K);
  EXPECT_TRUE(viewport()->withoutSubsurface());
  QTest::keyRelease(viewport(), Qt::Key_K);
  EXPECT_FALSE(viewport()->withoutSubsurface());
  EXPECT_TRUE(find<QAction>(QStringLiteral("view.withoutSubsurface"))->text().endsWith(QLatin1Char('K')));
  // And what is held belongs to nobody else.
  EXPECT_FALSE(shortcuts().set(entry("file.openModel"), QKeySequence(Qt::Key_K)).isEmpty());
}

TEST_F(OwnKeys, FlyingHasKeysOfItsOwn) {
  // I is a command's outside of flying: that does no harm.
  EXPECT_EQ(shortcuts().set(entry("fly.forward"), QKeySequence(Qt::Key_I)), QString());
  EXPECT_FALSE(shortcuts().set(entry("fly.back"), QKeySequence(Qt::Key_D)).isEmpty()) << "D flies to the right";
  const Camera start = document().camera();
  press(viewport()->rect().center(), {}, Qt::RightButton);
  QTest::keyPress(viewport(), Qt::Key_W);
  QTest::qWait(60);
  QTest::keyRelease(viewport(), Qt::Key_W);
  EXPECT_EQ(document().camera(), start);
  QTest::keyPress(viewport(), Qt::Key_I);
  EXPECT_TRUE(QTest::qWaitFor([&] { return document().camera().position != start.position; }, kPatienceMs));
  QTest::keyRelease(viewport(), Qt::Key_I);
  letGo(viewport()->rect().center(), Qt::RightButton);
}

TEST_F(OwnKeys, ListsShareTheirs) {
  window->viewTools()->takeSnapshot();
  auto* list = find<QListWidget>(QStringLiteral("snapshots.list"));
  reveal(list);
  list->setFocus();
  list->setCurrentRow(0);
  EXPECT_EQ(shortcuts().set(entry("list.rename"), QKeySequence(Qt::Key_F4)), QString());
  QTest::keyClick(list, Qt::Key_F2);
  EXPECT_EQ(list->viewport()->findChild<QLineEdit*>(), nullptr);
  QTest::keyClick(list, Qt::Key_F4);
  auto* editor = list->viewport()->findChild<QLineEdit*>();
  ASSERT_NE(editor, nullptr);
  QTest::keyClick(editor, Qt::Key_Escape);
  list->setFocus();
  QTest::keyClick(list, Qt::Key_Delete);
  EXPECT_TRUE(window->viewTools()->snapshots().all().empty());
  find<QWidget>(QStringLiteral("dock.snapshots"))->hide();
}

// --- without a mouse

TEST_F(OwnKeys, TheSplitMovesByKeys) {
  picture();
  window->viewTools()->takeSnapshot();
  window->viewTools()->compareWithSnapshot(0);
  viewport()->setSplit(0.5);
  viewport()->setFocus();
  QTest::keyClick(viewport(), Qt::Key_Left, Qt::ControlModifier);
  EXPECT_NEAR(viewport()->split(), 0.48, 1e-9);
  QTest::keyClick(viewport(), Qt::Key_Right, Qt::ControlModifier);
  QTest::keyClick(viewport(), Qt::Key_Right, Qt::ControlModifier);
  EXPECT_NEAR(viewport()->split(), 0.52, 1e-9);
  viewport()->setSplit(0.5);
  viewport()->compareWith(nullptr);
  window->viewTools()->snapshots().remove(0);
  find<QWidget>(QStringLiteral("dock.snapshots"))->hide();
}

TEST_F(OwnKeys, TheRulerMeasuresFromMiddleToMiddle) {
  picture();
  QTest::keyClick(viewport(), Qt::Key_M, Qt::ShiftModifier);
  EXPECT_FALSE(window->viewTools()->ruler().millimetres().has_value());
  EXPECT_TRUE(find<QAction>(QStringLiteral("view.ruler"))->isChecked());
  QTest::keyClick(viewport(), Qt::Key_Up, Qt::ShiftModifier);
  QTest::keyClick(viewport(), Qt::Key_M, Qt::ShiftModifier);
  const auto length = window->viewTools()->ruler().millimetres();
  ASSERT_TRUE(length.has_value());
  EXPECT_GT(*length, 1.0);
  find<QAction>(QStringLiteral("view.ruler"))->trigger();
}

TEST_F(OwnKeys, ADockFloatsByAKeyAndComesBack) {
  auto* field = find<NumberField>(QStringLiteral("subsurface.scale.number"));
  reveal(field);
  field->setFocus();
  ASSERT_TRUE(field->hasFocus());
  auto* dock = find<QDockWidget>(QStringLiteral("dock.material"));
  QTest::keyClick(field, Qt::Key_D, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_TRUE(dock->isFloating());
  find<QAction>(QStringLiteral("window.float"))->trigger();
  EXPECT_FALSE(dock->isFloating());
}

}  // namespace
}  // namespace dermis
