// Every way to change a number, in every dock: the picture, the document and the undo list know of it, and one step
// back undoes all of it.
#include <QApplication>
#include <QClipboard>
#include <QMenu>
#include <functional>

#include "ui/docks/lights_panel.h"
#include "ui/docks/material_clipboard.h"
#include "ui/docks/material_panel.h"
#include "ui/document/rig_edit.h"
#include "ui/editor_fixture.h"
#include "ui/main_window/view_tools.h"

namespace dermis {
namespace {

class Edits : public Editor {
 protected:
  void SetUp() override {
    Editor::SetUp();
    window->activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(window.get(), kPatienceMs));
  }
  /// `least` is the mean difference of the picture, in codes.
  void expectOneStep(const std::function<void()>& hand, float least = 0.05F) {
    const QImage before = picture();
    const Scene start = document().scene();
    const Camera camera = document().camera();
    const int steps = undo().index();
    hand();
    ASSERT_TRUE(waitIdle());
    EXPECT_EQ(undo().index(), steps + 1);
    EXPECT_TRUE(document().scene() != start || document().camera() != camera);
    EXPECT_GT(meanDifference(before, picture()), least);
    undo().undo();
    ASSERT_TRUE(waitIdle());
    EXPECT_EQ(document().scene(), start);
    EXPECT_EQ(document().camera(), camera);
    EXPECT_LT(meanDifference(before, picture()), 0.05F);
  }
  ValueSlider* slider(const char* id) {
    auto* found = find<ValueSlider>(QLatin1String(id) + QStringLiteral(".slider"));
    EXPECT_NE(found, nullptr) << id;
    reveal(found);
    return found;
  }
  void dragSlider(const char* id, int pixels, float least = 0.05F) {
    SCOPED_TRACE(id);
    ValueSlider* handle = slider(id);
    expectOneStep([&] { drag(handle, handle->handleCentre(), pixels); }, least);
  }
  void set(const char* id, float value) { document().setParameter(document().currentSlot(), id, value, newGesture()); }
};

TEST_F(Edits, ATypedNumber) {
  auto* field = find<NumberField>(QStringLiteral("specular.perceptual_roughness.number"));
  reveal(field);
  expectOneStep([&] {
    field->setFocus();
    QTest::qWait(0);
    field->selectAll();
    QTest::keyClicks(field, QStringLiteral("0,9"));
    QTest::keyClick(field, Qt::Key_Return);
    EXPECT_FLOAT_EQ(document().currentLook()->worn.material.parameters.specularPerceptualRoughness, 0.9F);
  });
}

TEST_F(Edits, AResetByDoubleClickByKeyAndByMenu) {
  set("specular.perceptual_roughness", 0.95F);
  auto* row = find<PropertyRow>(QStringLiteral("specular.perceptual_roughness"));
  reveal(row);
  expectOneStep([&] { QTest::mouseDClick(row->childAt(40, 10), Qt::LeftButton); });
  expectOneStep([&] { QTest::keyClick(row, Qt::Key_Delete); });
  expectOneStep([&] {
    QMenu menu;
    row->fillMenu(menu);
    for (QAction* action : menu.actions())
      if (action->objectName() == QStringLiteral("row.reset")) action->trigger();
  });
}

TEST_F(Edits, APastedGroup) {
  MaterialClipboard* clipboard = window->findChild<MaterialPanel*>()->clipboard();
  document().setCurrentSlot(QStringLiteral("face"));
  set("specular.perceptual_roughness", 0.95F);
  set("specular.lobe_mix", 0.1F);
  clipboard->copyGroup(QStringLiteral("Specular"));
  undo().undo();
  undo().undo();
  const Scene start = document().scene();
  expectOneStep([&] { clipboard->paste(); });
  EXPECT_EQ(document().scene(), start);
}

TEST_F(Edits, SlidersOfTheLightsDock) {
  window->findChild<LightsPanel*>()->addLight(LightType::Spot);
  dragSlider("light.intensity", 30);
  dragSlider("light.outer_degrees", -25);
  auto* position = find<NumberField>(QStringLiteral("light.position.x"));
  if (position == nullptr) position = find<PropertyRow>(QStringLiteral("light.position"))->findChild<NumberField*>();
  ASSERT_NE(position, nullptr);
  reveal(position);
  expectOneStep([&] {
    position->setFocus();
    position->setValue(-position->value());
  });
}

TEST_F(Edits, SlidersOfTheEnvironmentDock) {
  dragSlider("environment.rotation_degrees", 40);
  dragSlider("environment.exposure_stops", 20);
}

TEST_F(Edits, SlidersOfALightOfTheRig) {
  window->viewTools()->rig().select(0);
  // What the light becomes is made beside the event loop, coarsely first.
  ValueSlider* handle = slider("rig.azimuth_degrees");
  const QImage before = picture();
  const Scene start = document().scene();
  drag(handle, handle->handleCentre(), 40);
  EXPECT_EQ(undo().count(), 1);
  EXPECT_NE(document().scene(), start);
  ASSERT_TRUE(QTest::qWaitFor([&] { return waitIdle() && meanDifference(before, picture()) > 0.2F; }, kPatienceMs));
  undo().undo();
  EXPECT_EQ(document().scene(), start);
  ASSERT_TRUE(QTest::qWaitFor([&] { return waitIdle() && meanDifference(before, picture()) < 0.05F; }, kPatienceMs));
  window->viewTools()->rig().select(-1);
}

TEST_F(Edits, SlidersOfTheCameraDock) {
  dragSlider("view.exposure_stops", -20);
  dragSlider("camera.vertical_fov_degrees", 25);
}

}  // namespace
}  // namespace dermis
