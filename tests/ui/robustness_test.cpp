// The picture survives what a window goes through: resizing, docks torn off, other scale factors, a lost context.
#include <QDockWidget>
#include <QLayout>
#include <QOpenGLContext>
#include <cmath>
#include <cstdlib>

#include "ui/editor_fixture.h"
#include "ui/main_window/view_tools.h"
#include "ui/own_process.h"
#include "ui/snapshots/snapshots.h"
#include "ui/viewport/light_gizmos.h"

namespace dermis {
namespace {

class Robust : public Editor {
 protected:
  Viewport* viewport() { return window->viewport(); }
  [[nodiscard]] glm::ivec2 expectedPixels() {
    const double ratio = viewport()->devicePixelRatioF();
    return {static_cast<int>(std::lround(viewport()->width() * ratio)),
            static_cast<int>(std::lround(viewport()->height() * ratio))};
  }
  void expectAPicture() {
    const QImage shown = picture();
    EXPECT_EQ(glm::ivec2(shown.width(), shown.height()), expectedPixels());
    EXPECT_EQ(viewport()->statistics().pictureSize, expectedPixels());
    EXPECT_GT(contrast(shown), 5.0F);
  }
};

TEST_F(Robust, AResizedWindowIsFilled) {
  const QSize before = window->size();
  expectAPicture();
  window->resize(before + QSize(-180, -90));
  ASSERT_TRUE(QTest::qWaitFor([&] { return window->size() != before; }, kPatienceMs));
  expectAPicture();
  window->resize(before);
  expectAPicture();
}

TEST_F(Robust, ADockTornOffAndPutBackLeavesThePictureWhole) {
  auto* dock = find<QDockWidget>(QStringLiteral("dock.material"));
  const QOpenGLContext* context = viewport()->context();
  dock->setFloating(true);
  dock->show();
  expectAPicture();
  dock->setFloating(false);
  expectAPicture();
  // The viewport stays where it is, and so does its context.
  EXPECT_EQ(viewport()->context(), context);
}

TEST_F(Robust, AComparisonSurvivesALostContext) {
  window->viewTools()->takeSnapshot();
  EnvironmentSource next = document().scene().environment;
  next.exposureStops = -3.0F;
  document().setEnvironmentSettings(next, QStringLiteral("Environment exposure"), newGesture());
  window->viewTools()->compareWithSnapshot(0);
  viewport()->setSplit(0.5);
  const QImage before = picture();
  QWidget* home = viewport()->parentWidget();
  // The window system gives the widget another context: all there was on the GPU is gone.
  const QOpenGLContext* context = viewport()->context();
  viewport()->setParent(nullptr);
  viewport()->resize(before.size() / viewport()->devicePixelRatioF());
  viewport()->show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(viewport(), kPatienceMs));
  const QImage after = picture();
  EXPECT_EQ(viewport()->context() != context, viewport()->hosting() == Hosting::Composed);
  EXPECT_LT(meanDifference(before, after), 1.0F);
  viewport()->compareWith(nullptr);
  window->viewTools()->snapshots().remove(0);
  home->layout()->addWidget(viewport());
  ASSERT_TRUE(QTest::qWaitForWindowExposed(window.get(), kPatienceMs));
}

/// Run by itself in a process of its own for each scale factor, see below.
TEST_F(Robust, AtThisScaleFactor) {
  const char* expected = std::getenv("QT_SCALE_FACTOR");
  if (expected != nullptr) {
    EXPECT_NEAR(viewport()->devicePixelRatioF(), std::atof(expected), 1e-6);
  }
  expectAPicture();
  // What is under the pointer is what the picture shows there.
  const QImage shown = picture();
  const QPointF at(viewport()->rect().center());
  const auto pixel = viewport()->readPixel(at);
  ASSERT_TRUE(pixel.has_value());
  const double ratio = viewport()->devicePixelRatioF();
  const QColor code = shown.pixelColor(static_cast<int>(at.x() * ratio), static_cast<int>(at.y() * ratio));
  EXPECT_NEAR(pixel->display.g * 255.0F, static_cast<float>(code.green()), 6.0F);
}

TEST(ScaleFactors, TheViewportHasAllThePixelsOfTheScreen) {
  for (const char* factor : {"1.25", "2"})
    EXPECT_TRUE(test::passesAtScale(factor, QStringLiteral("Robust.AtThisScaleFactor"), 1, 2 * kPatienceMs));
}

}  // namespace
}  // namespace dermis
