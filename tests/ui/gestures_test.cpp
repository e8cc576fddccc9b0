// Hands on the real picture: each gesture moves what it should, is seen, and is or is not a step of undo.
#include <QWheelEvent>

#include "ui/editor_fixture.h"
#include "ui/viewport/model_picker.h"
#include "ui/viewport/projection.h"

namespace dermis {
namespace {

class Gestures : public PictureEditor {
 protected:
  static QPointF middle() { return QRectF(viewport()->rect()).center(); }
  static float distance(const Camera& camera) { return glm::length(camera.position - camera.target); }
  static glm::vec3 direction(const Camera& camera) { return glm::normalize(camera.position - camera.target); }
  static void dragBy(QPointF way, Qt::MouseButton button = Qt::LeftButton, Qt::KeyboardModifiers keys = {}) {
    press(middle(), keys, button);
    for (int i = 1; i <= 8; ++i) send(QEvent::MouseMove, middle() + way * (i / 8.0), Qt::NoButton, button, keys);
    send(QEvent::MouseButtonRelease, middle() + way, button, Qt::NoButton, keys);
  }
  static void wheel(int delta, Qt::KeyboardModifiers keys = {}) {
    const QPointF at(10.0, 10.0);  // beside the handles
    QWheelEvent event(at, viewport()->mapToGlobal(at), {}, {0, delta}, Qt::NoButton, keys, Qt::NoScrollPhase, false);
    QApplication::sendEvent(viewport(), &event);
  }
  /// What moves the camera is seen, and is nothing that a scene has to be saved for.
  template <class Hand>
  void expectSeenAndNoEntry(Hand hand) {
    const QImage before = picture();
    const Camera start = document().camera();
    hand();
    EXPECT_FALSE(document().camera() == start);
    EXPECT_EQ(undo().count(), 0);
    EXPECT_FALSE(document().isModified());
    EXPECT_GT(meanDifference(before, picture()), 0.2F);
  }
};

TEST_F(Gestures, TheMiddleButtonAndShiftPan) {
  for (const auto& [button, keys] : {std::pair(Qt::MiddleButton, Qt::KeyboardModifiers()),
                                     std::pair(Qt::LeftButton, Qt::KeyboardModifiers(Qt::ShiftModifier))}) {
    const Camera start = document().camera();
    const glm::vec3 grabbed = start.target;
    expectSeenAndNoEntry([&, button = button, keys = keys] { dragBy({60.0, 30.0}, button, keys); });
    const Camera now = document().camera();
    EXPECT_NEAR(glm::length((now.position - now.target) - (start.position - start.target)), 0.0F, 1e-4F);
    // What was under the hand still is.
    const auto at = viewport()->projection().toScreen(grabbed);
    ASSERT_TRUE(at.has_value());
    EXPECT_NEAR(at->x(), middle().x() + 60.0, 2.0);
    EXPECT_NEAR(at->y(), middle().y() + 30.0, 2.0);
  }
}

TEST_F(Gestures, TheWheelAndTheRightButtonZoom) {
  const Camera start = document().camera();
  expectSeenAndNoEntry([] { wheel(240); });
  EXPECT_NEAR(distance(document().camera()) / distance(start), 0.88F * 0.88F, 1e-3F);
  EXPECT_NEAR(glm::dot(direction(document().camera()), direction(start)), 1.0F, 1e-5F);
  // With Shift a fifth of a tick.
  const float before = distance(document().camera());
  wheel(120, Qt::ShiftModifier);
  EXPECT_NEAR(distance(document().camera()) / before, std::pow(0.88F, 0.2F), 1e-3F);
  const float near = distance(document().camera());
  expectSeenAndNoEntry([] { dragBy({-50.0, 0.0}, Qt::RightButton); });
  EXPECT_GT(distance(document().camera()), near);
  dragBy({0.0, -50.0}, Qt::RightButton);
  EXPECT_NEAR(distance(document().camera()), near, 1e-3F * near);
}

TEST_F(Gestures, AltAndADragMovesTheCameraAsWithoutIt) {
  const Camera start = document().camera();
  expectSeenAndNoEntry([] { dragBy({60.0, 0.0}, Qt::LeftButton, Qt::AltModifier); });
  const Camera with = document().camera();
  document().setCamera(start);
  dragBy({60.0, 0.0});
  EXPECT_EQ(document().camera(), with);
  document().setCamera(start);
  dragBy({0.0, 40.0}, Qt::MiddleButton, Qt::AltModifier);
  EXPECT_NE(document().camera().target, start.target);
  document().setCamera(start);
  dragBy({40.0, 0.0}, Qt::RightButton, Qt::AltModifier);
  EXPECT_LT(distance(document().camera()), distance(start));
}

TEST_F(Gestures, ADoubleClickLooksAtWhatIsThereAndFFramesAll) {
  const Camera start = document().camera();
  picture();
  const QPointF at = middle() + QPointF(0.0, 0.1 * viewport()->height());
  const auto hit = viewport()->surfaceAt(at);
  ASSERT_TRUE(hit.has_value());
  expectSeenAndNoEntry([&] { send(QEvent::MouseButtonDblClick, at, Qt::LeftButton, Qt::LeftButton); });
  EXPECT_NEAR(glm::length(document().camera().target - hit->position), 0.0F, 0.02F);
  EXPECT_NEAR(distance(document().camera()), distance(start), 1e-3F);
  wheel(600);
  expectSeenAndNoEntry([] { QTest::keyClick(viewport(), Qt::Key_F); });
  EXPECT_EQ(document().camera().target, document().model()->bounds.centre());
  // The double-click's own press and release end nothing that was begun.
  letGo(at);
}

TEST_F(Gestures, TheRightButtonAndLettersFly) {
  const Camera start = document().camera();
  const QImage before = picture();
  press(middle(), {}, Qt::RightButton);
  QTest::keyPress(viewport(), Qt::Key_W);
  ASSERT_TRUE(QTest::qWaitFor([&] { return document().camera().position != start.position; }, kPatienceMs));
  QTest::keyRelease(viewport(), Qt::Key_W);
  const Camera flown = document().camera();
  EXPECT_GT(glm::dot(flown.position - start.position, start.target - start.position), 0.0F) << "W flies forward";
  EXPECT_NEAR(distance(flown), distance(start), 1e-3F);
  // Moving the hand turns the head.
  pull(middle(), middle() + QPointF(40.0, 0.0), Qt::RightButton);
  EXPECT_EQ(document().camera().position, flown.position);
  EXPECT_NE(document().camera().target, flown.target);
  letGo(middle() + QPointF(40.0, 0.0), Qt::RightButton);
  EXPECT_EQ(undo().count(), 0);
  EXPECT_GT(meanDifference(before, picture()), 0.2F);
}

TEST_F(Gestures, EscEndsADragWhereItBegan) {
  const Camera start = document().camera();
  for (const Qt::MouseButton button : {Qt::LeftButton, Qt::MiddleButton, Qt::RightButton}) {
    press(middle(), {}, button);
    pull(middle(), middle() + QPointF(50.0, 20.0), button);
    EXPECT_FALSE(document().camera() == start);
    QTest::keyClick(viewport(), Qt::Key_Escape);
    EXPECT_EQ(document().camera(), start);
    // What the hand does until it lets go is nothing.
    send(QEvent::MouseMove, middle() + QPointF(90.0, 20.0), Qt::NoButton, button);
    EXPECT_EQ(document().camera(), start);
    letGo(middle() + QPointF(90.0, 20.0), button);
  }
}

TEST_F(Gestures, ShiftAndTheRightButtonTurnTheLightAsOneEntry) {
  const QImage before = picture();
  const Camera camera = document().camera();
  dragBy({120.0, 0.0}, Qt::RightButton, Qt::ShiftModifier);
  EXPECT_NEAR(document().scene().environment.rotationDegrees, 48.0F, 1e-3F);
  EXPECT_EQ(document().camera(), camera);
  EXPECT_EQ(undo().count(), 1);
  EXPECT_GT(meanDifference(before, picture()), 0.2F);
  undo().undo();
  EXPECT_EQ(document().scene().environment.rotationDegrees, 0.0F);
  EXPECT_LT(meanDifference(before, picture()), 0.05F);
}

// --- keys

TEST_F(Gestures, ArrowsTurnAndShiftThePicture) {
  const Camera start = document().camera();
  expectSeenAndNoEntry([] { QTest::keyClick(viewport(), Qt::Key_Left); });
  const Camera byKey = document().camera();
  EXPECT_NEAR(distance(byKey), distance(start), 1e-3F);
  document().setCamera(start);
  dragBy({-20.0, 0.0});
  EXPECT_GT(
      glm::dot(glm::cross(start.position, byKey.position), glm::cross(start.position, document().camera().position)),
      0.0F)
      << "an arrow turns as a drag that way does";
  document().setCamera(start);
  expectSeenAndNoEntry([] { QTest::keyClick(viewport(), Qt::Key_Up, Qt::ShiftModifier); });
  const auto at = viewport()->projection().toScreen(start.target);
  ASSERT_TRUE(at.has_value());
  EXPECT_LT(at->y(), middle().y() - 10.0);
  const float before = distance(document().camera());
  QTest::keyClick(viewport(), Qt::Key_Plus);
  EXPECT_LT(distance(document().camera()), before);
  QTest::keyClick(viewport(), Qt::Key_Minus);
  EXPECT_NEAR(distance(document().camera()), before, 1e-3F * before);
}

TEST_F(Gestures, ArrowsStayWithASliderThatHasTheFocus) {
  auto* slider = find<ValueSlider>(QStringLiteral("specular.lobe_mix.slider"));
  reveal(slider);
  slider->setFocus();
  const Camera start = document().camera();
  const double number = slider->number();
  QTest::keyClick(slider, Qt::Key_Left);
  EXPECT_EQ(document().camera(), start);
  EXPECT_LT(slider->number(), number);
}

}  // namespace
}  // namespace dermis
