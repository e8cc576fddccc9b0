// Numbers as colours: the ramp against the table it was fitted to, the picture against the ramp, the file against the
// window.
#include "colour/false_colour.h"

#include <cmath>

#include "core/scene/primitives.h"
#include "gpu/frame_support.h"

namespace dermis::test {
namespace {

TEST(FalseColour, RampIsThePublishedTable) {
  // Every 32nd entry of the table, and its last (matplotlib, CC0).
  const std::pair<int, glm::vec3> kTable[] = {
      {0, {0.267004F, 0.004874F, 0.329415F}},   {32, {0.278826F, 0.175490F, 0.483397F}},
      {64, {0.229739F, 0.322361F, 0.545706F}},  {96, {0.172719F, 0.448791F, 0.557885F}},
      {128, {0.127568F, 0.566949F, 0.550556F}}, {160, {0.157851F, 0.683765F, 0.501686F}},
      {192, {0.369214F, 0.788888F, 0.382914F}}, {224, {0.678489F, 0.863742F, 0.189503F}},
      {255, {0.993248F, 0.906157F, 0.143936F}}};
  float lastLuma = 0.0F;
  for (const auto& [index, colour] : kTable) {
    const glm::vec3 ours = viridis(static_cast<float>(index) / 255.0F);
    EXPECT_THAT(ours, IsColour(colour, 0.0105F)) << index;
    const float luma = glm::dot(ours, glm::vec3(0.2126F, 0.7152F, 0.0722F));
    EXPECT_GT(luma, lastLuma);  // readable in grey
    lastLuma = luma;
  }
  EXPECT_EQ(viridis(-1.0F), viridis(0.0F));
  EXPECT_EQ(viridis(7.0F), viridis(1.0F));
}

TEST(FalseColour, RangesFollowTheSceneAndMarkGains) {
  ResolvedScene scene = sceneOf(makeSphere(16), materialOf(ShadingModel::Skin));
  for (ResolvedMaterial& slot : scene.slots) slot.material.parameters.transmissionThicknessMaxMm = 7.0F;
  EXPECT_EQ(valueRange(Aov::Thickness, scene, scene.camera)->high, 7.0F);
  const auto depth = valueRange(Aov::Depth, scene, scene.camera);
  const float distance = glm::length(scene.model->bounds.centre() - scene.camera.position);
  EXPECT_NEAR(depth->low, distance - 1.0F, 1e-4F);  // a sphere of radius 1 seen along an axis
  EXPECT_NEAR(depth->high, distance + 1.0F, 1e-4F);
  EXPECT_EQ(depth->inMillimetres, scene.millimetresPerUnit);
  const ValueRange energy = *valueRange(Aov::Energy, scene, scene.camera);
  const glm::vec3 gain = falseColour(energy, 1.05F);
  EXPECT_GT(gain.r, 3.0F * std::max(gain.g, gain.b));
  EXPECT_EQ(falseColour(energy, 1.0F), viridis(1.0F));
  EXPECT_FALSE(valueRange(Aov::Beauty, scene, scene.camera));
  EXPECT_FALSE(valueRange(Aov::Normal, scene, scene.camera));
}

class FalseColourFrame : public FrameTest {};

TEST_F(FalseColourFrame, ViewsOfNumbersAreTheNumbersThroughTheRamp) {
  ResolvedScene scene = sceneOf(makeSphere(64), materialOf(ShadingModel::Skin));
  makeRenderer();
  m_renderer->keepAovs({Aov::Depth, Aov::Energy, Aov::Normal});
  still(scene);
  for (const Aov aov : {Aov::Depth, Aov::Energy}) {
    const Image numbers = m_renderer->readAov(aov);
    const Image shown = m_renderer->readView(aov, {}, PixelType::U8);
    const ValueRange range = *valueRange(aov, scene, scene.camera);
    for (const glm::ivec2 at : {glm::ivec2(24, 24), glm::ivec2(16, 20), glm::ivec2(34, 30)}) {
      const glm::vec3 expected = falseColour(range, pixel(numbers, at.x, at.y).r);
      const std::byte* codes = &shown.pixels[static_cast<std::size_t>((at.y * shown.width + at.x) * 4)];
      for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(std::to_integer<int>(codes[c]), 255.0F * glm::clamp(expected[c], 0.0F, 1.0F), 1.5F)
            << toString(aov) << " at " << at.x << ", " << at.y;
    }
  }
  // A normal is shown as half of itself plus a half.
  const glm::vec4 normal = pixel(m_renderer->readAov(Aov::Normal), 30, 18);
  const Image shown = m_renderer->readView(Aov::Normal, {}, PixelType::U8);
  const std::byte* codes = &shown.pixels[static_cast<std::size_t>((18 * shown.width + 30) * 4)];
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(std::to_integer<int>(codes[c]), 127.5F * (normal[c] + 1.0F), 1.5F);
}

TEST_F(FalseColourFrame, TheWindowAndTheFileAgree) {
  const ResolvedScene scene = sceneOf(makeSphere(64), materialOf(ShadingModel::Skin));
  makeRenderer();
  show(scene);
  const Window window(m_size);
  FrameRequest frame = request(scene);
  frame.aov = Aov::Energy;
  frame.framebuffer = window.framebuffer.id();
  ASSERT_TRUE(m_renderer->renderFrame(frame));
  const auto inWindow = window.read();
  const Image file = m_renderer->readView(Aov::Energy, {}, PixelType::U8);
  const auto rows = static_cast<std::size_t>(m_size.y);
  const std::size_t row = static_cast<std::size_t>(m_size.x) * 4;
  for (std::size_t y = 0; y < rows; ++y)
    for (std::size_t x = 0; x < row; ++x)
      ASSERT_EQ(std::to_integer<int>(file.pixels[y * row + x]), inWindow[(rows - 1 - y) * row + x]) << x << ", " << y;
}

}  // namespace
}  // namespace dermis::test
