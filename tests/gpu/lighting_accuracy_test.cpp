// The figures the renderer's light is judged by, read back through the functions that shade.
#include <algorithm>

#include "gl_fixture.h"
#include "lighting/lighting_probe.h"
#include "lighting_support.h"

namespace dermis::test {
namespace {

class LightingAccuracy : public GlTest {
 protected:
  std::vector<glm::vec3> probe(const EnvironmentMap& map, const std::vector<LightingQuery>& queries) {
    auto answers = probeLighting(m_shaders, &map, queries);
    EXPECT_TRUE(answers.has_value()) << answers.error().message;
    return answers ? *answers : std::vector<glm::vec3>(queries.size());
  }
  static std::shared_ptr<const EnvironmentMap> bake(const std::shared_ptr<const EnvironmentImages>& images) {
    Warnings warnings;
    auto map = makeEnvironmentMap(images, {}, warnings);
    EXPECT_TRUE(map.has_value());
    return map ? *map : nullptr;
  }
  gl::ShaderLibrary m_shaders;
};

TEST_F(LightingAccuracy, LookupsAgreeWithTheSumsOverAllPixels) {
  struct Row {
    float roughness;
    double tolerance;
  };
  // Between the nodes lobes are mixed: a little wider a tolerance.
  constexpr std::array kRows = {Row{0.1F, 0.03},  Row{0.25F, 0.01}, Row{0.5F, 0.01}, Row{0.75F, 0.01}, Row{1.0F, 0.01},
                                Row{0.15F, 0.03}, Row{0.3F, 0.02},  Row{0.4F, 0.02}, Row{0.6F, 0.02}};
  std::vector<float> roughnesses;
  for (const Row& row : kRows) roughnesses.push_back(row.roughness);
  for (const NamedEnvironment& environment : testEnvironments()) {
    const auto map = bake(environment.images);
    ASSERT_NE(map, nullptr);
    std::vector<ExactLight> exact;
    for (const glm::vec3& d : cubeDirections26()) {
      exact.push_back(exactLight(*environment.images->latLong, d, roughnesses));
    }
    std::vector<LightingQuery> queries;
    std::vector<glm::dvec3> want;
    for (const glm::vec3& d : cubeDirections26()) queries.push_back(LightingQuery::irradiance(d));
    for (const ExactLight& light : exact) want.push_back(light.irradiance);
    EXPECT_LE(relativeRms(probe(*map, queries), want), 0.003) << environment.name << ", irradiance";

    for (std::size_t k = 0; k < kRows.size(); ++k) {
      queries.clear();
      want.clear();
      for (const glm::vec3& d : cubeDirections26()) {
        queries.push_back(LightingQuery::prefiltered(d, kRows[k].roughness));
      }
      for (const ExactLight& light : exact) want.push_back(light.prefiltered[k]);
      EXPECT_LE(relativeRms(probe(*map, queries), want), kRows[k].tolerance)
          << environment.name << ", roughness " << kRows[k].roughness;
    }
  }
}

TEST_F(LightingAccuracy, AConstantWorldStaysWhiteToTheLastBit) {
  auto constant = std::make_shared<EnvironmentImages>();
  constant->constant = glm::vec3(1.0F);
  for (const auto& images : {std::shared_ptr<const EnvironmentImages>(constant),
                             latLongEnvironment(96, 48, [](int, int) { return glm::vec3(1.0F); })}) {
    const auto map = bake(images);
    ASSERT_NE(map, nullptr);
    std::vector<LightingQuery> queries;
    for (const glm::vec3& d : spiralDirections26()) {
      queries.push_back(LightingQuery::irradiance(d));
      queries.push_back(LightingQuery::sharp(d));
      for (const float r : {0.0F, 0.05F, 0.1F, 0.33F, 0.5F, 0.72F, 1.0F}) {
        queries.push_back(LightingQuery::prefiltered(d, r));
      }
    }
    for (const glm::vec3& answer : probe(*map, queries)) {
      for (int c = 0; c < 3; ++c) EXPECT_NEAR(answer[c], 1.0F, 2.0e-6F);
    }
  }
}

TEST_F(LightingAccuracy, RadiancePastHalfFloatsSurvives) {
  const auto images = latLongEnvironment(64, 32, [](int i, int) { return glm::vec3(i < 32 ? 2.0e6F : 1.0e-3F); });
  const auto map = bake(images);
  ASSERT_NE(map, nullptr);
  const auto answers = probe(*map, {LightingQuery::sharp({-1, 0, 0}), LightingQuery::sharp({1, 0, 0})});
  EXPECT_NEAR(answers[0].x, 2.0e6F, 2.0e3F);
  EXPECT_NEAR(answers[1].x, 1.0e-3F, 1.0e-5F);
  // A dim world keeps its digits too.
  const auto dim = bake(latLongEnvironment(64, 32, [](int, int) { return glm::vec3(3.0e-7F); }));
  ASSERT_NE(dim, nullptr);
  EXPECT_NEAR(probe(*dim, {LightingQuery::irradiance({0, 1, 0})})[0].x, 3.0e-7F, 1.0e-9F);
}

}  // namespace
}  // namespace dermis::test
