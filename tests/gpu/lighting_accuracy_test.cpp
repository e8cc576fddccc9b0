// The figures the renderer's light is judged by, read back through the functions that shade.
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <set>
#include <utility>

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

/// The images in the folder that the environment variable DERMIS_TEST_HDRI names, where it does.
std::vector<std::pair<std::string, std::shared_ptr<const EnvironmentImages>>> givenEnvironments() {
  std::vector<std::pair<std::string, std::shared_ptr<const EnvironmentImages>>> environments;
  const char* folder = std::getenv("DERMIS_TEST_HDRI");
  if (folder == nullptr) return environments;
  std::set<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const auto extension = entry.path().extension();
    if (extension == ".hdr" || extension == ".exr") files.insert(entry.path());
  }
  const auto module = importer();
  if (!module) {
    ADD_FAILURE() << module.error().message;
    return environments;
  }
  for (const auto& file : files) {
    Warnings warnings;
    ImageReadOptions options;
    options.asFloat = true;
    auto image = (*module)->loadImage(file, options, warnings);
    if (!image) {
      ADD_FAILURE() << image.error().message;
      continue;
    }
    CleanedTexels ignored;
    const RadianceImage clean = cleanRadiance(*image, ignored);
    environments.emplace_back(
        file.filename().string(),
        latLongEnvironment(clean.width, clean.height, [&](int i, int j) { return clean.at(i, j); }));
  }
  return environments;
}

// Prints the table of docs/validation-lighting.md: relative RMS in percent.
TEST_F(LightingAccuracy, LookupsAgreeWithTheSumsOverAllPixels) {
  struct Row {
    float roughness;
    double tolerance;
  };
  // Between the nodes lobes are mixed: a little wider a tolerance.
  constexpr std::array kRows = {Row{0.1F, 0.03},  Row{0.25F, 0.01}, Row{0.5F, 0.01}, Row{0.75F, 0.01}, Row{1.0F, 0.01},
                                Row{0.15F, 0.03}, Row{0.3F, 0.02},  Row{0.4F, 0.02}, Row{0.6F, 0.02}};
  std::vector<float> roughnesses(kRows.size());
  std::transform(kRows.begin(), kRows.end(), roughnesses.begin(), [](const Row& row) { return row.roughness; });
  auto environments = givenEnvironments();
  for (const NamedEnvironment& environment : testEnvironments())
    environments.emplace_back(environment.name, environment.images);
  fmt::print("| environment | irradiance | {} |\n", fmt::join(roughnesses, " | "));
  for (const auto& [name, images] : environments) {
    const auto map = bake(images);
    ASSERT_NE(map, nullptr);
    std::vector<ExactLight> exact;
    for (const glm::vec3& d : cubeDirections26()) exact.push_back(exactLight(*images->latLong, d, roughnesses));
    std::vector<LightingQuery> queries;
    std::vector<glm::dvec3> want;
    want.reserve(exact.size());
    for (const glm::vec3& d : cubeDirections26()) queries.push_back(LightingQuery::irradiance(d));
    for (const ExactLight& light : exact) want.push_back(light.irradiance);
    const double irradiance = relativeRms(probe(*map, queries), want);
    EXPECT_LE(irradiance, 0.003) << name << ", irradiance";
    fmt::print("| {} | {:.3f}", name, 100.0 * irradiance);
    for (std::size_t k = 0; k < kRows.size(); ++k) {
      for (std::size_t i = 0; i < exact.size(); ++i) {
        queries[i] = LightingQuery::prefiltered(cubeDirections26()[i], kRows[k].roughness);
        want[i] = exact[i].prefiltered[k];
      }
      const double prefiltered = relativeRms(probe(*map, queries), want);
      EXPECT_LE(prefiltered, kRows[k].tolerance) << name << ", roughness " << kRows[k].roughness;
      fmt::print(" | {:.3f}", 100.0 * prefiltered);
    }
    fmt::print(" |\n");
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
