// What a hand does to the elements of a rig.
#include "core/light_rig/rig_gestures.h"

#include <gtest/gtest.h>

#include "core/builtin/environments.h"
#include "core/light_rig/rig_io.h"
#include "core/scene/scene_io.h"

namespace dermis {
namespace {

TEST(RigGestures, ATurnedElementIsWhereItWasPut) {
  RigElement box;
  for (const float rotation : {0.0F, 75.0F, -200.0F})
    for (const glm::vec3 to : {glm::vec3(1, 0, 0), glm::vec3(-1, 2, 3), glm::vec3(0, -1, 0.5F)}) {
      const glm::vec3 unit = glm::normalize(to);
      const glm::vec3 found = worldDirection(turnedTo(box, unit, rotation), rotation);
      EXPECT_LT(glm::length(found - unit), 3e-4F) << rotation << ' ' << to.x;
    }
  // Straight up the azimuth has no meaning, and stays.
  box.azimuthDegrees = 30.0F;
  const RigElement up = turnedTo(box, {0, 1, 0}, 10.0F);
  EXPECT_FLOAT_EQ(up.azimuthDegrees, 30.0F);
  EXPECT_FLOAT_EQ(up.elevationDegrees, 90.0F);
  // The environment's turn is counter-clockwise seen from above: from the camera's side to its right.
  box.azimuthDegrees = 0.0F;
  EXPECT_NEAR(worldDirection(box, 90.0F).x, 1.0F, 1e-6F);
}

TEST(RigGestures, AnElementIsNotPutOnWhatItFaces) {
  RigElement box;
  box.distanceM = 2.0F;
  box.aimM = {2.0F, 0.0F, 0.0F};
  EXPECT_EQ(turnedTo(box, {1, 0, 0}, 0.0F), box);
}

TEST(RigGestures, EveryElementOfTheBuiltInRigsKeepsAValidFile) {
  for (const BuiltinEnvironmentRow& row : builtinEnvironments()) {
    LightRig rig = *builtinRig(row.id);
    for (RigElement& element : rig.elements) {
      const float before = amountOf(element);
      const bool placed = hasPlace(element.type);
      EXPECT_EQ(sizeOf(element).has_value(), placed) << row.id;
      if (placed) {
        element = turnedTo(element, glm::normalize(glm::vec3(0.3F, 0.5F, -0.8F)), 20.0F);
        element = withSize(element, 1e9F * sizeOf(element)->size);
        element = withSize(element, 1.5F * sizeOf(element)->size);
      }
      element = withAmount(element, 2.0F * before);
      EXPECT_FLOAT_EQ(amountOf(element), element.type == RigElementType::Ground ? 1.0F : 2.0F * before) << row.id;
      EXPECT_GE(amountOf(withAmount(element, -1.0F)), 0.0F);
    }
    Warnings warnings;
    const auto read = readRig(writeRig(rig), row.id, warnings);
    ASSERT_TRUE(read) << row.id << ": " << read.error().message;
    EXPECT_TRUE(warnings.empty()) << warnings.front();
    EXPECT_EQ(*read, rig) << row.id;
  }
}

TEST(RigGestures, ASceneKeepsItsOwnRigByteForByte) {
  Scene scene;
  LightRig rig = *builtinRig("studio");
  rig.elements[0].azimuthDegrees = 12.34F;
  scene.environment.builtin.clear();
  scene.environment.rig = InlineRig(rig);
  scene.environment.rotationDegrees = 30.0F;
  const std::string text = writeScene(scene, {});
  Warnings warnings;
  const auto read = readScene(text, "look", {}, warnings);
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_TRUE(warnings.empty());
  EXPECT_EQ(read->environment, scene.environment);
  EXPECT_EQ(*read->environment.rig, rig);
  EXPECT_EQ(writeScene(*read, {}), text);
  // Faults are told with their place in the scene.
  const auto bad = readScene(R"({"format": "dermis.scene", "version": 1, "environment": {"rig": {"format": "dermis.rig",
      "version": 1, "elements": [{"type": "lantern"}]}}})",
                             "look", {}, warnings);
  ASSERT_FALSE(bad);
  EXPECT_NE(bad.error().message.find("/environment/rig/elements/0/type"), std::string::npos) << bad.error().message;
  EXPECT_FALSE(readScene(R"({"format": "dermis.scene", "version": 1, "environment": {"builtin": "rim",
      "rig": {"format": "dermis.rig", "version": 1, "elements": []}}})",
                         "look", {}, warnings));
}

}  // namespace
}  // namespace dermis
