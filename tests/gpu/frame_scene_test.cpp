// What the renderer does when its scene changes, and what it leaves alone.
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "core/material/shading_model.h"
#include "core/scene/primitives.h"
#include "gpu/frame_support.h"

namespace dermis::test {
namespace {

/// Values that a black or an unfinished picture doesn't have.
double variance(const Image& image) {
  double sum = 0.0;
  double squares = 0.0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const double value = static_cast<double>(pixel(image, x, y).g);
      EXPECT_TRUE(std::isfinite(value));
      sum += value;
      squares += value * value;
    }
  const double count = static_cast<double>(image.width) * image.height;
  return squares / count - (sum / count) * (sum / count);
}

using FrameScene = FrameTest;

TEST_F(FrameScene, ASliderTouchesOneUniformBlock) {
  ResolvedScene scene = sceneOf(makeSphere(32), materialOf(ShadingModel::Skin));
  setMap(scene, TextureSlot::Albedo, imageOf(2, 2, 1, PixelType::U8, {0, 1, 1, 0}));
  still(scene);
  FrameRequest frame = request(scene);
  const RenderStatistics before = m_renderer->statistics();
  scene.slots[0].material.parameters.specularPerceptualRoughness = 0.6F;
  show(scene);
  m_renderer->renderFrame(frame);
  const RenderStatistics after = m_renderer->statistics();
  EXPECT_EQ(after.uniformBlocksUploaded, before.uniformBlocksUploaded + 1);
  EXPECT_EQ(after.programsCompiled, before.programsCompiled);
  EXPECT_EQ(after.texturesUploaded, before.texturesUploaded);
  EXPECT_EQ(after.geometryUploads, before.geometryUploads);
  EXPECT_EQ(after.environmentsBaked, before.environmentsBaked);
  EXPECT_EQ(after.displayProgramsBuilt, before.displayProgramsBuilt);

  // A map that goes changes which maps are read, and the texture is let go.
  scene.slots[0].images = {};
  scene.slots[0].material.textures = {};
  show(scene);
  m_renderer->renderFrame(frame);
  EXPECT_EQ(m_renderer->statistics().residentTextures, 0U);

  // Turning the environment is a number.
  scene.scene.environment.rotationDegrees = 30.0F;
  show(scene);
  m_renderer->renderFrame(frame);
  EXPECT_EQ(m_renderer->statistics().environmentsBaked, before.environmentsBaked);
}

TEST_F(FrameScene, TheLastEnvironmentStaysUntilTheNextIsComplete) {
  ResolvedScene scene = sceneOf(makePlane(), materialOf(ShadingModel::Skin), glm::vec3(1.0F));
  scene.scene.environment.background.kind = BackgroundKind::Environment;
  scene.camera.orthographicHeight = 4.0F;
  EXPECT_THAT(pixel(still(scene), 1, 1), IsColour(glm::vec3(1.0F), 0.01F));
  scene.environment = constantWorld({0.25F, 0.25F, 0.25F});
  m_renderer->setScene(std::make_shared<ResolvedScene>(scene));
  const FrameRequest frame = request(scene);
  m_renderer->renderFrame(frame);
  EXPECT_THAT(pixel(m_renderer->readAov(Aov::Beauty), 1, 1), IsColour(glm::vec3(1.0F), 0.01F)) << "still the old one";
  EXPECT_FALSE(m_renderer->jobProgress().first.empty());
  ASSERT_TRUE(m_renderer->finishJobs().has_value());
  EXPECT_TRUE(m_renderer->jobProgress().first.empty());
  m_renderer->renderFrame(frame);
  EXPECT_THAT(pixel(m_renderer->readAov(Aov::Beauty), 1, 1), IsColour(glm::vec3(0.25F), 0.01F));

  // Cancelling keeps what is in use; asking again starts again.
  scene.environment = constantWorld({0.5F, 0.5F, 0.5F});
  m_renderer->setScene(std::make_shared<ResolvedScene>(scene));
  m_renderer->cancelJobs();
  m_renderer->renderFrame(frame);
  EXPECT_THAT(pixel(m_renderer->readAov(Aov::Beauty), 1, 1), IsColour(glm::vec3(0.25F), 0.01F));
  EXPECT_THAT(pixel(still(scene), 1, 1), IsColour(glm::vec3(0.5F), 0.01F));
}

TEST_F(FrameScene, WithoutAnEnvironmentYetLampsLight) {
  ResolvedScene scene = sceneOf(makePlane(), materialOf(ShadingModel::Skin));
  scene.scene.lights.push_back(pointLight({0.0F, 0.0F, 2.0F}, 4.0F));
  m_renderer->setScene(std::make_shared<ResolvedScene>(scene));
  EXPECT_TRUE(m_renderer->renderFrame(request(scene)));
  EXPECT_GT(pixel(m_renderer->readAov(Aov::Beauty), 24, 24).r, 0.1F);
}

TEST_F(FrameScene, EveryModelOnEveryBackgroundDrawsSomething) {
  for (const ShadingModelRow& row : shadingModels()) {
    ResolvedScene scene = sceneOf(makeSphere(32), materialOf(row.model), {0.5F, 0.7F, 0.9F});
    scene.scene.lights.push_back(pointLight({2.0F, 2.0F, 3.0F}, 10.0F));
    scene.scene.lights[0].visible = true;
    scene.camera.orthographicHeight = 6.0F;
    for (const BackgroundKind kind : {BackgroundKind::Environment, BackgroundKind::Irradiance,
                                      BackgroundKind::Prefiltered, BackgroundKind::Color, BackgroundKind::None}) {
      scene.scene.environment.background.kind = kind;
      scene.scene.environment.background.color = {0.1F, 0.2F, 0.3F};
      EXPECT_GT(variance(still(scene)), 1e-4) << row.id << " on background " << static_cast<int>(kind);
    }
  }
}

TEST_F(FrameScene, MovingFramesAreSmoothOnBothKindsOfDriver) {
  const ResolvedScene scene = sceneOf(makeSphere(64), emissive(glm::vec3(1.0F)), glm::vec3(0.0F));
  for (const bool software : {true, false}) {
    const auto values = movingPicture(scene, software);
    int between = 0;
    for (std::size_t i = 0; i < values.size(); i += 4) between += values[i] > 20 && values[i] < 235 ? 1 : 0;
    EXPECT_GT(between, 30) << "grey pixels along the disc's edge, software " << software;
    EXPECT_EQ(values[4 * (24 * 48 + 24)], 255);
    EXPECT_TRUE(m_renderer->pickPosition({24, 24}).has_value());
    EXPECT_TRUE(m_renderer->accumulating()) << "nothing of it is kept";
  }
}

TEST_F(FrameScene, ASmallerPictureFillsTheWindow) {
  const ResolvedScene scene = sceneOf(makePlane(), emissive(glm::vec3(0.5F)), glm::vec3(0.0F));
  show(scene);
  const Window window({96, 96});
  FrameRequest frame = request(scene);
  frame.moving = true;
  frame.framebuffer = window.framebuffer.id();
  frame.displaySize = {96, 96};
  EXPECT_TRUE(m_renderer->renderFrame(frame));
  const auto values = window.read();
  for (const std::size_t at : {std::size_t{0}, std::size_t{95}, std::size_t{96 * 95}, std::size_t{96 * 96 - 1}})
    EXPECT_NEAR(values[4 * at], 128, 1);
}

TEST_F(FrameScene, TheWindowShowsEveryAov) {
  const ResolvedScene scene = sceneOf(makeSphere(64), materialOf(ShadingModel::Skin));
  show(scene);
  const Window window(m_size);
  for (const bool moving : {false, true})
    for (const Aov aov : allAovs()) {
      FrameRequest frame = request(scene, 2);
      frame.aov = aov;
      frame.moving = moving;
      frame.framebuffer = window.framebuffer.id();
      glClearTexImage(window.texture.id(), 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
      EXPECT_TRUE(m_renderer->renderFrame(frame));
      const auto values = window.read();
      const std::size_t middle = std::size_t{4} * (24 * 48 + 24);
      EXPECT_EQ(values[middle + 3], 255) << toString(aov);
      // Nothing comes through a sphere as thick as a head.
      if (aov == Aov::Transmission || aov == Aov::Thickness) continue;
      EXPECT_GT(values[middle] + values[middle + 1] + values[middle + 2], 6) << toString(aov);
    }
}

TEST_F(FrameScene, NothingToDrawIsNoError) {
  EXPECT_FALSE(m_renderer->renderFrame(FrameRequest{}));
  EXPECT_EQ(m_renderer->readAov(Aov::Beauty).channels, 4);
  EXPECT_FALSE(m_renderer->pickPosition({0, 0}).has_value());
  const ResolvedScene scene = sceneOf(makePlane(), materialOf(ShadingModel::Skin));
  show(scene);
  FrameRequest frame = request(scene);
  frame.size = {0, 10};
  EXPECT_FALSE(m_renderer->renderFrame(frame));
}

TEST_F(FrameScene, AModelWithoutTrianglesDrawsItsBackground) {
  Model empty;
  empty.slots.push_back({"default", {}});
  ResolvedScene scene = sceneOf(std::move(empty), materialOf(ShadingModel::Skin));
  scene.scene.environment.background = {BackgroundKind::Color, 0.0F, {0.5F, 0.25F, 0.125F}};
  EXPECT_THAT(pixel(still(scene), 24, 24), IsColour(glm::vec3(0.5F, 0.25F, 0.125F), 1e-4F));
}

TEST_F(FrameScene, OneRendererAfterAnotherInOneContext) {
  const ResolvedScene scene = sceneOf(makeSphere(32), materialOf(ShadingModel::Thesis));
  const Image first = still(scene);
  m_renderer.reset();
  makeRenderer();
  EXPECT_EQ(largestDifference(first, still(scene)), 0.0F);
}

TEST_F(FrameScene, PassTimesNameThePasses) {
  const ResolvedScene scene = sceneOf(makeSphere(32), materialOf(ShadingModel::Thesis));
  const auto namesAfter = [&](int samples) {
    still(scene, samples);
    std::vector<std::string> names;
    for (const PassTime& pass : m_renderer->passTimes()) names.push_back(pass.name);
    return names;
  };
  // A single sample is its own mean.
  EXPECT_THAT(namesAfter(1), ::testing::AllOf(::testing::IsSupersetOf({"surface", "sky"}),
                                              ::testing::Not(::testing::Contains("accumulate"))));
  EXPECT_THAT(namesAfter(2), ::testing::IsSupersetOf({"surface", "sky", "accumulate"}));
}

TEST_F(FrameScene, ShadersReloadFromDiskAndABrokenOneIsReportedWithItsPlace) {
  std::string pattern = (std::filesystem::temp_directory_path() / "dermis-shaders-XXXXXX").string();
  ASSERT_NE(mkdtemp(pattern.data()), nullptr);
  const std::filesystem::path folder = pattern;
  setenv("DERMIS_SHADER_DIR", folder.c_str(), 1);
  makeRenderer();
  unsetenv("DERMIS_SHADER_DIR");
  const ResolvedScene scene = sceneOf(makePlane(), emissive(glm::vec3(0.5F)), glm::vec3(0.0F));
  const Image good = still(scene);  // files that the folder lacks come from the binary

  const auto edit = [&](const std::string& text, int seconds) {
    std::ofstream(folder / "surface.frag") << text;
    std::filesystem::last_write_time(folder / "surface.frag",
                                     std::filesystem::file_time_type::clock::now() + std::chrono::seconds(seconds));
    m_renderer->reloadChangedShaders();
    m_renderer->renderFrame(request(scene));
  };
  edit("#include \"frame_block.glsl\"\nvoid main() { nonsense; }\n", 2);
  const Warnings messages = m_renderer->takeMessages();
  ASSERT_FALSE(messages.empty());
  EXPECT_THAT(messages[0], ::testing::StartsWith("surface.frag:2:"));
  EXPECT_EQ(largestDifference(good, m_renderer->readAov(Aov::Beauty)), 0.0F);

  edit("layout(location = 0) out vec4 o;\nvoid main() { o = vec4(0.125, 0.0, 0.0, 1.0); }\n", 4);
  EXPECT_TRUE(m_renderer->takeMessages().empty());
  EXPECT_EQ(pixel(m_renderer->readAov(Aov::Beauty), 24, 24), glm::vec4(0.125F, 0.0F, 0.0F, 1.0F));
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace dermis::test
