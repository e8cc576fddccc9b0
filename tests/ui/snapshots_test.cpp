// The strip of snapshots while one of them is being compared with.
#include <QListWidget>
#include <QToolButton>

#include "ui/editor_fixture.h"
#include "ui/main_window/view_tools.h"
#include "ui/snapshots/snapshots.h"
#include "ui/snapshots/snapshots_panel.h"

namespace dermis {
namespace {

class SnapshotStrip : public Editor {
 protected:
  void SetUp() override {
    Editor::SetUp();
    picture();
    for (int i = 0; i < 3; ++i) {
      EnvironmentSource next = document().scene().environment;
      next.exposureStops = static_cast<float>(i);
      document().setEnvironmentSettings(next, QStringLiteral("Environment exposure"), newGesture());
      window->viewTools()->takeSnapshot();
    }
    strip = window->findChild<SnapshotsPanel*>();
    list = find<QListWidget>(QStringLiteral("snapshots.list"));
  }
  void TearDown() override {
    window->viewport()->compareWith(nullptr);
    while (!snapshots().all().empty()) snapshots().remove(0);
    find<QWidget>(QStringLiteral("dock.snapshots"))->hide();
  }
  Snapshots& snapshots() { return window->viewTools()->snapshots(); }
  void remove(int index) {
    list->setCurrentRow(index);
    find<QToolButton>(QStringLiteral("snapshots.remove"))->click();
  }
  SnapshotsPanel* strip = nullptr;
  QListWidget* list = nullptr;
};

TEST_F(SnapshotStrip, DeletingTheComparedOneEndsTheComparison) {
  window->viewTools()->compareWithSnapshot(1);
  ASSERT_EQ(strip->compared(), 1);
  strip->showCompared(1);
  snapshots().remove(1);
  EXPECT_EQ(window->viewport()->compared(), nullptr);
  EXPECT_EQ(strip->compared(), -1);
}

TEST_F(SnapshotStrip, DeletingAnotherKeepsTheComparedOneMarked) {
  window->viewTools()->compareWithSnapshot(2);
  const ResolvedScene* shown = window->viewport()->compared();
  snapshots().remove(0);
  EXPECT_EQ(window->viewport()->compared(), shown);
  EXPECT_EQ(strip->compared(), 1);
  EXPECT_EQ(snapshots().all()[1].scene.get(), shown);
}

TEST_F(SnapshotStrip, APictureShowsWhatWasKeptAlsoWhileTwoPresetsAreCompared) {
  document().setCurrentSlot(QStringLiteral("face"));
  EnvironmentSource bright = document().scene().environment;
  bright.exposureStops = 0.0F;
  document().setEnvironmentSettings(bright, QStringLiteral("Environment exposure"), newGesture());
  picture();
  window->viewTools()->takeSnapshot();
  const QImage expected = snapshots().all().back().thumbnail;
  ASSERT_FALSE(expected.isNull());
  window->viewTools()->compareWithPreset("builtin:jade", ViewTools::Side::Left);
  ASSERT_TRUE(waitIdle());
  window->viewTools()->compareWithPreset("builtin:marble");
  ASSERT_TRUE(waitIdle());
  ASSERT_NE(window->viewport()->comparedLeft(), nullptr);
  picture();
  const QImage left = window->viewport()->picture();
  // Two at once: each gets its own.
  window->viewTools()->takeSnapshot();
  EXPECT_TRUE(snapshots().all().back().thumbnail.isNull());
  EnvironmentSource dark = bright;
  dark.exposureStops = -4.0F;
  document().setEnvironmentSettings(dark, QStringLiteral("Environment exposure"), newGesture());
  window->viewTools()->takeSnapshot();
  ASSERT_EQ(snapshots().all().size(), 6U);
  ASSERT_TRUE(QTest::qWaitFor([this] { return snapshots().undrawn() < 0; }, 3 * kPatienceMs));
  const QImage shown = snapshots().all()[4].thumbnail;
  EXPECT_EQ(shown.size(), expected.size());
  const float off = meanDifference(shown, expected);
  EXPECT_LT(off, 4.0F);
  const QImage presets = left.scaled(expected.size(), Qt::KeepAspectRatioByExpanding, Qt::SmoothTransformation)
                             .copy(QRect(QPoint(), expected.size()));
  EXPECT_GT(meanDifference(presets, expected), 2.0F * off) << "the comparison would tell";
  EXPECT_GT(meanDifference(snapshots().all()[5].thumbnail, expected), 10.0F);
  EXPECT_FALSE(list->item(4)->icon().isNull());
}

}  // namespace
}  // namespace dermis
