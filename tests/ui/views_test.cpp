// The views of the frame and the key that is held.
#include <QAction>
#include <QLabel>
#include <QLineEdit>

#include "ui/editor_fixture.h"
#include "ui/viewport/legend.h"
#include "ui/viewport/view_modes.h"

namespace dermis {
namespace {

class Views : public PictureEditor {
 protected:
  void SetUp() override {
    PictureEditor::SetUp();
    if (HasFatalFailure()) return;
    viewport()->setAov(Aov::Beauty);
    QApplication::processEvents();
  }
  void TearDown() override {
    viewport()->setAov(Aov::Beauty);
    viewport()->setWithoutSubsurface(false);
  }
  QLabel* name() { return find<QLabel>(QStringLiteral("viewport.viewName")); }
};

TEST_F(Views, BGoesThroughAllAndShiftBBack) {
  std::vector<Aov> seen;
  for (std::size_t i = 0; i < viewModes().size(); ++i) {
    QTest::keyClick(viewport(), Qt::Key_B);
    seen.push_back(viewport()->aov());
    EXPECT_TRUE(
        find<QAction>(QStringLiteral("view.show.") + QString::fromStdString(std::string(toString(viewport()->aov()))))
            ->isChecked());
    EXPECT_EQ(name()->isHidden(), viewport()->aov() == Aov::Beauty);
    if (viewport()->aov() != Aov::Beauty) {
      EXPECT_EQ(name()->text(), viewMode(viewport()->aov()).label);
    }
  }
  EXPECT_EQ(viewport()->aov(), Aov::Beauty);
  std::sort(seen.begin(), seen.end());
  EXPECT_EQ(seen, allAovs());
  QTest::keyClick(viewport(), Qt::Key_B, Qt::ShiftModifier);
  EXPECT_EQ(viewport()->aov(), viewModes().back().aov);
  QTest::keyClick(viewport(), Qt::Key_B);
  EXPECT_EQ(viewport()->aov(), Aov::Beauty);
}

TEST_F(Views, NumbersHaveALegend) {
  auto* legend = find<Legend>(QStringLiteral("viewport.legend"));
  EXPECT_TRUE(legend->isHidden());
  viewport()->setAov(Aov::Thickness);
  EXPECT_FALSE(legend->isHidden());
  EXPECT_EQ(legend->accessibleName(), QStringLiteral("Legend: Thickness from 0 to 20 mm"));
  document().setParameter(document().currentSlot(), "transmission.thickness_max_mm", ParameterValue(8.0F),
                          newGesture());
  EXPECT_EQ(legend->accessibleName(), QStringLiteral("Legend: Thickness from 0 to 8 mm"));
  viewport()->setAov(Aov::Energy);
  EXPECT_EQ(legend->accessibleName(), QStringLiteral("Legend: Energy from 0 to 1"));
  viewport()->setAov(Aov::Specular);
  EXPECT_TRUE(legend->isHidden());
}

TEST_F(Views, NShowsThePictureWithoutSubsurfaceWhileHeld) {
  QTest::keyPress(viewport(), Qt::Key_N);
  EXPECT_TRUE(viewport()->withoutSubsurface());
  EXPECT_FALSE(name()->isHidden());
  QTest::keyRelease(viewport(), Qt::Key_N);
  EXPECT_FALSE(viewport()->withoutSubsurface());
  EXPECT_TRUE(name()->isHidden());
  QTest::keyPress(viewport(), Qt::Key_N, Qt::ControlModifier);
  EXPECT_FALSE(viewport()->withoutSubsurface());
  QTest::keyRelease(viewport(), Qt::Key_N, Qt::ControlModifier);
}

TEST_F(Views, NIsALetterInAField) {
  auto* search = find<QLineEdit>(QStringLiteral("material.search"));
  reveal(search);
  search->setFocus();
  QTest::keyPress(search, Qt::Key_N);
  EXPECT_FALSE(viewport()->withoutSubsurface());
  QTest::keyRelease(search, Qt::Key_N);
  EXPECT_EQ(search->text(), QStringLiteral("n"));
  search->clear();
}

TEST_F(Views, LosingTheFocusLetsGo) {
  QTest::keyPress(viewport(), Qt::Key_N);
  ASSERT_TRUE(viewport()->withoutSubsurface());
  QEvent away(QEvent::WindowDeactivate);
  QApplication::sendEvent(window.get(), &away);
  EXPECT_FALSE(viewport()->withoutSubsurface());
  QTest::keyRelease(viewport(), Qt::Key_N);
  EXPECT_FALSE(viewport()->withoutSubsurface());
}

TEST_F(Views, TheMenuKeepsWhatTheKeyTurnsRound) {
  auto* keep = find<QAction>(QStringLiteral("view.withoutSubsurface"));
  keep->trigger();
  EXPECT_TRUE(viewport()->withoutSubsurface());
  QTest::keyPress(viewport(), Qt::Key_N);
  EXPECT_FALSE(viewport()->withoutSubsurface());
  QTest::keyRelease(viewport(), Qt::Key_N);
  EXPECT_TRUE(viewport()->withoutSubsurface());
  keep->trigger();
  EXPECT_FALSE(viewport()->withoutSubsurface());
}

TEST(RoundSteps, AreOneTwoOrFive) {
  EXPECT_DOUBLE_EQ(roundStep(20.0, 5), 5.0);
  EXPECT_DOUBLE_EQ(roundStep(1.0, 5), 0.2);
  EXPECT_DOUBLE_EQ(roundStep(0.34, 4), 0.1);
  EXPECT_DOUBLE_EQ(roundStep(1234.0, 3), 500.0);
}

}  // namespace
}  // namespace dermis
