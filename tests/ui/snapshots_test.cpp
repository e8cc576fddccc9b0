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

}  // namespace
}  // namespace dermis
