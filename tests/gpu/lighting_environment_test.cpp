// Orientation, repair, storage and the life of an environment's bake.
#include <filesystem>
#include <fstream>
#include <limits>
#include <thread>

#include "gl_fixture.h"
#include "lighting/environment_cache.h"
#include "lighting/lighting_probe.h"
#include "lighting/spherical_harmonics.h"
#include "lighting_support.h"

namespace dermis::test {
namespace {

namespace fs = std::filesystem;

class LightingEnvironment : public GlTest {
 protected:
  void SetUp() override {
    GlTest::SetUp();
    m_folder = fs::path(::testing::TempDir()) / "dermis-environment-cache";
    fs::remove_all(m_folder);
  }
  void TearDown() override {
    fs::remove_all(m_folder);
    GlTest::TearDown();
  }
  std::vector<glm::vec3> probe(const EnvironmentMap& map, const std::vector<LightingQuery>& queries,
                               float rotation = 0.0F, float stops = 0.0F) {
    auto answers = probeLighting(m_shaders, &map, queries, rotation, stops);
    EXPECT_TRUE(answers.has_value()) << answers.error().message;
    return answers ? *answers : std::vector<glm::vec3>(queries.size());
  }
  std::shared_ptr<const EnvironmentMap> bake(const std::shared_ptr<const EnvironmentImages>& images) {
    auto map = makeEnvironmentMap(images, {}, m_warnings);
    EXPECT_TRUE(map.has_value());
    return map ? *map : nullptr;
  }
  static std::string bytesOf(const CubeTexels& texels) {
    return {reinterpret_cast<const char*>(texels.bytes.data()), texels.bytes.size()};
  }

  gl::ShaderLibrary m_shaders;
  Warnings m_warnings;
  fs::path m_folder;
};

const std::array<glm::vec3, 6> kAxes = {glm::vec3(1, 0, 0),  glm::vec3(-1, 0, 0), glm::vec3(0, 1, 0),
                                        glm::vec3(0, -1, 0), glm::vec3(0, 0, 1),  glm::vec3(0, 0, -1)};
const std::array<glm::vec3, 6> kColours = {glm::vec3(1, 0, 0), glm::vec3(0, 1, 0), glm::vec3(0, 0, 1),
                                           glm::vec3(1, 1, 0), glm::vec3(0, 1, 1), glm::vec3(1, 0, 1)};

/// The colour of the axis that a direction is nearest to.
glm::vec3 axisColour(const glm::dvec3& d) {
  std::size_t best = 0;
  for (std::size_t i = 1; i < 6; ++i)
    if (glm::dot(d, glm::dvec3(kAxes[i])) > glm::dot(d, glm::dvec3(kAxes[best]))) best = i;
  return kColours[best];
}

TEST_F(LightingEnvironment, LatLongLooksWhereTheConventionsSay) {
  const auto map =
      bake(latLongEnvironment(256, 128, [](int i, int j) { return axisColour(pixelDirection(i, j, 256, 128)); }));
  ASSERT_NE(map, nullptr);
  for (std::size_t i = 0; i < 6; ++i) {
    const auto answers = probe(*map, {LightingQuery::sharp(kAxes[i]), LightingQuery::prefiltered(kAxes[i], 0.1F),
                                      LightingQuery::prefiltered(kAxes[i], 0.0F)});
    for (const glm::vec3& answer : answers) EXPECT_LT(glm::length(answer - kColours[i]), 0.1F) << "axis " << i;
  }
}

TEST_F(LightingEnvironment, SixFacesAreSampledAsGlDefinesCubeMaps) {
  auto images = std::make_shared<EnvironmentImages>();
  // Each face in its own colour, its first row (t = 0) white, its first column (s = 0) black below that.
  for (std::size_t f = 0; f < 6; ++f)
    images->faces[f] = makeFloatImage(64, 64, [f](int i, int j) {
      return j < 8 ? glm::vec3(1.0F) : i < 8 ? glm::vec3(0.0F) : kColours[f];
    });
  const auto map = bake(images);
  ASSERT_NE(map, nullptr);
  // OpenGL 4.5, table 8.19: where the middle of t = 0, and of s = 0, of each face lies.
  const std::array<glm::vec3, 6> top = {glm::vec3(1, .95F, 0),  glm::vec3(-1, .95F, 0), glm::vec3(0, 1, -.95F),
                                        glm::vec3(0, -1, .95F), glm::vec3(0, .95F, 1),  glm::vec3(0, .95F, -1)};
  const std::array<glm::vec3, 6> left = {glm::vec3(1, 0, .95F),   glm::vec3(-1, 0, -.95F), glm::vec3(-.95F, 1, 0),
                                         glm::vec3(-.95F, -1, 0), glm::vec3(-.95F, 0, 1),  glm::vec3(.95F, 0, -1)};
  for (std::size_t f = 0; f < 6; ++f) {
    const auto answers =
        probe(*map, {LightingQuery::sharp(kAxes[f]), LightingQuery::sharp(glm::normalize(top[f])),
                     LightingQuery::sharp(glm::normalize(left[f])), LightingQuery::prefiltered(kAxes[f], 0.1F)});
    EXPECT_LT(glm::length(answers[0] - kColours[f]), 0.01F) << "face " << f;
    EXPECT_LT(glm::length(answers[1] - glm::vec3(1.0F)), 0.01F) << "face " << f;
    EXPECT_LT(glm::length(answers[2]), 0.01F) << "face " << f;
    EXPECT_LT(glm::length(answers[3] - kColours[f]), 0.05F) << "face " << f;
  }
}

TEST_F(LightingEnvironment, PositiveRotationTurnsCounterClockwiseSeenFromAbove) {
  const auto map =
      bake(latLongEnvironment(256, 128, [](int i, int j) { return axisColour(pixelDirection(i, j, 256, 128)); }));
  ASSERT_NE(map, nullptr);
  // What was at +X goes to −Z, and −Z to −X.
  const auto turned =
      probe(*map, {LightingQuery::sharp({0, 0, -1}), LightingQuery::sharp({-1, 0, 0}), LightingQuery::sharp({0, 1, 0})},
            90.0F);
  EXPECT_LT(glm::length(turned[0] - kColours[0]), 0.01F);
  EXPECT_LT(glm::length(turned[1] - kColours[5]), 0.01F);
  EXPECT_LT(glm::length(turned[2] - kColours[2]), 0.01F);
  EXPECT_NEAR(probe(*map, {LightingQuery::sharp({1, 0, 0})}, 0.0F, 2.0F)[0].x, 4.0F, 0.01F);
}

TEST_F(LightingEnvironment, BadTexelsAreRepairedCountedAndReported) {
  const auto images = latLongEnvironment(128, 64, [](int i, int j) {
    constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    if (j == 32 && i == 5) return glm::vec3(kNan, 1.0F, 1.0F);
    if (j == 32 && i == 9) return glm::vec3(kInfinity, -kInfinity, 1.0F);
    if (j == 10) return glm::vec3(-0.5F, 1.0F, 1.0F);
    return glm::vec3(1.0F);
  });
  const auto map = bake(images);
  ASSERT_NE(map, nullptr);
  EXPECT_EQ(map->figures().cleaned.nonFinite, 3U);
  EXPECT_EQ(map->figures().cleaned.negative, 128U);
  ASSERT_EQ(m_warnings.size(), 1U);
  EXPECT_NE(m_warnings[0].find("test.hdr"), std::string::npos);
  std::vector<LightingQuery> queries;
  for (const glm::vec3& d : cubeDirections26()) {
    for (const float r : {0.0F, 0.1F, 0.5F, 1.0F}) queries.push_back(LightingQuery::prefiltered(d, r));
    queries.push_back(LightingQuery::irradiance(d));
  }
  for (const glm::vec3& answer : probe(*map, queries))
    for (int c = 0; c < 3; ++c) EXPECT_TRUE(answer[c] >= 0.0F && answer[c] <= 1.01F) << answer[c];
}

TEST_F(LightingEnvironment, TheCacheGivesTheSameBytesAndDamagedFilesAreIgnored) {
  auto images = std::make_shared<EnvironmentImages>(
      *latLongEnvironment(256, 128, [](int i, int j) { return axisColour(pixelDirection(i, j, 256, 128)); }));
  images->contentHash = 0x1234;
  EnvironmentBakeOptions options;
  options.cacheFolder = m_folder;
  const auto first = bakeEnvironment(*images, options);
  ASSERT_TRUE(first.has_value());
  EXPECT_FALSE((*first)->figures.fromCache);
  const auto second = bakeEnvironment(*images, options);
  ASSERT_TRUE(second.has_value());
  EXPECT_TRUE((*second)->figures.fromCache);
  EXPECT_EQ(bytesOf((*first)->prefiltered), bytesOf((*second)->prefiltered));
  EXPECT_EQ(bytesOf((*first)->irradiance), bytesOf((*second)->irradiance));
  EXPECT_EQ(bytesOf((*first)->sharp), bytesOf((*second)->sharp));
  EXPECT_EQ((*first)->scale, (*second)->scale);

  // One bit, a missing end, an empty file, another picture: baked again.
  const fs::path file = environmentCacheFile(options, *images);
  const auto size = fs::file_size(file);
  {
    std::fstream stream(file, std::ios::in | std::ios::out | std::ios::binary);
    stream.seekp(static_cast<std::streamoff>(size / 2));
    stream.put('\x5a');
  }
  EXPECT_EQ(readEnvironmentCache(options, *images), nullptr);
  const auto third = bakeEnvironment(*images, options);
  ASSERT_TRUE(third.has_value());
  EXPECT_FALSE((*third)->figures.fromCache);
  EXPECT_EQ(bytesOf((*first)->prefiltered), bytesOf((*third)->prefiltered));
  fs::resize_file(file, size - 1);
  EXPECT_EQ(readEnvironmentCache(options, *images), nullptr);
  fs::resize_file(file, 0);
  EXPECT_EQ(readEnvironmentCache(options, *images), nullptr);
  images->contentHash = 0x1235;
  EXPECT_EQ(readEnvironmentCache(options, *images), nullptr);

  // A folder that cannot be made costs nothing but the cache.
  options.cacheFolder = file / "below-a-file";
  EXPECT_TRUE(bakeEnvironment(*images, options).has_value());
}

TEST_F(LightingEnvironment, ADroppedJobNeverReports) {
  const auto images = testEnvironments()[0].images;
  bool ready = false;
  {
    auto job = makeEnvironmentJob(images, {}, [&](auto, auto) { ready = true; });
    const auto done = job->step();
    ASSERT_TRUE(done.has_value());
    EXPECT_FALSE(*done);
    EXPECT_NE(job->text().find("test.hdr"), std::string::npos);
  }
  EXPECT_FALSE(ready);

  std::stop_source stop;
  stop.request_stop();
  const auto stopped = bakeEnvironment(*images, {}, stop.get_token());
  ASSERT_FALSE(stopped.has_value());
  EXPECT_EQ(stopped.error().kind, Error::Kind::Cancelled);

  auto job =
      makeEnvironmentJob(latLongEnvironment(64, 32, [](int, int) { return glm::vec3(2.0F); }), {},
                         [&](const std::shared_ptr<const EnvironmentMap>& map, auto) { ready = map != nullptr; });
  double last = 0.0;
  for (bool done = false; !done;) {
    const auto step = job->step();
    ASSERT_TRUE(step.has_value());
    done = *step;
    EXPECT_GE(job->fraction() + 1e-6, last);
    last = job->fraction();
  }
  EXPECT_TRUE(ready);
}

TEST_F(LightingEnvironment, SphericalHarmonicsRebuildAPolynomialSky) {
  // 4 + y + 2x + 3z² has exactly the coefficients that follow from the basis' norms.
  const auto images = latLongEnvironment(1024, 512, [](int i, int j) {
    const glm::dvec3 d = pixelDirection(i, j, 1024, 512);
    return glm::vec3(static_cast<float>(4.0 + d.y + 2.0 * d.x + 3.0 * d.z * d.z));
  });
  const auto sh = sphericalHarmonics9(RadianceMap(*images));
  const double pi = std::numbers::pi;
  const std::array<double, 9> want = {5.0 * 2.0 * std::sqrt(pi),
                                      std::sqrt(4.0 * pi / 3.0),
                                      0.0,
                                      2.0 * std::sqrt(4.0 * pi / 3.0),
                                      0.0,
                                      0.0,
                                      2.0 * std::sqrt(4.0 * pi / 5.0),
                                      0.0,
                                      0.0};
  for (std::size_t i = 0; i < 9; ++i) EXPECT_NEAR(sh[i].x, want[i], 2.0e-4) << "coefficient " << i;
}

}  // namespace
}  // namespace dermis::test
