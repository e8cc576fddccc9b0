#include "core/material/value_json.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "unit/parameter_samples.h"
#include "unit/temporary_folder.h"

namespace dermis {
namespace {

using test::isOneSentence;
using test::otherValue;
using testing::HasSubstr;
using testing::StartsWith;

const ParameterRow& row(std::string_view id) {
  const ParameterRow* found = findParameter(id);
  EXPECT_NE(found, nullptr) << id;
  return *found;
}

TEST(ValueJson, EveryRowGoesThroughJsonAndText) {
  for (const ParameterRow& r : parameterTable()) {
    for (const ParameterValue& value : {r.defaultValue(), otherValue(r)}) {
      Warnings warnings;
      JsonReport report{"a.json", warnings};
      const auto back = readParameterValue(r, parameterToJson(r, value), "/x", report);
      ASSERT_TRUE(back.has_value()) << r.id;
      EXPECT_EQ(*back, value) << r.id;
      EXPECT_FALSE(report.error.has_value()) << r.id;
      const auto typed = parseParameterText(r, parameterToText(r, value));
      ASSERT_TRUE(typed.has_value()) << r.id << " " << parameterToText(r, value);
      EXPECT_EQ(*typed, value) << r.id;
    }
  }
}

TEST(ValueJson, EveryRowRefusesEveryOtherType) {
  const std::vector<Json> all = {nullptr,
                                 true,
                                 0.5,
                                 "word",
                                 Json::object(),
                                 Json::array(),
                                 Json::array({"a", "b", "c"}),
                                 Json::array({1, 2}),
                                 Json::array({1, 2, 3}),
                                 Json::array({1, 2, 3, 4}),
                                 Json::array({Json::array({1, 2, 3})}),
                                 Json::array({1, nullptr, 3})};
  // Which of these each type takes, by index.
  const auto takes = [](ParameterType type) -> std::vector<std::size_t> {
    switch (type) {
      case ParameterType::Float:
        return {2};
      case ParameterType::Vec2:
        return {7};
      case ParameterType::Vec3:
        return {8};
      case ParameterType::Colour:
        return {2, 8};
      case ParameterType::OptionalColour:
        return {0, 2, 8};
      case ParameterType::Enum:
        return {};
      case ParameterType::Bool:
        return {1};
      case ParameterType::Gaussians:
        return {5};
    }
    return {};
  };
  for (const ParameterRow& r : parameterTable()) {
    const auto allowed = takes(r.type);
    for (std::size_t i = 0; i < all.size(); ++i) {
      Warnings warnings;
      JsonReport report{"a.json", warnings};
      const auto value = readParameterValue(r, all[i], "/parameters/" + std::string(r.id), report);
      const bool expected = std::find(allowed.begin(), allowed.end(), i) != allowed.end();
      EXPECT_EQ(value.has_value(), expected) << r.id << " " << all[i];
      EXPECT_EQ(!report.error.has_value(), expected) << r.id << " " << all[i];
      if (!report.error) continue;
      EXPECT_THAT(report.error->message, StartsWith("a.json: /parameters/" + std::string(r.id)));
      EXPECT_TRUE(isOneSentence(report.error->message));
    }
  }
}

TEST(ValueJson, AColourMayBeOneNumber) {
  Warnings warnings;
  JsonReport report{"a.json", warnings};
  EXPECT_EQ(readParameterValue(row("base.albedo"), 0.5, "/x", report), ParameterValue(Colour{glm::vec3(0.5F)}));
}

TEST(ValueJson, NumbersPastTheFloatRangeAreRefused) {
  Warnings warnings;
  JsonReport report{"a.json", warnings};
  EXPECT_FALSE(readParameterValue(row("specular.ior"), 1e39, "/x", report).has_value());
  EXPECT_THAT(report.error->message, HasSubstr("too large"));
}

TEST(ValueJson, MoreGaussiansThanFitAreRefused) {
  Json rows = Json::array();
  for (int i = 0; i < 9; ++i) rows.push_back(Json::array({1, 0, 0, 0}));
  Warnings warnings;
  JsonReport report{"a.json", warnings};
  EXPECT_FALSE(readParameterValue(row("subsurface.gaussians"), rows, "/x", report).has_value());
  EXPECT_THAT(report.error->message, HasSubstr("at most 8"));
}

TEST(ParameterText, TakesWhatTheCommandLineMayGive) {
  EXPECT_EQ(parseParameterText(row("specular.ior"), " 1.4 ").value(), ParameterValue(1.4F));
  EXPECT_EQ(parseParameterText(row("base.albedo"), "0.5").value(), ParameterValue(Colour{glm::vec3(0.5F)}));
  EXPECT_EQ(parseParameterText(row("base.albedo"), "0.9,0.5,0.2").value(),
            ParameterValue(Colour{glm::vec3(0.9F, 0.5F, 0.2F)}));
  EXPECT_EQ(parseParameterText(row("base.albedo"), "[0.9, 0.5, 0.2]").value(),
            ParameterValue(Colour{glm::vec3(0.9F, 0.5F, 0.2F)}));
  EXPECT_EQ(parseParameterText(row("specular.f0"), "null").value(), ParameterValue(OptionalColour()));
  EXPECT_EQ(parseParameterText(row("specular.lobe_scale"), "1,2").value(), ParameterValue(glm::vec2(1, 2)));
  EXPECT_EQ(parseParameterText(row("subsurface.profile"), "gaussians").value(), ParameterValue(EnumValue{1}));
  EXPECT_EQ(parseParameterText(row("lens.seed_blending"), "true").value(), ParameterValue(true));
  const auto table = parseParameterText(row("subsurface.gaussians"), "[[1, 0.5, 0.25, 0]]").value();
  EXPECT_EQ(std::get<GaussianTable>(table).count, 1);
}

TEST(ParameterText, RefusesWithASentenceThatNamesTheParameter) {
  const std::vector<std::pair<std::string_view, std::string_view>> bad = {
      {"specular.ior", "shiny"},       {"specular.ior", ""},         {"specular.ior", "nan"},
      {"specular.ior", "1,2"},         {"specular.ior", "null"},     {"base.albedo", "1,2"},
      {"base.albedo", "[1,2"},         {"base.albedo", "null"},      {"subsurface.profile", "Burley"},
      {"subsurface.profile", "0"},     {"lens.seed_blending", "1"},  {"lens.seed_blending", "yes"},
      {"subsurface.gaussians", "1,2"}, {"specular.lobe_scale", "1"}, {"specular.ior", "1e999"},
      {"subsurface.radius_mm", "1"},   {"specular.ior", "1\n2"},     {"base.albedo", "[[1],[2],[3]]"},
      {"specular.ior", "[1]"},         {"specular.ior", "0,5"},
  };
  for (const auto& [id, text] : bad) {
    const auto value = parseParameterText(row(id), text);
    ASSERT_FALSE(value.has_value()) << id << "=" << text;
    EXPECT_THAT(value.error().message, StartsWith(std::string(id) + " must be "));
    EXPECT_TRUE(isOneSentence(value.error().message)) << value.error().message;
  }
}

TEST(ClampWithWarning, SaysFromWhatToWhat) {
  Warnings warnings;
  EXPECT_EQ(clampWithWarning(row("specular.ior"), 5.0F, "a.json: /x", warnings), ParameterValue(3.0F));
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_EQ(warnings[0], "a.json: /x is 5 and is clamped to 3; its range is 1 to 3");
  EXPECT_EQ(clampWithWarning(row("specular.ior"), 2.0F, "a.json: /x", warnings), ParameterValue(2.0F));
  EXPECT_EQ(warnings.size(), 1U);
}

}  // namespace
}  // namespace dermis
