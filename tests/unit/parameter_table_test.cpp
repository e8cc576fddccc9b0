#include "core/material/parameter_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <set>

#include "unit/parameter_samples.h"

namespace dermis {
namespace {

using test::otherValue;

TEST(ParameterTable, RowsAreCompleteAndUnique) {
  std::set<std::string_view> ids;
  for (const ParameterRow& row : parameterTable()) {
    EXPECT_TRUE(ids.insert(row.id).second) << row.id;
    EXPECT_EQ(std::count(row.id.begin(), row.id.end(), '.'), 1) << row.id;
    EXPECT_EQ(row.id.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_."), std::string_view::npos) << row.id;
    EXPECT_FALSE(row.label.empty()) << row.id;
    EXPECT_FALSE(row.group.empty()) << row.id;
    EXPECT_FALSE(row.source.empty()) << row.id;
    EXPECT_TRUE(row.sentence.ends_with('.')) << row.id;
    EXPECT_NE(row.models, 0U) << row.id;
    EXPECT_EQ(row.type == ParameterType::Enum, !row.words.empty()) << row.id;
    EXPECT_LT(row.hardMin, row.hardMax) << row.id;
    EXPECT_LE(row.hardMin, row.softMin) << row.id;
    EXPECT_LT(row.softMin, row.softMax) << row.id;
    EXPECT_LE(row.softMax, row.hardMax) << row.id;
    EXPECT_EQ(findParameter(row.id), &row);
    bool clamped = true;
    EXPECT_EQ(clampToHardRange(row, row.defaultValue(), &clamped), row.defaultValue()) << row.id;
    EXPECT_FALSE(clamped) << row.id;
  }
  EXPECT_EQ(findParameter("no.such"), nullptr);
}

/// The contract, independent of the table: id, hard range, default of what the design states in numbers.
TEST(ParameterTable, KeepsTheNumbersOfTheDesign) {
  struct Stated {
    std::string_view id;
    float lowest, highest, softLowest, softHighest, value;
  };
  constexpr std::array kStated = {
      Stated{"base.metallic", 0, 1, 0, 1, 0},
      Stated{"specular.ior", 1, 3, 1.3F, 1.6F, 1.4F},
      Stated{"specular.perceptual_roughness", 0.02F, 1, 0.2F, 0.7F, 0.45F},
      Stated{"specular.lobe_mix", 0, 1, 0, 1, 0.85F},
      Stated{"specular.intensity", 0, 2, 0, 2, 1},
      Stated{"specular.cavity", 0, 1, 0, 1, 1},
      Stated{"subsurface.weight", 0, 1, 0, 1, 1},
      Stated{"subsurface.scale", 0, 100, 0, 4, 1},
      Stated{"subsurface.albedo_mix", 0, 1, 0, 1, 0.5F},
      Stated{"transmission.weight", 0, 1, 0, 1, 1},
      Stated{"transmission.thickness_min_mm", 0, 500, 0, 50, 0},
      Stated{"transmission.thickness_max_mm", 0, 500, 0, 50, 20},
      Stated{"transmission.normal_scale", 0, 5, 0, 1, 0.08F},
      Stated{"surface.displacement_mm", -20, 20, -2, 2, 0},
      Stated{"occlusion.strength", 0, 1, 0, 1, 1},
  };
  for (const Stated& stated : kStated) {
    const ParameterRow* row = findParameter(stated.id);
    ASSERT_NE(row, nullptr) << stated.id;
    EXPECT_EQ(row->hardMin, stated.lowest) << stated.id;
    EXPECT_EQ(row->hardMax, stated.highest) << stated.id;
    EXPECT_EQ(row->softMin, stated.softLowest) << stated.id;
    EXPECT_EQ(row->softMax, stated.softHighest) << stated.id;
    EXPECT_EQ(std::get<float>(row->defaultValue()), stated.value) << stated.id;
  }
}

TEST(ParameterTable, PublishedGaussiansSumToOne) {
  const GaussianTable table = MaterialParameters().subsurfaceGaussians;
  EXPECT_EQ(table.count, 6);
  glm::vec3 sum(0.0F);
  for (const GaussianTerm& term : table.terms) sum += term.weight;
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(sum[i], 1.0F, 1e-6F);
}

TEST(ParameterTable, SetAndGetReachTheirOwnMemberOnly) {
  for (const ParameterRow& row : parameterTable()) {
    MaterialParameters parameters;
    const ParameterValue value = otherValue(row);
    ASSERT_NE(value, row.defaultValue()) << row.id;
    row.set(parameters, value);
    EXPECT_EQ(row.get(parameters), value) << row.id;
    for (const ParameterRow& another : parameterTable()) {
      if (&another == &row) continue;
      EXPECT_EQ(another.get(parameters), another.defaultValue()) << row.id << another.id;
    }
  }
}

TEST(ParameterTable, EditingTheIorMakesF0FollowIt) {
  MaterialParameters parameters;
  parameters.specularF0 = Colour{glm::vec3(1.0F)};
  setParameter(parameters, *findParameter("specular.ior"), 1.5F);
  EXPECT_FALSE(parameters.specularF0.has_value());
  setParameter(parameters, *findParameter("specular.f0"), OptionalColour(Colour{glm::vec3(0.5F)}));
  EXPECT_TRUE(parameters.specularF0.has_value());
  EXPECT_EQ(parameters.specularIor, 1.5F);
}

TEST(ParameterTable, ClampingBringsEveryComponentInside) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  const ParameterRow& albedo = *findParameter("base.albedo");
  bool clamped = false;
  EXPECT_EQ(clampToHardRange(albedo, Colour{{-1.0F, 0.5F, 7.0F}}, &clamped), ParameterValue(Colour{{0, 0.5F, 1}}));
  EXPECT_TRUE(clamped);
  EXPECT_EQ(clampToHardRange(*findParameter("specular.ior"), std::nanf("")), ParameterValue(1.0F));
  EXPECT_EQ(clampToHardRange(*findParameter("specular.ior"), kInfinity), ParameterValue(1.0F));
  EXPECT_EQ(clampToHardRange(*findParameter("specular.f0"), OptionalColour()), ParameterValue(OptionalColour()));
  GaussianTable table;
  table.terms[0] = {1000.0F, {-1.0F, 0.5F, 2.0F}};
  table.count = 1;
  const auto inside = std::get<GaussianTable>(clampToHardRange(*findParameter("subsurface.gaussians"), table));
  EXPECT_EQ(inside.terms[0], (GaussianTerm{400.0F, {0.0F, 0.5F, 1.0F}}));
}

// ---- the uniform block

TEST(MaterialBlock, OffsetsFollowStd140) {
  std::size_t end = 0;
  for (const ParameterRow& row : parameterTable()) {
    const bool scalar =
        row.type == ParameterType::Float || row.type == ParameterType::Enum || row.type == ParameterType::Bool;
    const std::size_t alignment = scalar ? 4 : row.type == ParameterType::Vec2 ? 8 : 16;
    EXPECT_EQ(row.std140Offset % alignment, 0U) << row.id;
    EXPECT_GE(row.std140Offset, end) << row.id;
    EXPECT_LT(row.std140Offset - end, alignment) << row.id << ": a gap that std140 does not make";
    const std::size_t table = 16 * kMaxGaussians + 4;
    end = row.std140Offset + (row.type == ParameterType::Gaussians ? table : alignment);
  }
  EXPECT_GE(materialBlockSize(), end);
  EXPECT_LT(materialBlockSize() - end, 16U);
  EXPECT_EQ(materialBlockSize() % 16, 0U);
}

TEST(MaterialBlock, HoldsEveryRow) {
  const std::vector<std::byte> plain = packMaterialBlock({});
  EXPECT_EQ(plain.size(), materialBlockSize());
  for (const ParameterRow& row : parameterTable()) {
    MaterialParameters parameters;
    row.set(parameters, otherValue(row));
    const std::vector<std::byte> block = packMaterialBlock(parameters);
    std::size_t first = 0;
    while (first < block.size() && block[first] == plain[first]) ++first;
    // The first byte that differs lies in the row's own place (a float's lowest bytes may agree).
    EXPECT_GE(first, row.std140Offset) << row.id;
    EXPECT_LT(first, row.std140Offset + 4) << row.id;
    EXPECT_THAT(materialBlockGlsl(), testing::HasSubstr(" " + row.glslName)) << row.id;
  }
}

TEST(MaterialBlock, ANullColourHasWZero) {
  const std::size_t at = findParameter("specular.f0")->std140Offset;
  const auto w = [&](const OptionalColour& colour) {
    MaterialParameters parameters;
    parameters.specularF0 = colour;
    float value = -1.0F;
    std::memcpy(&value, packMaterialBlock(parameters).data() + at + 12, sizeof(value));
    return value;
  };
  EXPECT_EQ(w(std::nullopt), 0.0F);
  EXPECT_EQ(w(Colour{glm::vec3(0.0F)}), 1.0F);
}

}  // namespace
}  // namespace dermis
