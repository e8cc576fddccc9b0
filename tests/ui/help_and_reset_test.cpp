// Every row of every dock says what it means, and goes back to what it was.
#include "ui/document/rig_edit.h"
#include "ui/editor_fixture.h"
#include "ui/main_window/view_tools.h"

namespace dermis {
namespace {

class Rows : public Editor {
 protected:
  PropertyRow* row(const char* id) {
    auto* found = find<PropertyRow>(QString::fromLatin1(id));
    EXPECT_NE(found, nullptr) << id;
    return found;
  }
  static void doubleClick(QWidget* on, QPoint at) {
    QTest::mouseClick(on, Qt::LeftButton, {}, at);
    QTest::mouseDClick(on, Qt::LeftButton, {}, at);
  }
};

TEST_F(Rows, EachSaysWhatItMeans) {
  int rows = 0;
  for (const PropertyRow* each : window->findChildren<PropertyRow*>()) {
    ++rows;
    const std::string id = each->objectName().toStdString();
    EXPECT_FALSE(each->toolTip().isEmpty()) << id;
    EXPECT_FALSE(each->editor()->whatsThis().isEmpty()) << id;
    for (const auto* field : each->findChildren<NumberField*>()) EXPECT_FALSE(field->whatsThis().isEmpty()) << id;
  }
  EXPECT_GT(rows, 60);
}

TEST_F(Rows, TheFieldsOfAMapSayWhatTheyMean) {
  reveal(find(QStringLiteral("textures.folder")));
  for (const char* field : {"color_space", "channel", "uv_scale", "scale", "invert", "flip_green"}) {
    const auto* control = find<QWidget>(QStringLiteral("texture.roughness.") + QLatin1String(field));
    ASSERT_NE(control, nullptr) << field;
    EXPECT_FALSE(control->whatsThis().isEmpty()) << field;
  }
}

TEST_F(Rows, ATipNamesRangeAndUnit) {
  EXPECT_TRUE(row("light.inner_degrees")->toolTip().contains(QStringLiteral("0 to 90 °")))
      << row("light.inner_degrees")->toolTip().toStdString();
  EXPECT_TRUE(row("camera.vertical_fov_degrees")->toolTip().contains(QStringLiteral("1 to 150 °")));
  EXPECT_TRUE(row("environment.exposure_stops")->toolTip().contains(QStringLiteral("EV")));
}

TEST_F(Rows, BackgroundAndLensAreReset) {
  const Scene start = document().scene();
  EnvironmentSource next = start.environment;
  next.background = Background{BackgroundKind::Color, 0.0F, glm::vec3(0.5F, 0.0F, 0.0F)};
  document().setEnvironmentSettings(next, QStringLiteral("Background"), newGesture());
  EXPECT_TRUE(row("environment.background")->isModified());
  EXPECT_TRUE(row("environment.background.color")->isModified());
  row("environment.background.color")->reset();
  EXPECT_EQ(document().scene().environment.background.color, Background{}.color);
  row("environment.background")->reset();
  EXPECT_EQ(document().scene().environment.background.kind, Background{}.kind);
  EXPECT_EQ(undo().count(), 3);

  const Camera camera = document().camera();
  document().setLens(Lens{camera.verticalFovDegrees, 3.0F}, newGesture());
  EXPECT_TRUE(row("camera.orthographic")->isModified());
  EXPECT_TRUE(row("camera.orthographic_height")->isModified());
  row("camera.orthographic_height")->reset();
  EXPECT_NEAR(
      *document().camera().orthographicHeight,
      2.0F * glm::length(camera.position - camera.target) * std::tan(0.5F * glm::radians(camera.verticalFovDegrees)),
      1e-4F);
  row("camera.orthographic")->reset();
  EXPECT_FALSE(document().camera().orthographicHeight.has_value());
}

TEST_F(Rows, ARigsLightGoesBackToWhatTheRigCameWith) {
  RigEdit& rig = window->viewTools()->rig();
  ASSERT_NE(rig.rig(), nullptr) << "the embedded look is lit by a rig";
  const LightRig before = *rig.rig();
  rig.select(0);
  RigElement moved = before.elements.front();
  moved.azimuthDegrees += 25.0F;
  rig.setElement(0, moved, QStringLiteral("Azimuth"), newGesture());
  ASSERT_TRUE(rig.isOwn());
  EXPECT_TRUE(row("rig.azimuth_degrees")->isModified());
  EXPECT_FALSE(row("rig.elevation_degrees")->isModified());
  row("rig.azimuth_degrees")->reset();
  EXPECT_EQ(rig.rig()->elements.front(), before.elements.front());
  EXPECT_FALSE(row("rig.azimuth_degrees")->isModified());
  rig.select(-1);
}

TEST_F(Rows, ADoubleClickOnTheSliderOrTheDotResetsAsOneEntry) {
  const auto mix = [this] { return document().currentLook()->worn.material.parameters.specularLobeMix; };
  const float standard = mix();
  auto* slider = find<ValueSlider>(QStringLiteral("specular.lobe_mix.slider"));
  reveal(slider);
  document().setParameter(document().currentSlot(), "specular.lobe_mix", 0.1F, newGesture());
  // Beside the handle: the first click moves it, and the two are one step back.
  doubleClick(slider, QPoint(slider->width() / 2, slider->height() / 2));
  EXPECT_FLOAT_EQ(mix(), standard);
  EXPECT_EQ(undo().count(), 2);
  undo().undo();
  EXPECT_FLOAT_EQ(mix(), 0.1F);
  auto* dot = row("specular.lobe_mix")->childAt(4, 10);
  ASSERT_NE(dot, nullptr);
  doubleClick(dot, dot->rect().center());
  EXPECT_FLOAT_EQ(mix(), standard);
}

}  // namespace
}  // namespace dermis
