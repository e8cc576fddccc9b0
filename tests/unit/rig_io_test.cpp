// The light rig format: strict, kept whole, the same for validators and documentation.
#include "core/light_rig/rig_io.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/io/asset_loader.h"
#include "core/light_rig/rig_fields.h"
#include "unit/temporary_folder.h"

namespace dermis {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr std::string_view kHead = R"({"format": "dermis.rig", "version": 1, "elements": [)";

std::string errorOf(const std::string& text) {
  Warnings warnings;
  const auto rig = readRig(text, "r.json", warnings);
  return rig ? "" : rig.error().message;
}
std::string errorOfElement(const std::string& element) { return errorOf(std::string(kHead) + element + "]}"); }

// To write them anew: `dermis parameters --rigs --schema > resources/schema/dermis.rig.schema.json`; the tables are
// `dermis parameters --rigs --markdown`.
TEST(RigIo, TheCommittedSchemaAndTablesAreTheProgramsOwn) {
  const std::string source = DERMIS_SOURCE_DIR;
  EXPECT_EQ(test::contentOf(source + "/resources/schema/dermis.rig.schema.json"), rigsAsJsonSchema());
  EXPECT_THAT(test::contentOf(source + "/docs/rigs.md"), HasSubstr(rigsAsMarkdown()));
}

TEST(RigIo, ErrorsNameThePlace) {
  EXPECT_THAT(errorOf("{"), HasSubstr("r.json"));
  EXPECT_THAT(errorOf(R"({"version": 1, "elements": []})"), HasSubstr("/format is missing"));
  EXPECT_THAT(errorOf(R"({"format": "dermis.scene", "version": 1, "elements": []})"), HasSubstr("/format must be"));
  EXPECT_THAT(errorOf(R"({"format": "dermis.rig", "version": 2, "elements": []})"), HasSubstr("from the future"));
  EXPECT_THAT(errorOf(R"({"format": "dermis.rig", "version": 1})"), HasSubstr("/elements is missing"));
  EXPECT_THAT(errorOf(R"({"format": "dermis.rig", "version": 1, "elements": {}})"),
              HasSubstr("/elements must be an array"));
  EXPECT_THAT(errorOfElement("3"), HasSubstr("/elements/0 must be an object"));
  EXPECT_THAT(errorOfElement("{}"), HasSubstr("/elements/0/type is missing"));
  EXPECT_THAT(errorOfElement(R"({"type": "torch"})"), HasSubstr("/elements/0/type must be softbox, strip"));
  EXPECT_THAT(errorOfElement(R"({"type": "disc"}, {"type": "ring", "diameter_m": "big"})"),
              HasSubstr("/elements/1/diameter_m must be a number, not a string"));
  EXPECT_THAT(errorOfElement(R"({"type": "softbox", "size_m": [1, 2, 3]})"), HasSubstr("/elements/0/size_m"));
  EXPECT_THAT(errorOfElement(R"({"type": "disc", "radiance": 1, "illuminance_lux": 3})"),
              HasSubstr("says the same thing as radiance"));
  EXPECT_THAT(errorOfElement(R"({"type": "softbox", "size_m": [1, 1], "size_degrees": [3, 3]})"),
              HasSubstr("/elements/0/size_degrees says the same thing as size_m"));
  EXPECT_THAT(errorOfElement(R"({"type": "disc", "distance_m": 1, "aim_m": [0, 0, 1]})"),
              HasSubstr("/elements/0/aim_m is the element's own place"));
  std::string many = std::string(kHead) + R"({"type": "dome"})";
  for (std::size_t i = 0; i < kMaxRigElements; ++i) many += R"(,{"type": "dome"})";
  EXPECT_THAT(errorOf(many + "]}"), HasSubstr("at most 256"));
}

TEST(RigIo, WhatIsNotKnownIsKeptAndReportedAndWhatIsTooLargeIsClamped) {
  Warnings warnings;
  const auto rig = readRig(std::string(kHead) +
                               R"({"type": "disc", "barn_doors": [1, 2], "turbidity": 3, "elevation_degrees": 100}],
                                   "mood": "calm"})",
                           "r.json", warnings);
  ASSERT_TRUE(rig) << rig.error().message;
  EXPECT_THAT(warnings, ElementsAre(HasSubstr("/elements/0/elevation_degrees is clamped"), HasSubstr("barn_doors"),
                                    HasSubstr("/elements/0/turbidity"), HasSubstr("/mood")));
  EXPECT_EQ(rig->elements[0].elevationDegrees, 90.0F);
  const std::string written = writeRig(*rig);
  for (const char* kept : {"barn_doors", "turbidity", "mood"}) EXPECT_THAT(written, HasSubstr(kept));
}

TEST(RigIo, EveryKeySurvivesSavingAndLoading) {
  // One element of each type with every key that it uses away from its default.
  LightRig rig;
  rig.name = "All";
  rig.description = "One of each";
  rig.whiteLuminance = 123.5F;
  rig.width = 256;
  rig.metadata = {{"author", "somebody"}};
  for (std::size_t type = 0; type < rigTypes().size(); ++type) {
    RigElement element;
    element.type = static_cast<RigElementType>(type);
    element.name = "Element " + std::to_string(type);
    element.enabled = type % 2 == 0;
    std::array<bool, 4> taken{};
    for (const RigField& field : rigFields()) {
      if (!field.usedBy(element.type)) continue;
      bool& group = taken.at(static_cast<std::size_t>(field.group));
      if (field.group != RigGroup::None && std::exchange(group, true)) continue;
      const float inside = std::min(0.5F * (std::max(field.range.lowest, 0.0F) + std::min(field.range.highest, 8.0F)),
                                    field.range.highest);
      const float value = inside < field.range.lowest ? field.range.lowest
                          : inside > 2.0F             ? std::floor(inside)
                                                      : inside;
      std::visit(
          [&](auto member) {
            auto& target = element.*member;
            using Target = std::remove_cvref_t<decltype(target)>;
            if constexpr (std::is_same_v<Target, bool>)
              target = !target;
            else if constexpr (requires { target.has_value(); })
              target = typename Target::value_type(value);
            else
              target = Target(value);
          },
          field.member);
    }
    rig.elements.push_back(element);
  }
  Warnings warnings;
  const auto again = readRig(writeRig(rig), "r.json", warnings);
  ASSERT_TRUE(again) << again.error().message;
  EXPECT_TRUE(warnings.empty()) << warnings.front();
  EXPECT_EQ(writeRig(*again), writeRig(rig));
  EXPECT_TRUE(*again == rig);
}

TEST(RigIo, ScenesTakeRigFilesAndSeeThatTheyChange) {
  const test::TemporaryFolder folder;
  const auto path = folder.path() / "mine.json";
  LightRig rig;
  rig.width = 64;
  rig.elements.emplace_back().type = RigElementType::Dome;
  ASSERT_TRUE(saveRig(path, rig));
  EXPECT_TRUE(isRigFile(path));
  EnvironmentSource source;
  source.builtin.clear();
  source.path = "mine.json";
  ResolveOptions options;
  options.cache = std::make_shared<AssetCache>();
  Warnings warnings;
  const auto first = resolveEnvironment(source, folder.path(), options, warnings);
  ASSERT_TRUE(first) << first.error().message;
  EXPECT_EQ((*first)->latLong->width, 64);
  EXPECT_EQ((*first)->name, "mine.json");
  EXPECT_EQ(*resolveEnvironment(source, folder.path(), options, warnings), *first) << "taken from the cache";
  rig.elements[0].radiance = 2.0F;
  ASSERT_TRUE(saveRig(path, rig));
  const auto second = resolveEnvironment(source, folder.path(), options, warnings);
  ASSERT_TRUE(second);
  EXPECT_NE((*second)->contentHash, (*first)->contentHash);
  // A preset is no light.
  ASSERT_TRUE(saveJson(path, {{"format", "dermis.material"}, {"version", 1}}));
  EXPECT_FALSE(isRigFile(path));
  const auto preset = resolveEnvironment(source, folder.path(), options, warnings);
  ASSERT_FALSE(preset);
  EXPECT_THAT(preset.error().message, HasSubstr("/format must be \"dermis.rig\""));
}

}  // namespace
}  // namespace dermis
