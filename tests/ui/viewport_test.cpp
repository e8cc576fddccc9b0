// Hands on the picture.
#include <QLabel>
#include <QLayout>
#include <QOpenGLContext>

#include "core/scene/cameras.h"
#include "ui/editor_fixture.h"
#include "ui/viewport/navigation.h"
#include "ui/viewport/pace.h"

namespace dermis {
namespace {

using ViewportGestures = Editor;

TEST_F(ViewportGestures, DraggingOrbitsAndIsNoUndoEntry) {
  const QImage before = picture();
  const Camera start = document().camera();
  Viewport* viewport = window->viewport();
  drag(viewport, viewport->rect().center(), 120);
  EXPECT_NE(document().camera().position, start.position);
  EXPECT_NEAR(glm::length(document().camera().position - document().camera().target),
              glm::length(start.position - start.target), 1e-3F);
  EXPECT_EQ(undo().count(), 0);
  EXPECT_FALSE(document().isModified());
  EXPECT_GT(meanDifference(before, picture()), 0.2F);
}

TEST_F(ViewportGestures, ShiftAndRightDragTurnsTheEnvironmentAsOneEntry) {
  Viewport* viewport = window->viewport();
  drag(viewport, viewport->rect().center(), 100, Qt::ShiftModifier, Qt::RightButton);
  EXPECT_NE(document().scene().environment.rotationDegrees, 0.0F);
  EXPECT_EQ(undo().count(), 1);
  undo().undo();
  EXPECT_EQ(document().scene().environment.rotationDegrees, 0.0F);
}

TEST_F(ViewportGestures, TheNumberKeysShowThePublishedViews) {
  Viewport* viewport = window->viewport();
  window->activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(window.get(), kPatienceMs));
  viewport->setFocus();
  const char* names[] = {"top-right", "top-left", "bottom-right", "bottom-left"};
  for (int i = 0; i < 4; ++i) {
    QTest::keyClick(viewport, static_cast<Qt::Key>(Qt::Key_1 + i));
    EXPECT_EQ(document().camera().position, namedCamera(names[i], document().model()->bounds)->position) << names[i];
  }
}

TEST_F(ViewportGestures, LightsAndViewAreUndoneToTheStart) {
  const Scene start = document().scene();
  document().addLight(Light{});
  Light light = document().scene().lights.front();
  light.intensity = 7.0F;
  document().setLight(0, light, QStringLiteral("Intensity"), newGesture());
  ViewSettings view = document().scene().view;
  view.exposureStops = 1.0F;
  document().setView(view, newGesture());
  view.transform = "Raw";
  document().setView(view, newGesture());
  EXPECT_EQ(undo().count(), 4);
  while (undo().canUndo()) undo().undo();
  EXPECT_EQ(document().scene(), start);
}

TEST_F(ViewportGestures, ThePictureHasVarianceAndTheStatisticsSpeak) {
  const QImage shown = picture();
  EXPECT_GT(contrast(shown), 5.0F);
  EXPECT_TRUE(find<QLabel>(QStringLiteral("viewport.statistics"))->text().contains(QStringLiteral("fps")));
  EXPECT_TRUE(find<QLabel>(QStringLiteral("viewport.problem"))->isHidden());
}

TEST_F(ViewportGestures, ANewContextShowsTheSamePicture) {
  // Where OpenGL composes windows, one that is torn off gives the widget another context: everything on the GPU is
  // made again.
  Viewport* viewport = window->viewport();
  const QImage before = picture();
  const QOpenGLContext* context = viewport->context();
  QWidget* home = viewport->parentWidget();
  viewport->setParent(nullptr);
  viewport->resize(before.size() / viewport->devicePixelRatioF());
  viewport->show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(viewport, kPatienceMs));
  const QImage alone = picture();
  EXPECT_EQ(viewport->context() != context, viewport->hosting() == Hosting::Composed);
  EXPECT_GT(contrast(alone), 5.0F);
  home->layout()->addWidget(viewport);
  ASSERT_TRUE(QTest::qWaitForWindowExposed(window.get(), kPatienceMs));
  const QImage after = picture();
  ASSERT_EQ(after.size(), before.size());
  EXPECT_LT(meanDifference(before, after), 0.5F);
}

TEST_F(ViewportGestures, TheLastThatIsToldOfJobsIsThatTheyAreDone) {
  Viewport* viewport = window->viewport();
  if (viewport->hosting() == Hosting::Composed) GTEST_SKIP() << "Qt keeps the context";
  picture();
  QSignalSpy told(viewport, &Viewport::jobProgress);
  viewport->renewContext();
  const auto last = [&] { return told.isEmpty() ? QString() : told.last().at(0).toString(); };
  ASSERT_TRUE(QTest::qWaitFor([&] { return !last().isEmpty(); }, kPatienceMs));
  // The window is drawn again and again while they go on, and does what is left of them.
  for (int i = 0; i < 20000 && viewport->statistics().frames == 0; ++i) static_cast<void>(viewport->grabFrame());
  picture();
  EXPECT_TRUE(QTest::qWaitFor([&] { return last().isEmpty(); }, 5000)) << last().toStdString();
}

TEST(Pace, DrawsSmallerOnSlowMachinesAndWholeOnFastOnes) {
  Pace slow;
  for (int i = 0; i < 20; ++i) slow.measured(200.0 * slow.scale() * slow.scale());
  EXPECT_LE(slow.scale(), 0.5);
  EXPECT_GE(slow.scale(), 0.375);
  Pace fast;
  for (int i = 0; i < 20; ++i) fast.measured(10.0);
  EXPECT_EQ(fast.scale(), 1.0);
  // A driver that should be fast and is not is helped as well.
  Pace weak(true);
  EXPECT_EQ(weak.scale(), 1.0);
  for (int i = 0; i < 20; ++i) weak.measured(200.0 * weak.scale() * weak.scale());
  EXPECT_LE(weak.scale(), 0.625);
}

TEST(Navigation, OrbitStopsShortOfThePoles) {
  Camera camera;
  for (int i = 0; i < 100; ++i) camera = navigation::orbit(camera, 0.1F, 0.3F);
  EXPECT_LT(camera.position.y, glm::length(camera.position));
  EXPECT_NEAR(glm::length(camera.position), 6.0F, 1e-3F);
}

TEST(Navigation, ZoomNeverReachesTheTargetNorTheEndOfNumbers) {
  for (const float side : {1.0F, -1.0F})
    for (const glm::vec3 target : {glm::vec3(0.0F), glm::vec3(0.0F, 1600.0F, 0.0F)}) {
      Camera camera;
      camera.position += target;
      camera.target = target;
      camera.orthographicHeight = 2.0F;
      const glm::vec3 direction = glm::normalize(camera.position - camera.target);
      for (int i = 0; i < 1000; ++i) camera = navigation::zoom(camera, side);
      const float distance = glm::length(camera.position - camera.target);
      EXPECT_GT(distance, 0.0F);
      EXPECT_LE(distance, 1.1e6F);
      EXPECT_GT(*camera.orthographicHeight, 0.0F);
      EXPECT_LE(*camera.orthographicHeight, 1.1e6F);
      EXPECT_GT(glm::dot(glm::normalize(camera.position - camera.target), direction), 0.999F);
      // And it comes back.
      const Camera back = navigation::zoom(camera, -side);
      EXPECT_NE(back.position, camera.position);
    }
}

TEST(Navigation, FrameKeepsTheBoundsInView) {
  Bounds bounds;
  bounds.grow({9, 9, 9});
  bounds.grow({11, 11, 11});
  const Camera camera = navigation::frame(Camera{}, bounds, 0.5F);
  EXPECT_EQ(camera.target, glm::vec3(10.0F));
  const float half = std::atan(std::tan(0.5F * glm::radians(camera.verticalFovDegrees)) * 0.5F);
  EXPECT_GE(glm::length(camera.position - camera.target) * std::sin(half), bounds.radius());
}

}  // namespace
}  // namespace dermis
