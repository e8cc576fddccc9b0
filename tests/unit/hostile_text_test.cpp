// Broken presets and scenes: each is read or refused with one sentence, never more.
#include <gtest/gtest.h>

#include <random>

#include "core/base/json_text.h"
#include "core/material/parameter_table.h"
#include "core/material/preset_io.h"
#include "core/scene/scene_io.h"
#include "unit/temporary_folder.h"
#include "unit/thread_time.h"

namespace dermis {
namespace {

using test::isOneSentence;
using test::threadSeconds;

std::string presetText() {
  Material material;
  material.name = "Sample ü";
  material.texture(TextureSlot::Albedo) = {"/p/a.png", "srgb", TextureChannel::G, true, true, 0.5F, {2.0F, 3.0F}};
  material.metadata = {{"author", "x"}};
  return writePreset(material, "/p");
}

std::string sceneText() {
  Scene scene;
  scene.materials["face"].material.model = ShadingModel::Lens;
  scene.materials["*"].presetPath = "builtin:skin_tone_iii";
  scene.environment.background = {BackgroundKind::Prefiltered, 0.4F, glm::vec3(0.0F)};
  scene.lights.resize(3);
  scene.lights[1].type = LightType::Spot;
  scene.lights[2].animation.kind = AnimationKind::Sway;
  scene.camera = Camera{};
  scene.camera->orthographicHeight = 2.0F;
  return writeScene(scene, "/p");
}

/// Reads a text both ways; what is accepted must be writable and stable from then on.
void readAsPreset(const std::string& text) {
  Warnings warnings;
  const auto material = readPreset(text, "a.json", "/p", warnings);
  if (!material) {
    EXPECT_EQ(material.error().kind, Error::Kind::Input);
    EXPECT_TRUE(isOneSentence(material.error().message)) << material.error().message;
    EXPECT_TRUE(isUtf8(material.error().message));
    return;
  }
  for (const std::string& warning : warnings) EXPECT_EQ(warning.find('\n'), std::string::npos) << warning;
  for (const ParameterRow& row : parameterTable()) {
    bool clamped = false;
    static_cast<void>(clampToHardRange(row, row.get(material->parameters), &clamped));
    EXPECT_FALSE(clamped) << row.id;
  }
  const std::string once = writePreset(*material, "/p");
  const auto again = readPreset(once, "a.json", "/p", warnings);
  ASSERT_TRUE(again.has_value()) << again.error().message;
  EXPECT_EQ(writePreset(*again, "/p"), once);
}

void readAsScene(const std::string& text) {
  Warnings warnings;
  const auto scene = readScene(text, "a.dermis", "/p", warnings);
  if (!scene) {
    EXPECT_EQ(scene.error().kind, Error::Kind::Input);
    EXPECT_TRUE(isOneSentence(scene.error().message)) << scene.error().message;
    EXPECT_TRUE(isUtf8(scene.error().message));
    return;
  }
  const std::string once = writeScene(*scene, "/p");
  const auto again = readScene(once, "a.dermis", "/p", warnings);
  ASSERT_TRUE(again.has_value()) << again.error().message << once;
  EXPECT_EQ(writeScene(*again, "/p"), once);
}

TEST(HostileText, TruncatedAtEveryByte) {
  const std::string preset = presetText();
  for (std::size_t length = 0; length + 2 < preset.size(); ++length) {
    Warnings warnings;
    const auto material = readPreset(preset.substr(0, length), "a.json", "/p", warnings);
    ASSERT_FALSE(material.has_value()) << length;
    ASSERT_TRUE(isOneSentence(material.error().message));
  }
  const std::string scene = sceneText();
  for (std::size_t length = 0; length + 2 < scene.size(); ++length) {
    Warnings warnings;
    const auto read = readScene(scene.substr(0, length), "a.dermis", "/p", warnings);
    ASSERT_FALSE(read.has_value()) << length;
    ASSERT_TRUE(isOneSentence(read.error().message));
  }
}

/// Bytes changed, removed, doubled; words of JSON put in; pieces swapped.
std::string mutated(std::string text, std::mt19937& random) {
  static const std::vector<std::string> kPieces = {"null",
                                                   "true",
                                                   "[]",
                                                   "{}",
                                                   "-1",
                                                   "1e999",
                                                   "1e38",
                                                   "-1e38",
                                                   "1e-320",
                                                   "NaN",
                                                   "\"\"",
                                                   "\"x\"",
                                                   "[0,0,0]",
                                                   "\xff",
                                                   std::string(1, '\0'),
                                                   ",",
                                                   ":",
                                                   "\"",
                                                   "0.5",
                                                   "99",
                                                   "[[1,2,3,4]]",
                                                   "\\u0000",
                                                   "\"builtin:\"",
                                                   "\"embedded:9\""};
  const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random() % std::max<std::size_t>(n, 1)); };
  // The end of the value that starts at a byte, roughly: enough to swap whole values now and then.
  const auto valueAfter = [&](std::size_t from) {
    const std::size_t colon = text.find(": ", from);
    if (colon == std::string::npos) return std::pair<std::size_t, std::size_t>{0, 0};
    const std::size_t start = colon + 2;
    return std::pair{start, text.find_first_of(text[start] == '[' ? "]" : ",\n}", start) - start};
  };
  for (std::size_t count = 1 + below(3); count > 0; --count) {
    const std::size_t at = below(text.size());
    switch (below(5)) {
      case 0:
        text[at] = static_cast<char>(random());
        break;
      case 1:
        text.erase(at, 1 + below(20));
        break;
      case 2:
        text.insert(at, kPieces[below(kPieces.size())]);
        break;
      case 3:
        text.insert(at, text.substr(below(text.size()), below(60)));
        break;
      default: {
        const auto [start, length] = valueAfter(at);
        if (length > 0 && length < text.size()) text.replace(start, length, kPieces[below(kPieces.size())]);
      }
    }
    if (text.empty()) text = " ";
  }
  return text;
}

TEST(HostileText, AThousandMutationsOfAPreset) {
  std::mt19937 random(20240);
  const std::string text = presetText();
  for (int i = 0; i < 1000; ++i) readAsPreset(mutated(text, random));
}

TEST(HostileText, AThousandMutationsOfAScene) {
  std::mt19937 random(20241);
  const std::string text = sceneText();
  for (int i = 0; i < 1000; ++i) readAsScene(mutated(text, random));
}

/// Seconds to read and write a preset of unknown parameters and to read a scene of slots.
double secondsOfUnknownThings(int parameterCount, int slotCount) {
  std::string parameters = R"({"format": "dermis.material", "version": 1, "parameters": {"a": 0)";
  std::string slots = R"({"format": "dermis.scene", "version": 1, "materials": {"a": {})";
  for (int i = 0; i < parameterCount; ++i) parameters += ",\"p" + std::to_string(i) + "\":0";
  for (int i = 0; i < slotCount; ++i) slots += ",\"s" + std::to_string(i) + "\":{}";
  return threadSeconds([&] {
    Warnings warnings;
    const auto material = readPreset(parameters + "}}", "a.json", "", warnings);
    ASSERT_TRUE(material.has_value());
    EXPECT_LT(warnings.size(), 50U);
    EXPECT_GT(writePreset(*material, "").size(), 10U * static_cast<std::size_t>(parameterCount));
    EXPECT_EQ(readScene(slots + "}}", "a.dermis", "", warnings).value().materials.size(),
              static_cast<std::size_t>(slotCount) + 1);
  });
}

TEST(HostileText, LargeFilesOfUnknownThingsTakeNoQuadraticTime) {
  // 64 times as much of both: 64 to 200 times the time, whatever else the machine does, or 4,096 were it quadratic.
  const double few = secondsOfUnknownThings(2'000, 60);
  EXPECT_LT(secondsOfUnknownThings(128'000, 3'840), 800.0 * few);
}

}  // namespace
}  // namespace dermis
