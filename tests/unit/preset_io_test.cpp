#include "core/material/preset_io.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/material/builtin_presets.h"
#include "core/material/parameter_table.h"
#include "unit/parameter_samples.h"
#include "unit/temporary_folder.h"

namespace dermis {
namespace {

using test::contentOf;
using test::isOneSentence;
using test::otherValue;
using test::TemporaryFolder;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
namespace fs = std::filesystem;

Material read(std::string_view text, Warnings& warnings, const fs::path& folder = "/presets") {
  auto material = readPreset(text, "fair.json", folder, warnings);
  EXPECT_TRUE(material.has_value()) << material.error().message;
  return material ? *material : Material();
}

std::string refusal(std::string_view text) {
  Warnings warnings;
  const auto material = readPreset(text, "fair.json", "/presets", warnings);
  EXPECT_FALSE(material.has_value()) << text;
  if (material) return {};
  EXPECT_EQ(material.error().kind, Error::Kind::Input);
  EXPECT_TRUE(isOneSentence(material.error().message));
  return material.error().message;
}

std::string preset(std::string_view rest) {
  return R"({"format": "dermis.material", "version": 1, )" + std::string(rest) + "}";
}

/// A material of a model in which everything differs from the defaults.
Material everythingChanged(ShadingModel model) {
  Material material;
  material.name = "Fair, \"freckled\" ü";
  material.model = model;
  for (const ParameterRow& row : parameterTable()) {
    if (row.usedBy(model))
      row.set(material.parameters, otherValue(row));
    else if (row.map)  // absent from the file, and so 1 beside its map
      row.set(material.parameters, row.type == ParameterType::Colour ? ParameterValue(Colour{glm::vec3(1.0F)}) : 1.0F);
  }
  int i = 0;
  for (TextureBinding& binding : material.textures) {
    binding.path = "/presets/maps/" + std::to_string(i) + ".png";
    if (i % 2 == 0) binding.colorSpace = "srgb";
    binding.channel = static_cast<TextureChannel>(i % 5);
    binding.invert = i % 3 == 0;
    binding.flipGreen = i % 3 == 1;
    binding.scale = 0.1F * static_cast<float>(i);
    binding.uvScale = {2.0F, 0.3F};
    ++i;
  }
  material.texture(TextureSlot::Emissive).path = "embedded:3";
  material.metadata = {{"author", "somebody"}, {"notes", "none"}, {"created_with", "dermis 0.0.1"}, {"more", 1}};
  material.unknown = {{"future", {{"x", Json::array({1, 2})}}}};
  material.unknownParameters = {{"skin.freckles", 0.5}};
  material.unknownTextures = {{"albedo", {{"wrap", "clamp"}}}, {"hair", {{"path", "hair.png"}}}};
  return material;
}

TEST(PresetIo, EverythingGoesThroughTheFileForEveryModel) {
  for (const ShadingModelRow& model : shadingModels()) {
    const Material material = everythingChanged(model.model);
    const std::string text = writePreset(material, "/presets");
    Warnings warnings;
    EXPECT_EQ(read(text, warnings), material) << text;
    EXPECT_EQ(writePreset(read(text, warnings), "/presets"), text);
  }
}

TEST(PresetIo, WritesEveryParameterOfItsModelInTableOrder) {
  for (const ShadingModelRow& model : shadingModels()) {
    Material material;
    material.model = model.model;
    const Json json = parseJson(writePreset(material, ""), "a.json").value();
    std::vector<std::string> expected;
    for (const ParameterRow& row : parameterTable())
      if (row.usedBy(model.model)) expected.emplace_back(row.id);
    std::vector<std::string> written;
    for (const auto& [id, value] : json.at("parameters").items()) written.push_back(id);
    EXPECT_EQ(written, expected) << model.id;
  }
}

TEST(PresetIo, SavedLoadedSavedIsByteIdentical) {
  const TemporaryFolder folder;
  Material material = everythingChanged(ShadingModel::Skin);
  material.texture(TextureSlot::Albedo).path = folder / "maps/a.png";
  ASSERT_TRUE(savePreset(folder / "a.json", material).has_value());
  Warnings warnings;
  const auto loaded = loadPreset(folder / "a.json", warnings);
  ASSERT_TRUE(loaded.has_value());
  EXPECT_EQ(*loaded, material);
  ASSERT_TRUE(savePreset(folder / "b.json", *loaded).has_value());
  EXPECT_EQ(contentOf(folder / "a.json"), contentOf(folder / "b.json"));
}

TEST(PresetIo, TexturePathsAreRelativeToThePresetWhereTheyCanBe) {
  const auto written = [](const std::string& path) {
    Material material;
    material.texture(TextureSlot::Albedo).path = path;
    const Json json = parseJson(writePreset(material, "/looks/presets"), "a.json").value();
    return json.at("textures").at("albedo").at("path").get<std::string>();
  };
  EXPECT_EQ(written("/looks/presets/maps/a.png"), "maps/a.png");
  EXPECT_EQ(written("/looks/maps/a.png"), "../maps/a.png");
  EXPECT_EQ(written("/mnt/a.png"), "/mnt/a.png");
  EXPECT_EQ(written("embedded:3"), "embedded:3");

  Warnings warnings;
  const auto albedo = [&](std::string_view path) {
    const std::string text = preset(R"("textures": {"albedo": {"path": ")" + std::string(path) + R"("}})");
    return read(text, warnings, "/looks/presets").texture(TextureSlot::Albedo).path;
  };
  EXPECT_EQ(albedo("maps/a.png"), "/looks/presets/maps/a.png");
  EXPECT_EQ(albedo("../maps/a.png"), "/looks/maps/a.png");
  EXPECT_EQ(albedo("/mnt/a.png"), "/mnt/a.png");
  EXPECT_EQ(albedo("embedded:3"), "embedded:3");
}

TEST(PresetIo, MissingParametersTakeTheirDefaultsAndAreReported) {
  Warnings warnings;
  const Material material = read(preset(R"("model": "skin", "parameters": {"specular.ior": 1.5})"), warnings);
  MaterialParameters expected;
  expected.specularIor = 1.5F;
  EXPECT_EQ(material.parameters, expected);
  EXPECT_THAT(warnings, ElementsAre(HasSubstr("fair.json: /parameters lacks base.albedo, base.metallic, specular.f0")));
}

TEST(PresetIo, AnInlinePresetMayLeaveOutWhatItLikes) {
  Warnings warnings;
  JsonReport report{"a.dermis", warnings};
  const Material material =
      readMaterial(Json{{"parameters", {{"specular.ior", 1.5}}}}, "/materials/face", PresetPlace::Inline, "", report);
  EXPECT_EQ(material.parameters.specularIor, 1.5F);
  EXPECT_FALSE(report.error.has_value());
  EXPECT_THAT(warnings, IsEmpty());
}

TEST(PresetIo, AnAbsentFactorCountsAsOneBesideItsMap) {
  Warnings warnings;
  const Material material = read(preset(R"("model": "skin", "parameters": {"specular.perceptual_roughness": 0.25},
    "textures": {"albedo": {"path": "a.png"}, "roughness": {"path": "r.png"}, "specular": {"path": "s.png"}})"),
                                 warnings);
  EXPECT_EQ(material.parameters.baseAlbedo, Colour{glm::vec3(1.0F)});
  EXPECT_EQ(material.parameters.specularPerceptualRoughness, 0.25F);
  EXPECT_EQ(material.parameters.specularIntensity, 1.0F);
  EXPECT_EQ(material.parameters.baseMetallic, 0.0F);
  EXPECT_THAT(warnings, Contains(HasSubstr("lacks base.albedo, specular.intensity, which count as 1")));
}

TEST(PresetIo, F0WinsOverTheIorWhateverTheirOrder) {
  Warnings warnings;
  const Material material =
      read(preset(R"("parameters": {"specular.f0": [1, 0.71, 0.29], "specular.ior": 1.5})"), warnings);
  EXPECT_EQ(material.parameters.specularF0, OptionalColour(Colour{{1.0F, 0.71F, 0.29F}}));
  EXPECT_EQ(material.parameters.specularIor, 1.5F);
}

TEST(PresetIo, UnknownKeysAreKeptAndReported) {
  Warnings warnings;
  const Material material = read(preset(R"("model": "skin", "mood": "calm", "parameters": {"skin.freckles": [1, 2]},
    "textures": {"hair": {"path": "h.png"}, "albedo": {"path": "a.png", "wrap": "clamp"}})"),
                                 warnings);
  for (const char* place : {"/mood", "/parameters/skin.freckles", "/textures/hair", "/textures/albedo/wrap"})
    EXPECT_THAT(warnings, Contains(HasSubstr(std::string("fair.json: ") + place + " is not known"))) << place;
  const Json json = parseJson(writePreset(material, "/presets"), "a.json").value();
  EXPECT_EQ(json.at("mood"), "calm");
  EXPECT_EQ(json.at("parameters").at("skin.freckles"), Json::array({1, 2}));
  EXPECT_EQ(json.at("textures").at("hair").at("path"), "h.png");
  EXPECT_EQ(json.at("textures").at("albedo").at("wrap"), "clamp");
}

TEST(PresetIo, ParametersOfAnotherModelSurvive) {
  Warnings warnings;
  Material material = read(preset(R"("model": "lens", "parameters": {"specular.ior": 1.5})"), warnings);
  EXPECT_EQ(material.parameters.specularIor, 1.5F);
  EXPECT_THAT(warnings, Contains(HasSubstr("/parameters/specular.ior is not used by the model lens")));
  Json json = parseJson(writePreset(material, ""), "a.json").value();
  EXPECT_EQ(json.at("parameters").at("specular.ior"), 1.5);
  // Switched to a model that uses it, it stands in the file once, with its present value.
  material.model = ShadingModel::Skin;
  material.parameters.specularIor = 1.25F;
  json = parseJson(writePreset(material, ""), "a.json").value();
  EXPECT_EQ(json.at("parameters").at("specular.ior"), 1.25);
}

TEST(PresetIo, OutsideTheHardRangeIsClampedWithAWarning) {
  Warnings warnings;
  const Material material =
      read(preset(R"("model": "lens", "parameters": {"lens.opacity": 7, "lens.seed_blending": false})"), warnings);
  EXPECT_EQ(material.parameters.lensOpacity, 1.0F);
  EXPECT_THAT(warnings,
              ElementsAre("fair.json: /parameters/lens.opacity is 7 and is clamped to 1; its range is 0 to 1"));
}

TEST(PresetIo, WrongTypesNameTheirPlace) {
  EXPECT_EQ(refusal(preset(R"("parameters": {"specular.perceptual_roughness": "shiny"})")),
            "fair.json: /parameters/specular.perceptual_roughness must be a number, not a string");
  EXPECT_THAT(refusal("[]"), HasSubstr("must be an object, not an array"));
  EXPECT_THAT(refusal("3"), HasSubstr("must be an object, not a number"));
  EXPECT_THAT(refusal("null"), HasSubstr("must be an object"));
  const std::vector<std::pair<std::string, std::string>> bad = {
      {R"("name": 3)", "/name"},
      {R"("model": 3)", "/model"},
      {R"("model": "clay")", "/model must be skin, thesis"},
      {R"("parameters": [])", "/parameters"},
      {R"("parameters": {"subsurface.radius_mm": [1, 2]})", "/parameters/subsurface.radius_mm"},
      {R"("parameters": {"subsurface.radius_mm": [1, 2, "3"]})", "/parameters/subsurface.radius_mm/2"},
      {R"("parameters": {"subsurface.gaussians": [[1, 2, 3]]})", "/parameters/subsurface.gaussians/0"},
      {R"("model": "thesis", "parameters": {"specular.ior": "x"})", "/parameters/specular.ior"},
      {R"("textures": [])", "/textures"},
      {R"("textures": {"albedo": "a.png"})", "/textures/albedo must be an object"},
      {R"("textures": {"albedo": {}})", "/textures/albedo/path is missing"},
      {R"("textures": {"albedo": {"path": ""}})", "/textures/albedo/path"},
      {R"("textures": {"albedo": {"path": "embedded:"}})", "/textures/albedo/path must name a file"},
      {R"("textures": {"albedo": {"path": "embedded:-1"}})", "/textures/albedo/path must name a file"},
      {R"("textures": {"albedo": {"path": "builtin:x"}})", "/textures/albedo/path must name a file"},
      {R"("textures": {"albedo": {"path": "a", "channel": "x"}})", "/textures/albedo/channel"},
      {R"("textures": {"albedo": {"path": "a", "invert": 1}})", "/textures/albedo/invert"},
      {R"("textures": {"albedo": {"path": "a", "uv_scale": 2}})", "/textures/albedo/uv_scale"},
      {R"("metadata": "me")", "/metadata"},
      {R"("metadata": {"author": 1})", "/metadata/author"},
  };
  for (const auto& [text, place] : bad) EXPECT_THAT(refusal(preset(text)), HasSubstr("fair.json: " + place));
}

TEST(PresetIo, FormatAndVersionAreChecked) {
  EXPECT_THAT(refusal("{}"), HasSubstr("/format is missing"));
  EXPECT_THAT(refusal(R"({"format": "dermis.scene", "version": 1})"), HasSubstr("not \"dermis.scene\""));
  EXPECT_THAT(refusal(R"({"format": 1, "version": 1})"), HasSubstr("/format"));
  EXPECT_THAT(refusal(R"({"format": "dermis.material"})"), HasSubstr("/version is missing"));
  EXPECT_THAT(refusal(R"({"format": "dermis.material", "version": 2})"), HasSubstr("/version is 2, a format from the"));
  EXPECT_THAT(refusal(R"({"format": "dermis.material", "version": 1e30})"), HasSubstr("future"));
  EXPECT_THAT(refusal(R"({"format": "dermis.material", "version": 0})"), HasSubstr("/version must be 1"));
  EXPECT_THAT(refusal(R"({"format": "dermis.material", "version": "1"})"), HasSubstr("not a string"));
}

TEST(PresetIo, AWarningOfAFileThatIsRefusedIsNotShown) {
  Warnings warnings;
  EXPECT_FALSE(readPreset(preset(R"("mood": 1, "name": 2)"), "a.json", "", warnings).has_value());
  EXPECT_THAT(warnings, IsEmpty());
}

TEST(PresetIo, FilesThatCannotBeReadOrWritten) {
  const TemporaryFolder folder;
  Warnings warnings;
  EXPECT_THAT(loadPreset(folder / "none.json", warnings).error().message, HasSubstr("none.json"));
  EXPECT_EQ(loadPreset(folder.path(), warnings).error().kind, Error::Kind::Input);
  EXPECT_EQ(savePreset(folder / "no/a.json", {}).error().kind, Error::Kind::Runtime);
  EXPECT_THAT(loadPreset("builtin:none", warnings).error().message, HasSubstr("builtin:none"));
}

TEST(PresetIo, AFileNameThatJsonCannotHoldIsRefusedRatherThanChanged) {
  const TemporaryFolder folder;
  Material material;
  material.texture(TextureSlot::Albedo).path = folder / "a\xff.png";
  const auto saved = savePreset(folder / "a.json", material);
  ASSERT_FALSE(saved.has_value());
  EXPECT_THAT(saved.error().message, HasSubstr("not UTF-8"));
  EXPECT_EQ(folder.fileCount(), 0U);
}

// ---- what the program carries

TEST(BuiltinPresets, AreAsTheProgramWouldWriteThem) {
  EXPECT_EQ(builtinPresets().size(), 42U);
  for (const BuiltinPreset& builtin : builtinPresets()) {
    Warnings warnings;
    const auto material = loadPreset("builtin:" + builtin.id, warnings);
    ASSERT_TRUE(material.has_value()) << material.error().message;
    EXPECT_THAT(warnings, IsEmpty()) << builtin.id;
    EXPECT_EQ(material->name, builtin.name);
    EXPECT_THAT(builtin.name, Not(IsEmpty()));
    EXPECT_EQ(writePreset(*material, ""),
              contentOf(fs::path(DERMIS_SOURCE_DIR) / "resources/presets" / (builtin.id + ".json")));
  }
}

glm::dvec3 xyzOf(double x, double y) { return {x / y, 1.0, (1.0 - x - y) / y}; }

/// RGB of these primaries and white to CIE XYZ (SMPTE RP 177-1993, section 3.3).
glm::dmat3 rgbToXyz(const glm::dvec2& r, const glm::dvec2& g, const glm::dvec2& b, const glm::dvec2& white) {
  const glm::dmat3 primaries(xyzOf(r.x, r.y), xyzOf(g.x, g.y), xyzOf(b.x, b.y));
  const glm::dvec3 scale = glm::inverse(primaries) * xyzOf(white.x, white.y);
  return {primaries[0] * scale.x, primaries[1] * scale.y, primaries[2] * scale.z};
}

/// The skin tones' colours: ACEScg (AP1, ACES white) to linear Rec.709 (D65) with Bradford adaptation.
TEST(BuiltinPresets, SkinTonesAreTheConvertedOpenPbrColours) {
  const glm::dvec2 acesWhite(0.32168, 0.33767);
  const glm::dvec2 d65(0.3127, 0.3290);
  const glm::dmat3 bradford =
      glm::transpose(glm::dmat3(0.8951, 0.2664, -0.1614, -0.7502, 1.7135, 0.0367, 0.0389, -0.0685, 1.0296));
  const glm::dvec3 from = bradford * xyzOf(acesWhite.x, acesWhite.y);
  const glm::dvec3 to = bradford * xyzOf(d65.x, d65.y);
  glm::dmat3 adapt(0.0);
  for (int i = 0; i < 3; ++i) adapt[i][i] = to[i] / from[i];
  const glm::dmat3 matrix = glm::inverse(rgbToXyz({0.64, 0.33}, {0.30, 0.60}, {0.15, 0.06}, d65)) *
                            glm::inverse(bradford) * adapt * bradford *
                            rgbToXyz({0.713, 0.293}, {0.165, 0.830}, {0.128, 0.044}, acesWhite);
  EXPECT_NEAR(matrix[0][0], 1.70505, 1e-5);

  const std::vector<std::pair<std::string, glm::dvec3>> tones = {
      {"i", {0.762, 0.652, 0.568}},  {"ii", {0.671, 0.505, 0.371}}, {"iii", {0.545, 0.445, 0.359}},
      {"iv", {0.351, 0.240, 0.148}}, {"v", {0.227, 0.157, 0.091}},  {"vi", {0.073, 0.052, 0.025}}};
  for (std::size_t t = 0; t < tones.size(); ++t) {
    Warnings warnings;
    const Material material = loadBuiltinPreset("skin_tone_" + tones[t].first, warnings).value();
    const glm::dvec3 expected = matrix * tones[t].second;
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(material.parameters.baseAlbedo.rgb[i], expected[i], 5.1e-5);
    EXPECT_EQ(material.parameters.specularIor, 1.4F);
    EXPECT_EQ(material.parameters.specularPerceptualRoughness, 0.5F);
    EXPECT_THAT(material.metadata.at("notes").get<std::string>(), HasSubstr("1.70505 -0.62179 -0.08326"));
  }
}

}  // namespace
}  // namespace dermis
