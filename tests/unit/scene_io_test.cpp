#include "core/scene/scene_io.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/json_text.h"
#include "core/material/preset_io.h"
#include "core/scene/cameras.h"
#include "unit/temporary_folder.h"

namespace dermis {
namespace {

using test::contentOf;
using test::isOneSentence;
using test::TemporaryFolder;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
namespace fs = std::filesystem;

std::string sceneText(std::string_view rest) {
  return R"({"format": "dermis.scene", "version": 1)" + (rest.empty() ? "" : ", " + std::string(rest)) + "}";
}

Scene read(std::string_view rest, Warnings& warnings, const fs::path& folder = "/scenes") {
  auto scene = readScene(sceneText(rest), "look.dermis", folder, warnings);
  EXPECT_TRUE(scene.has_value()) << scene.error().message;
  return scene ? *scene : Scene();
}

std::string refusal(std::string_view rest) {
  Warnings warnings;
  const auto scene = readScene(sceneText(rest), "look.dermis", "/scenes", warnings);
  EXPECT_FALSE(scene.has_value()) << rest;
  if (scene) return {};
  EXPECT_EQ(scene.error().kind, Error::Kind::Input);
  EXPECT_TRUE(isOneSentence(scene.error().message)) << scene.error().message;
  return scene.error().message;
}

TEST(SceneIo, EverythingMayBeLeftOut) {
  Warnings warnings;
  EXPECT_EQ(read("", warnings), Scene());
  EXPECT_THAT(warnings, IsEmpty());
  const Scene scene;
  EXPECT_TRUE(scene.lights.empty());
  EXPECT_FALSE(scene.camera.has_value());
  EXPECT_EQ(scene.environment.builtin, "studio");
  EXPECT_EQ(scene.view.transform, "ACES");
}

TEST(SceneIo, ReadsTheSceneOfTheDesign) {
  const TemporaryFolder folder;
  Material fair;
  fair.name = "Fair";
  fair.parameters.specularIor = 1.5F;
  ASSERT_TRUE(savePreset(folder / "fair.json", fair).has_value());
  Warnings warnings;
  const Scene scene = read(R"(
    "model": {"path": "head.glb", "millimetres_per_unit": 1000},
    "materials": {"face": "fair.json", "eye": {"format": "dermis.material", "version": 1, "model": "eye"}, "*": "fair.json"},
    "environment": {"path": "studio.exr", "rotation_degrees": 30, "exposure_stops": 0.5, "background": "environment"},
    "lights": [{"type": "point", "position": [0,2,3], "color": [1,0.95,0.9], "intensity": 20, "shadow": true, "visible": false}],
    "camera": {"position": [0,0,6], "target": [0,0,0], "up": [0,1,0], "vertical_fov_degrees": 26},
    "view": {"transform": "ACES", "display": "sRGB", "exposure_stops": 0})",
                           warnings, folder.path());
  EXPECT_THAT(warnings, IsEmpty());
  EXPECT_EQ(scene.model.path, (folder / "head.glb").string());
  EXPECT_TRUE(scene.model.builtin.empty());
  EXPECT_EQ(scene.model.millimetresPerUnit, 1000.0F);
  EXPECT_EQ(scene.materials.at("face").material.name, "Fair");
  EXPECT_EQ(scene.materials.at("face").presetPath, (folder / "fair.json").string());
  EXPECT_FALSE(scene.materials.at("face").edited);
  EXPECT_EQ(scene.materials.at("eye").material.model, ShadingModel::Eye);
  EXPECT_EQ(scene.bindingFor("anything")->material.parameters.specularIor, 1.5F);
  EXPECT_EQ(scene.environment.path, (folder / "studio.exr").string());
  EXPECT_EQ(scene.environment.rotationDegrees, 30.0F);
  ASSERT_EQ(scene.lights.size(), 1U);
  EXPECT_EQ(scene.lights[0].position, glm::vec3(0, 2, 3));
  EXPECT_EQ(scene.lights[0].intensity, 20.0F);
  EXPECT_EQ(scene.camera->verticalFovDegrees, 26.0F);
}

/// A scene in which everything differs from the defaults.
Scene everythingChanged() {
  Scene scene;
  scene.name = "Look";
  scene.model.builtin.clear();
  scene.model.parts = {{"/scenes/face.obj", {1, 2, 3}, {0, 90, 0}, {1, 1, 2}, {{"note", "x"}}}, {"/mnt/eye.obj"}};
  scene.model.millimetresPerUnit = 25.4F;
  MaterialBinding edited;
  edited.material.parameters.specularIor = 1.6F;
  edited.material.texture(TextureSlot::Normal).path = "/scenes/maps/n.png";
  edited.presetPath = "/scenes/presets/fair.json";
  edited.edited = true;
  scene.materials["face"] = edited;
  MaterialBinding inlined;
  inlined.material.model = ShadingModel::Lens;
  scene.materials["lens/~ odd"] = inlined;
  scene.environment.builtin.clear();
  for (std::size_t i = 0; i < 6; ++i) scene.environment.faces.at(i) = "/scenes/f" + std::to_string(i) + ".png";
  scene.environment.rotationDegrees = -33.3F;
  scene.environment.exposureStops = 1.5F;
  scene.environment.background = {BackgroundKind::Prefiltered, 0.4F, glm::vec3(0.0F)};
  for (int type = 0; type < 5; ++type) {
    Light light;
    light.type = static_cast<LightType>(type);
    light.name = "light " + std::to_string(type);
    light.position = {0.1F, 0.2F, static_cast<float>(type)};
    light.direction = {0.0F, -1.0F, 0.5F};
    light.color = {1.0F, 0.95F, 0.9F};
    light.intensity = 12.5F;
    light.shadow = false;
    light.visible = type % 2 == 0;
    light.enabled = type != 1;
    light.innerDegrees = 10.0F;
    light.outerDegrees = 12.0F;
    light.radiusMm = 33.0F;
    light.sizeMm = {100.0F, 40.0F};
    light.animation = {static_cast<AnimationKind>(type % 3), 0.7F, 2.0F};
    light.unknown = {{"gobo", "leaves"}};
    scene.lights.push_back(light);
  }
  scene.lights[1].unknown["animation"] = {{"phase", 0.5}};
  scene.camera = Camera{{1, 2, 3}, {0.1F, 0, 0}, {0, 0, 1}, 26.0F, 0.5F};
  scene.view = {"Thesis", "Rec.1886", -1.0F};
  scene.unknown = {{"model", {{"lod", 2}}}, {"camera", {{"shutter", 0.5}}}, {"future", Json::array({1, "two"})}};
  return scene;
}

TEST(SceneIo, EverythingGoesThroughTheFile) {
  const Scene scene = everythingChanged();
  const std::string text = writeScene(scene, "/scenes");
  Warnings warnings;
  const auto back = readScene(text, "look.dermis", "/scenes", warnings);
  ASSERT_TRUE(back.has_value()) << back.error().message;
  EXPECT_EQ(*back, scene) << text;
  EXPECT_EQ(writeScene(*back, "/scenes"), text);
  EXPECT_EQ(writeScene(Scene(), "/scenes"),
            writeScene(readScene(writeScene(Scene(), "/scenes"), "a", "/scenes", warnings).value(), "/scenes"));
}

TEST(SceneIo, EverySourceOfModelAndEnvironmentGoesThroughTheFile) {
  const auto throughFile = [](const Scene& scene) {
    Warnings warnings;
    return readScene(writeScene(scene, "/scenes"), "a", "/scenes", warnings).value();
  };
  for (const char* builtin : {"default", "head", "sphere", "plane"}) {
    Scene scene;
    scene.model.builtin = builtin;
    scene.environment.builtin.clear();
    scene.environment.constant = glm::vec3(1.0F, 0.5F, 0.0F);
    scene.environment.background = {BackgroundKind::Color, 0.0F, {0.1F, 0.2F, 0.3F}};
    EXPECT_EQ(throughFile(scene), scene);
  }
  Scene scene;
  scene.model = {.path = "/scenes/head.glb", .builtin = "", .parts = {}, .millimetresPerUnit = {}};
  scene.environment.builtin = "rim";
  scene.camera = Camera{};
  scene.camera->verticalFovDegrees = 30.1F;
  EXPECT_EQ(throughFile(scene), scene);
}

TEST(SceneIo, SavingWritesTheSceneOnlyAndPathsRelativeToIt) {
  const TemporaryFolder folder;
  fs::create_directories(folder / "presets");
  Material fair;
  fair.texture(TextureSlot::Albedo).path = folder / "presets/maps/a.png";
  ASSERT_TRUE(savePreset(folder / "presets/fair.json", fair).has_value());
  const std::string before = contentOf(folder / "presets/fair.json");
  folder.write("look.dermis", sceneText(R"("materials": {"face": "presets/fair.json", "eye": "builtin:thesis_eye"})"));

  Warnings warnings;
  Scene scene = loadScene(folder / "look.dermis", warnings).value();
  EXPECT_EQ(scene.materials.at("eye").presetPath, "builtin:thesis_eye");
  EXPECT_EQ(scene.materials.at("face").material.texture(TextureSlot::Albedo).path,
            (folder / "presets/maps/a.png").string());
  ASSERT_TRUE(saveScene(folder / "look.dermis", scene).has_value());
  Json json = parseJson(contentOf(folder / "look.dermis"), "a").value();
  EXPECT_EQ(json.at("materials").at("face"), "presets/fair.json");
  EXPECT_EQ(json.at("materials").at("eye"), "builtin:thesis_eye");

  scene.materials.at("face").edited = true;
  scene.materials.at("face").material.parameters.specularIor = 1.7F;
  ASSERT_TRUE(saveScene(folder / "look.dermis", scene).has_value());
  json = parseJson(contentOf(folder / "look.dermis"), "a").value();
  EXPECT_EQ(json.at("materials").at("face").at("based_on"), "presets/fair.json");
  EXPECT_EQ(json.at("materials").at("face").at("textures").at("albedo").at("path"), "presets/maps/a.png");
  EXPECT_EQ(loadScene(folder / "look.dermis", warnings).value(), scene);
  EXPECT_EQ(contentOf(folder / "presets/fair.json"), before);
}

TEST(SceneIo, APresetThatIsMissingOrWrongIsNamed) {
  const TemporaryFolder folder;
  folder.write("bad.json", R"({"format": "dermis.material", "version": 1, "name": 3})");
  Warnings warnings;
  const auto message = [&](std::string_view preset) {
    folder.write("look.dermis", sceneText(R"("materials": {"face": ")" + std::string(preset) + "\"}"));
    const auto scene = loadScene(folder / "look.dermis", warnings);
    EXPECT_EQ(scene.error().kind, Error::Kind::Input);
    EXPECT_TRUE(isOneSentence(scene.error().message));
    return scene.error().message;
  };
  EXPECT_THAT(message("none.json"), HasSubstr("/materials/face"));
  EXPECT_THAT(message("none.json"), HasSubstr("none.json cannot be read: there is no such file"));
  EXPECT_THAT(message("bad.json"), HasSubstr("bad.json: /name must be a string"));
}

TEST(SceneIo, APresetThatIsMissingCanBeKeptByItsPath) {
  const TemporaryFolder folder;
  folder.write("look.dermis", sceneText(R"("materials": {"face": "none.json", "eye": "builtin:thesis_eye"})"));
  Warnings warnings;
  const auto scene = loadScene(folder / "look.dermis", warnings, MissingPresets::Keep);
  ASSERT_TRUE(scene.has_value()) << scene.error().message;
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_TRUE(isOneSentence(warnings[0]));
  EXPECT_THAT(warnings[0], HasSubstr("/materials/face wears the default material"));
  EXPECT_TRUE(scene->materials.at("face").missing);
  EXPECT_FALSE(scene->materials.at("eye").missing);
  // What is written names the file again: it may come back.
  const std::string text = writeScene(*scene, folder.path());
  EXPECT_EQ(parseJson(text, "a").value().at("materials").at("face"), "none.json");
}

TEST(SceneIo, BackgroundsAsText) {
  for (const char* text : {"environment", "irradiance", "prefiltered:0.4", "color:0.2,0.3,0.1", "none"})
    EXPECT_EQ(toString(backgroundFromText(text).value()), text);
  for (const char* text : {"", "Environment", "prefiltered", "prefiltered:", "prefiltered:2", "prefiltered:-1",
                           "prefiltered:nan", "color:", "color:1", "color:1,2", "color:1,2,3,4", "color:-1,0,0"})
    EXPECT_FALSE(backgroundFromText(text).has_value()) << text;
}

TEST(SceneIo, WrongThingsNameTheirPlace) {
  const std::vector<std::pair<std::string, std::string>> bad = {
      {R"("model": "head.glb")", "/model must be an object"},
      {R"("model": {"path": 3})", "/model/path"},
      {R"("model": {"path": ""})", "/model/path"},
      {R"("model": {"path": "a", "builtin": "sphere"})", "/model has both path and builtin"},
      {R"("model": {"builtin": ""})", "/model/builtin"},
      {R"("model": {"parts": []})", "/model/parts"},
      {R"("model": {"parts": [{}]})", "/model/parts/0 has no path"},
      {R"("model": {"parts": [{"path": "a", "scale": 0}]})", "/model/parts/0/scale"},
      {R"("model": {"parts": [{"path": "a", "scale": [1, 2]}]})", "/model/parts/0/scale"},
      {R"("model": {"millimetres_per_unit": 0})", "/model/millimetres_per_unit"},
      {R"("model": {"millimetres_per_unit": "mm"})", "/model/millimetres_per_unit"},
      {R"("materials": [])", "/materials"},
      {R"("materials": {"face": 3})", "/materials/face"},
      {R"("materials": {"face": ""})", "/materials/face"},
      {R"("materials": {"face": {"version": 2}})", "/materials/face/version is 2"},
      {R"("materials": {"face": {"based_on": 2}})", "/materials/face/based_on"},
      {R"("materials": {"fa/ce": {"parameters": {"specular.ior": "x"}}})", "/materials/fa~1ce/parameters/specular.ior"},
      {R"("environment": {"path": "a", "constant": [1, 1, 1]})", "/environment has both path and constant"},
      {R"("environment": {"faces": ["a", "b"]})", "/environment/faces"},
      {R"("environment": {"faces": ["a", "b", "c", "d", "e", ""]})", "/environment/faces"},
      {R"("environment": {"constant": [1, 1]})", "/environment/constant"},
      {R"("environment": {"background": "green"})", "/environment/background"},
      {R"("environment": {"background": 3})", "/environment/background"},
      {R"("environment": {"rotation_degrees": null})", "/environment/rotation_degrees"},
      {R"("lights": {})", "/lights"},
      {R"("lights": [3])", "/lights/0"},
      {R"("lights": [{}, {"type": "laser"}])", "/lights/1/type must be point"},
      {R"("lights": [{"direction": [0, 0, 0]}])", "/lights/0/direction has no direction"},
      {R"("lights": [{"direction": [1e38, 1e38, 1e38]}])", "/lights/0/direction"},
      {R"("lights": [{"intensity": 1e39}])", "/lights/0/intensity"},
      {R"("lights": [{"shadow": 1}])", "/lights/0/shadow"},
      {R"("lights": [{"animation": "sway"}])", "/lights/0/animation"},
      {R"("lights": [{"animation": {"kind": "dance"}}])", "/lights/0/animation/kind"},
      {R"("camera": [])", "/camera"},
      {R"("camera": {"position": [0, 0, 0]})", "/camera/position must differ"},
      {R"("camera": {"up": [0, 0, 0]})", "/camera/up has no direction"},
      {R"("camera": {"up": [0, 0, 2]})", "/camera/up is parallel"},
      {R"("camera": {"vertical_fov_degrees": 180})", "/camera/vertical_fov_degrees"},
      {R"("camera": {"orthographic_height": 0})", "/camera/orthographic_height"},
      {R"("view": "ACES")", "/view"},
      {R"("view": {"transform": 1})", "/view/transform"},
      {R"("name": [])", "/name"},
  };
  for (const auto& [text, place] : bad) EXPECT_THAT(refusal(text), HasSubstr("look.dermis: " + place));
}

TEST(SceneIo, SixteenLightsAndNoMore) {
  const auto lights = [](int count) {
    std::string text = R"("lights": [{})";
    for (int i = 1; i < count; ++i) text += ",{}";
    return text + "]";
  };
  Warnings warnings;
  EXPECT_EQ(read(lights(16), warnings).lights.size(), 16U);
  EXPECT_THAT(refusal(lights(17)), HasSubstr("/lights has 17 lights; at most 16"));
}

TEST(SceneIo, UnknownKeysAreKeptAndReported) {
  Warnings warnings;
  const Scene scene = read(R"("weather": "rain", "model": {"builtin": "sphere", "lod": 2}, "lights": [{"gobo": "x"}],
    "environment": {"blur": 1}, "camera": {"shutter": 1}, "view": {"lut": "a"})",
                           warnings);
  for (const char* place :
       {"/weather", "/model/lod", "/lights/0/gobo", "/environment/blur", "/camera/shutter", "/view/lut"})
    EXPECT_THAT(warnings, Contains(HasSubstr(std::string("look.dermis: ") + place + " is not known"))) << place;
  const Json json = parseJson(writeScene(scene, "/scenes"), "a").value();
  EXPECT_EQ(json.at("weather"), "rain");
  EXPECT_EQ(json.at("model").at("lod"), 2);
  EXPECT_EQ(json.at("lights").at(0).at("gobo"), "x");
  EXPECT_EQ(json.at("view").at("lut"), "a");
  EXPECT_EQ(json.at("camera").at("shutter"), 1);
}

TEST(SceneIo, ValuesOutsideTheirRangeAreClampedWithAWarning) {
  Warnings warnings;
  const Scene scene = read(
      R"("lights": [{"intensity": -1, "color": 2, "inner_degrees": 50, "outer_degrees": 40}], "view": {"exposure_stops": 99})",
      warnings);
  EXPECT_EQ(scene.lights[0].intensity, 0.0F);
  EXPECT_EQ(scene.lights[0].color, glm::vec3(2.0F));
  EXPECT_EQ(scene.lights[0].innerDegrees, 40.0F);
  EXPECT_EQ(scene.view.exposureStops, 32.0F);
  EXPECT_THAT(warnings, Contains(HasSubstr("/lights/0/intensity is clamped")));
  EXPECT_THAT(warnings, Contains(HasSubstr("/lights/0/inner_degrees is clamped")));
}

TEST(SceneIo, FormatAndVersionAreChecked) {
  Warnings warnings;
  const auto message = [&](std::string_view text) { return readScene(text, "a.dermis", "", warnings).error().message; };
  EXPECT_THAT(message(R"({"format": "dermis.scene", "version": 999})"), HasSubstr("/version is 999"));
  EXPECT_THAT(message(R"({"format": "dermis.scene"})"), HasSubstr("/version is missing"));
  EXPECT_THAT(message(R"({"format": "dermis.material", "version": 1})"), HasSubstr("/format"));
  EXPECT_THAT(message(R"([1])"), HasSubstr("must be an object"));
  EXPECT_THAT(message(R"({"format": "dermis.scene", "version": 1,)"),
              HasSubstr("a.dermis is not valid JSON at line 1"));
}

TEST(CameraJson, GoesThroughJsonAndRefusesWhatItDoesNotKnow) {
  Camera camera{{1, 2, 3}, {0.1F, 0, 0}, {0, 0, 1}, 26.0F, {}};
  EXPECT_EQ(cameraFromJson(cameraToJson(camera), "", {}).value(), camera);
  camera.orthographicHeight = 0.3F;
  EXPECT_EQ(cameraFromJson(cameraToJson(camera), "", {}).value(), camera);
  EXPECT_THAT(cameraFromJson({{"fov", 3}}, "", {}).error().message, HasSubstr("/fov is no key of a camera"));
}

}  // namespace
}  // namespace dermis
