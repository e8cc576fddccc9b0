// Lights moved by hand in the picture: one undo entry a gesture, Esc leaves none.
#include <QAction>
#include <QListWidget>

#include "ui/editor_fixture.h"
#include "ui/main_window/view_tools.h"
#include "ui/viewport/light_dome.h"
#include "ui/viewport/light_gizmos.h"

namespace dermis {
namespace {

class Gizmos : public PictureEditor {
 protected:
  void SetUp() override {
    PictureEditor::SetUp();
    if (HasFatalFailure()) return;
    gizmos().setEnabled(true);
    put(LightType::Point);
    wake();
  }
  LightGizmos& gizmos() { return window->viewTools()->gizmos(); }
  const Light& light() { return document().scene().lights.front(); }
  glm::vec3 centre() { return document().model()->bounds.centre(); }
  void put(LightType type) {
    while (!document().scene().lights.empty()) document().removeLight(0);
    Light light;
    light.type = type;
    light.position = centre() + glm::vec3(0.6F, 0.5F, 0.6F);
    light.direction = -glm::normalize(light.position - centre());
    document().addLight(light);
    gizmos().select(0);
    m_entries = undo().count();
  }
  int entries() { return undo().count() - m_entries; }

  int m_entries = 0;
};

TEST_F(Gizmos, ADragMovesALampOnItsSphereAsOneEntry) {
  const QImage before = picture();
  const Light start = light();
  const QPointF from = gizmos().handle(0);
  const QPointF to = from + QPointF(-90.0, 40.0);
  wake();
  press(from);
  pull(from, to);
  letGo(to);
  EXPECT_EQ(entries(), 1);
  EXPECT_NE(light().position, start.position);
  EXPECT_NEAR(glm::length(light().position - centre()), glm::length(start.position - centre()), 1e-4F);
  // The handle is where it was let go.
  EXPECT_LT((gizmos().handle(0) - to).manhattanLength(), 0.5);
  EXPECT_GT(meanDifference(before, picture()), 0.05F);
  undo().undo();
  EXPECT_EQ(light(), start);
}

TEST_F(Gizmos, EscEndsADragAndLeavesNoEntry) {
  const Light start = light();
  const QPointF from = gizmos().handle(0);
  wake();
  press(from);
  pull(from, from + QPointF(70.0, 0.0));
  EXPECT_NE(light(), start);
  QTest::keyClick(viewport(), Qt::Key_Escape);
  EXPECT_EQ(light(), start);
  EXPECT_EQ(entries(), 0);
  pull(from, from + QPointF(-70.0, 0.0));
  letGo(from);
  EXPECT_EQ(light(), start);
  EXPECT_EQ(entries(), 0);
}

TEST_F(Gizmos, EscEndsTurningTheEnvironmentToo) {
  const QPointF from(80.0, 80.0);
  press(from, Qt::ShiftModifier, Qt::RightButton);
  pull(from, from + QPointF(60.0, 0.0), Qt::RightButton);
  EXPECT_NE(document().scene().environment.rotationDegrees, 0.0F);
  QTest::keyClick(viewport(), Qt::Key_Escape);
  EXPECT_EQ(document().scene().environment.rotationDegrees, 0.0F);
  letGo(from, Qt::RightButton);
  EXPECT_EQ(entries(), 0);
}

TEST_F(Gizmos, AClickSelectsHereAndInTheDock) {
  Light second = light();
  second.position = centre() + glm::vec3(-0.7F, 0.2F, 0.5F);
  document().addLight(second);
  const int before = undo().count();
  auto* list = find<QListWidget>(QStringLiteral("lights.list"));
  for (const int which : {1, 0}) {
    wake();
    const QPointF at = gizmos().handle(static_cast<std::size_t>(which));
    press(at);
    letGo(at);
    EXPECT_EQ(gizmos().selected(), which);
    EXPECT_EQ(list->currentRow(), which);
  }
  EXPECT_EQ(undo().count(), before);
}

TEST_F(Gizmos, HoldingLMovesTheKeyLightFromAnywhere) {
  const Light start = light();
  const QPointF from(60.0, 300.0);
  QTest::keyPress(viewport(), Qt::Key_L);
  press(from);
  pull(from, from + QPointF(80.0, 0.0));
  letGo(from + QPointF(80.0, 0.0));
  QTest::keyRelease(viewport(), Qt::Key_L);
  EXPECT_EQ(entries(), 1);
  EXPECT_NE(light().position, start.position);
  EXPECT_NEAR(glm::length(light().position - centre()), glm::length(start.position - centre()), 1e-4F);
  undo().undo();
  EXPECT_EQ(light(), start);
}

TEST_F(Gizmos, ARectanglesSidesAreDraggedOneByOne) {
  put(LightType::Rect);
  wake();
  ASSERT_EQ(gizmos().sizeHandles().size(), 2);
  const Light start = light();
  const QPointF width = gizmos().sizeHandles()[0];
  press(width);
  pull(width, width + QPointF(26.0, 0.0));
  letGo(width + QPointF(26.0, 0.0));
  EXPECT_NEAR(light().sizeMm.x, 2.0F * start.sizeMm.x, 0.1F * start.sizeMm.x);
  EXPECT_EQ(light().sizeMm.y, start.sizeMm.y);
  EXPECT_EQ(entries(), 1);
}

TEST_F(Gizmos, TheWheelOverAHandleChangesTheDistanceWithCtrlTheSize) {
  put(LightType::Sphere);
  wake();
  const Light start = light();
  const QPointF at = gizmos().handle(0);
  const auto turn = [&](Qt::KeyboardModifiers keys) {
    for (int i = 0; i < 3; ++i) {
      QWheelEvent event(at, viewport()->mapToGlobal(at), QPoint(), QPoint(0, 120), Qt::NoButton, keys,
                        Qt::NoScrollPhase, false);
      QApplication::sendEvent(viewport(), &event);
    }
  };
  turn(Qt::NoModifier);
  EXPECT_LT(glm::length(light().position - centre()), glm::length(start.position - centre()));
  EXPECT_EQ(entries(), 1);
  turn(Qt::ControlModifier);
  EXPECT_GT(light().radiusMm, start.radiusMm);
  EXPECT_EQ(entries(), 2);
}

TEST_F(Gizmos, TheyLeaveWithThePointerAndWithTheMenu) {
  EXPECT_TRUE(gizmos().isShown());
  QEvent away(QEvent::Leave);
  QApplication::sendEvent(viewport(), &away);
  EXPECT_FALSE(gizmos().isShown());
  wake();
  EXPECT_TRUE(gizmos().isShown());
  gizmos().setEnabled(false);
  EXPECT_FALSE(gizmos().isShown());
  // What is not shown is not taken hold of.
  const Camera camera = document().camera();
  const QPointF at = gizmos().handle(0);
  press(at);
  pull(at, at + QPointF(40.0, 0.0));
  letGo(at);
  EXPECT_EQ(entries(), 0);
  EXPECT_NE(document().camera().position, camera.position);
}

TEST_F(Gizmos, ASetOfLampsTakesThePlaceOfAllAsOneEntry) {
  const Scene before = document().scene();
  find<QAction>(QStringLiteral("light.set.three-point"))->trigger();
  EXPECT_EQ(entries(), 1);
  ASSERT_EQ(document().scene().lights.size(), 3U);
  const Light& key = document().scene().lights.front();
  EXPECT_EQ(key.type, LightType::Rect);
  // It looks at the model's middle, from the left front.
  EXPECT_NEAR(glm::dot(key.direction, glm::normalize(centre() - key.position)), 1.0F, 1e-5F);
  EXPECT_LT(key.position.x, centre().x);
  EXPECT_GT(key.position.z, centre().z);
  undo().undo();
  EXPECT_EQ(document().scene(), before);
}

TEST(LightDome, EveryDirectionHasOnePlace) {
  Camera camera;
  camera.position = {1.0F, 2.0F, 5.0F};
  const Projection view(camera, QSizeF(800.0, 600.0));
  for (const glm::vec3 d :
       {glm::vec3(1, 0, 0), glm::vec3(0, 1, 0), glm::vec3(0.3F, -0.2F, -0.9F), glm::vec3(-1, 2, 3)}) {
    const glm::vec3 unit = glm::normalize(d);
    const glm::vec3 back = dome::direction(view, dome::place(view, unit));
    EXPECT_NEAR(glm::dot(unit, back), 1.0F, 1e-5F);
  }
  // From the side: on the first ring.
  const QPointF side = dome::place(view, view.right()) - view.middle();
  EXPECT_NEAR(side.x(), dome::ringRadius(view), 1e-3);
  EXPECT_NEAR(side.y(), 0.0, 1e-3);
}

TEST(LightDome, WhatALightAimsAtTurnsAlong) {
  Light spot;
  spot.type = LightType::Spot;
  spot.position = {0.0F, 0.0F, 2.0F};
  spot.direction = {0.0F, 0.0F, -1.0F};
  const Light turned = dome::turned(spot, glm::vec3(0.0F), {1.0F, 0.0F, 0.0F});
  EXPECT_NEAR(turned.position.x, 2.0F, 1e-5F);
  EXPECT_NEAR(turned.direction.x, -1.0F, 1e-5F);
}

TEST(LightDome, TheKeyLightIsTheOneThatSendsMost) {
  Light near, far;
  near.position = {0.0F, 0.0F, 1.0F};
  far.position = {0.0F, 0.0F, 4.0F};
  far.intensity = 10.0F;
  EXPECT_EQ(dome::keyLight({far, near}, glm::vec3(0.0F)), 1U);
  near.enabled = false;
  EXPECT_EQ(dome::keyLight({far, near}, glm::vec3(0.0F)), 0U);
  EXPECT_EQ(dome::keyLight({}, glm::vec3(0.0F)), std::nullopt);
}

}  // namespace
}  // namespace dermis
