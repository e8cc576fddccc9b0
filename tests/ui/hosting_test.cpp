// How the picture gets into the window: composed by OpenGL, or copied where OpenGL is software.
#include <QLabel>
#include <QScreen>

#include "ui/editor_fixture.h"
#include "ui/own_process.h"

namespace dermis {
namespace {

class HostedPicture : public Editor {
 protected:
  static Viewport* viewport() { return window->viewport(); }
  /// At rest, and nothing is drawn for the sake of what was before.
  bool quiet() {
    picture();
    return QTest::qWaitFor(
        [] {
          QSignalSpy shown(viewport(), &GlWidget::frameShown);
          QTest::qWait(300);
          return shown.isEmpty();
        },
        kPatienceMs);
  }
  /// The middle of the picture, where nothing lies over it, as 8-bit RGB.
  static QImage middleOf(const QImage& whole) {
    QImage image = whole.copy(whole.width() / 4, whole.height() / 4, whole.width() / 2, whole.height() / 2);
    image.setDevicePixelRatio(1.0);
    return image.convertToFormat(QImage::Format_RGB32);
  }
  /// The same off the screen.
  static QImage seen() {
    const QPoint corner = viewport()->mapToGlobal(QPoint());
    return middleOf(viewport()
                        ->screen()
                        ->grabWindow(0, corner.x(), corner.y(), viewport()->width(), viewport()->height())
                        .toImage());
  }
};

TEST_F(HostedPicture, TheWindowShowsThePicture) {
  const QImage shown = middleOf(picture());
  ASSERT_GT(meanDifference(shown, shown.mirrored()), 2.0F) << "upside down it would be seen";
  EXPECT_TRUE(QTest::qWaitFor([&] { return meanDifference(shown, seen()) < 0.1F; }, kPatienceMs));
  ViewSettings view = document().scene().view;
  view.exposureStops = -2.0F;
  document().setView(view, newGesture());
  const QImage darker = middleOf(picture());
  ASSERT_GT(meanDifference(shown, darker), 2.0F);
  EXPECT_TRUE(QTest::qWaitFor([&] { return meanDifference(darker, seen()) < 0.1F; }, kPatienceMs));
}

TEST_F(HostedPicture, ManyRequestsAreOneFrame) {
  if (viewport()->hosting() == Hosting::Composed) GTEST_SKIP() << "there Qt decides";
  ASSERT_TRUE(quiet());
  QSignalSpy shown(viewport(), &GlWidget::frameShown);
  for (int i = 0; i < 5; ++i) viewport()->requestFrame();
  ASSERT_TRUE(shown.wait(kPatienceMs));
  QTest::qWait(100);
  EXPECT_EQ(shown.count(), 1);
}

TEST_F(HostedPicture, AFrameThatIsGrabbedBeforeItIsPaintedIsShownToo) {
  ASSERT_TRUE(quiet());
  QSignalSpy shown(viewport(), &GlWidget::frameShown);
  viewport()->requestFrame();
  ASSERT_FALSE(viewport()->grabFrame().isNull());
  EXPECT_TRUE(shown.wait(kPatienceMs));
}

TEST_F(HostedPicture, WhatLiesOverItNeedsNoFrame) {
  if (viewport()->hosting() == Hosting::Composed) GTEST_SKIP() << "there Qt decides";
  ASSERT_TRUE(quiet());
  QSignalSpy shown(viewport(), &GlWidget::frameShown);
  viewport()->updateOverlay();
  find<QLabel>(QStringLiteral("viewport.statistics"))->setText(QStringLiteral("something else"));
  QTest::qWait(200);
  EXPECT_EQ(shown.count(), 0);
}

/// Software OpenGL draws these tests, so that a graphics card's way is asked for.
TEST(Hosting, ComposedByOpenGlAllIsTheSame) {
  const QString filter = QStringLiteral(
      "HostedPicture.*:LostContext.*:Robust.*:ViewportGestures.*:ViewToolsTest.Dragging*:ViewToolsTest.ACoarse*");
  EXPECT_TRUE(test::passesWith({{"DERMIS_HOSTING", QStringLiteral("composed")}}, filter, 21, 4 * kPatienceMs));
}

TEST(Hosting, TheWindowShowsThePictureAtAScaleThatIsNoWholeNumber) {
  EXPECT_TRUE(
      test::passesAtScale("1.25", QStringLiteral("HostedPicture.TheWindowShowsThePicture"), 1, 2 * kPatienceMs));
}

}  // namespace
}  // namespace dermis
