// The driver takes the context away: the picture is made anew in another, and somebody is told.
#include <QLabel>

#include "ui/document/document.h"
#include "ui/editor_fixture.h"

namespace dermis {
namespace {

/// A viewport whose driver can be reset.
class Losing : public Viewport {
 public:
  explicit Losing(Document& document) : Viewport(document) {}
  bool lost = false;

 protected:
  bool contextIsLost() const override { return lost || Viewport::contextIsLost(); }
};

class ContextLoss : public Editor {
 protected:
  void SetUp() override {
    Editor::SetUp();
    viewport = std::make_unique<Losing>(document());
    viewport->setTargetSamples(1);
    viewport->resize(400, 300);
    viewport->show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(viewport.get(), kPatienceMs));
  }
  void TearDown() override { viewport.reset(); }
  /// What Qt does once it knows: another context, for the widget of another window.
  void anotherContext(QWidget* home) {
    viewport->setParent(home);
    viewport->show();
    home->resize(400, 300);
    home->show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(home, kPatienceMs));
    viewport->lost = false;
  }
  std::unique_ptr<Losing> viewport;
};

TEST_F(ContextLoss, ThePictureComesBackAndSomebodyIsTold) {
  ASSERT_TRUE(QTest::qWaitFor([this] { return viewport->isSettled(); }, kPatienceMs));
  const QImage before = viewport->grabFramebuffer();
  QSignalSpy told(viewport.get(), &Viewport::message);
  viewport->lost = true;
  EXPECT_FALSE(viewport->readPixel(viewport->rect().center()).has_value());
  EXPECT_FALSE(viewport->findChild<QLabel*>(QStringLiteral("viewport.problem"))->isHidden());
  QWidget home;
  anotherContext(&home);
  ASSERT_TRUE(QTest::qWaitFor([this] { return viewport->isSettled(); }, kPatienceMs));
  EXPECT_LT(meanDifference(before, viewport->grabFramebuffer()), 0.5F);
  EXPECT_TRUE(QTest::qWaitFor(
      [this] { return viewport->findChild<QLabel*>(QStringLiteral("viewport.problem"))->isHidden(); }, 3000));
  ASSERT_EQ(told.size(), 1);
  EXPECT_TRUE(told[0][1].toString().contains(QStringLiteral("reset"))) << told[0][1].toString().toStdString();
  viewport->setParent(nullptr);
}

TEST_F(ContextLoss, WithJobsQueuedNothingIsDrawnIntoTheLostOne) {
  ASSERT_TRUE(QTest::qWaitFor([this] { return viewport->glInfo().has_value(); }, kPatienceMs));
  viewport->lost = true;
  viewport->cancelJobs();
  QTest::qWait(50);
  EXPECT_FALSE(viewport->isSettled());
  QWidget home;
  anotherContext(&home);
  EXPECT_TRUE(QTest::qWaitFor([this] { return viewport->isSettled(); }, kPatienceMs));
  viewport->setParent(nullptr);
}

}  // namespace
}  // namespace dermis
