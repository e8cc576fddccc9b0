// The figures the renderer's light is judged by, read back through the functions that shade.
#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <iostream>
#include <set>

#include "core/io/importer.h"
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

// DERMIS_TEST_HDRI=FOLDER prints the table of docs/validation-lighting.md for the images in it.
TEST_F(LightingAccuracy, TableOfRealEnvironments) {
  const char* folder = std::getenv("DERMIS_TEST_HDRI");
  if (folder == nullptr) GTEST_SKIP() << "DERMIS_TEST_HDRI names no folder of environments";
  std::set<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const auto extension = entry.path().extension();
    if (extension == ".hdr" || extension == ".exr") files.insert(entry.path());
  }
  std::vector<NamedEnvironment> environments;
  std::vector<std::string> names;
  const auto module = importer();
  ASSERT_TRUE(module.has_value()) << module.error().message;
  for (const auto& file : files) {
    Warnings warnings;
    ImageReadOptions options;
    options.asFloat = true;
    auto image = (*module)->loadImage(file, options, warnings);
    ASSERT_TRUE(image.has_value()) << image.error().message;
    CleanedTexels ignored;
    const RadianceImage clean = cleanRadiance(*image, ignored);
    names.push_back(file.filename().string());
    environments.push_back(
        {nullptr, latLongEnvironment(clean.width, clean.height, [&](int i, int j) { return clean.at(i, j); })});
  }
  for (const NamedEnvironment& environment : testEnvironments()) {
    names.emplace_back(environment.name);
    environments.push_back(environment);
  }
  const std::vector<float> roughnesses = {0.1F, 0.25F, 0.5F, 0.75F, 1.0F, 0.15F, 0.3F, 0.4F, 0.6F};
  std::cout << "| environment | CPU s | irradiance";
  for (const float r : roughnesses) std::cout << " | " << r;
  std::cout << " |\n";
  for (std::size_t e = 0; e < environments.size(); ++e) {
    const std::clock_t start = std::clock();
    const auto map = bake(environments[e].images);
    const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    std::vector<ExactLight> exact;
    for (const glm::vec3& d : cubeDirections26()) {
      exact.push_back(exactLight(*environments[e].images->latLong, d, roughnesses));
    }
    std::vector<LightingQuery> queries;
    std::vector<glm::dvec3> want;
    for (const glm::vec3& d : cubeDirections26()) queries.push_back(LightingQuery::irradiance(d));
    for (const ExactLight& light : exact) want.push_back(light.irradiance);
    const auto percent = [](double v) { return std::to_string(100.0 * v).substr(0, 5); };
    std::cout << "| " << names[e] << " | " << std::to_string(seconds).substr(0, 4) << " | "
              << percent(relativeRms(probe(*map, queries), want));
    for (std::size_t k = 0; k < roughnesses.size(); ++k) {
      for (std::size_t i = 0; i < exact.size(); ++i) {
        queries[i] = LightingQuery::prefiltered(cubeDirections26()[i], roughnesses[k]);
        want[i] = exact[i].prefiltered[k];
      }
      std::cout << " | " << percent(relativeRms(probe(*map, queries), want));
    }
    const EnvironmentFigures& f = map->figures();
    std::cout << " |  <!-- ms: clean " << f.cleanMs << " sharp " << f.sharpMs << " sources " << f.sourcesMs
              << " irradiance " << f.irradianceMs << " prefilter " << f.prefilterMs << " -->" << std::endl;
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
