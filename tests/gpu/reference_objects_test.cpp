// Balls and chart against what their light is by hand: albedo times irradiance over π.
#include <cmath>
#include <numbers>

#include "core/scene/primitives.h"
#include "gpu/frame_support.h"
#include "passes/reference_objects.h"

namespace dermis::test {
namespace {

class ReferenceObjectsTest : public FrameTest {
 protected:
  void SetUp() override {
    FrameTest::SetUp();
    m_size = {200, 200};
    makeRenderer();
  }
  /// A plane that is black and small: all light there is comes from what stands before it.
  Image drawn(const ResolvedScene& scene, const ReferenceObjects& objects) {
    show(scene);
    FrameRequest frame = request(scene, 1);  // at the middles of pixels
    frame.references = objects;
    m_layout = referenceLayout(objects, m_size);
    do EXPECT_TRUE(m_renderer->renderFrame(frame));
    while (m_renderer->accumulating());
    return m_renderer->readAov(Aov::Beauty);
  }
  [[nodiscard]] glm::vec3 at(const Image& image, glm::vec2 fromLowerLeft) const {
    return glm::vec3(pixel(image, static_cast<int>(fromLowerLeft.x), m_size.y - 1 - static_cast<int>(fromLowerLeft.y)));
  }
  ReferenceLayout m_layout;
};

TEST_F(ReferenceObjectsTest, TheGreyBallSendsBackItsAlbedoOfAnEvenWorld) {
  const glm::vec3 sky(0.5F, 1.0F, 2.0F);
  const Image image = drawn(sceneOf(makePlane(), emissive(glm::vec3(0.0F)), sky), {.balls = true, .chart = false});
  // Irradiance is π times the radiance.
  EXPECT_THAT(at(image, m_layout.grey), IsColour(0.18F * sky, 0.004F));
  EXPECT_THAT(at(image, m_layout.grey + glm::vec2(0.6F * m_layout.radius)), IsColour(0.18F * sky, 0.004F));
}

TEST_F(ReferenceObjectsTest, TheGreyBallIsLitByLampsAsLambertSays) {
  ResolvedScene scene = sceneOf(makePlane(), emissive(glm::vec3(0.0F)), glm::vec3(0.0F));
  Light sun;
  sun.type = LightType::Directional;
  sun.direction = {-0.6F, 0.0F, -0.8F};
  sun.intensity = 3.0F;
  sun.shadow = false;
  scene.scene.lights = {sun};
  const Image image = drawn(scene, {.balls = true, .chart = false});
  // The camera looks along −Z: on the ball x and y of the normal are the place on it.
  for (const glm::vec2 place : {glm::vec2(0.0F), glm::vec2(0.5F, 0.2F), glm::vec2(-0.3F, -0.5F)}) {
    const glm::vec2 shown = glm::floor(m_layout.grey + place * m_layout.radius) + 0.5F;
    const glm::vec2 n = (shown - m_layout.grey) / m_layout.radius;
    const glm::vec3 normal(n, std::sqrt(1.0F - glm::dot(n, n)));
    const float received = 3.0F * std::max(glm::dot(normal, -sun.direction), 0.0F);
    const float expected = 0.18F * received / std::numbers::pi_v<float>;
    EXPECT_THAT(at(image, shown), IsColour(glm::vec3(expected), 0.01F * expected + 0.001F)) << place.x << place.y;
  }
}

TEST_F(ReferenceObjectsTest, TheChartShowsItsPublishedReflectances) {
  const Image image =
      drawn(sceneOf(makePlane(), emissive(glm::vec3(0.0F)), glm::vec3(1.0F)), {.balls = false, .chart = true});
  for (int i = 0; i < 24; ++i) {
    const glm::vec3 patch = chartPatches().at(static_cast<std::size_t>(i));
    EXPECT_THAT(at(image, m_layout.patch(i)), IsColour(patch, 0.004F + 0.01F * glm::length(patch))) << i;
  }
  // The maker's older sRGB figures (dark skin 115 82 68, neutral 5 122 122 121), as reflectances: another edition of
  // the same chart, so near and not equal.
  const auto linear = [](int code) {
    const float c = static_cast<float>(code) / 255.0F;
    return c <= 0.04045F ? c / 12.92F : std::pow((c + 0.055F) / 1.055F, 2.4F);
  };
  EXPECT_THAT(chartPatches()[0], IsColour(glm::vec3(linear(115), linear(82), linear(68)), 0.02F));
  EXPECT_THAT(chartPatches()[21], IsColour(glm::vec3(linear(122), linear(122), linear(121)), 0.02F));
}

TEST_F(ReferenceObjectsTest, TheChromeBallMirrorsTheWorld) {
  const glm::vec3 sky(1.0F);
  const Image image = drawn(sceneOf(makePlane(), emissive(glm::vec3(0.0F)), sky), {.balls = true, .chart = false});
  EXPECT_THAT(at(image, m_layout.chrome), IsColour(glm::vec3(0.549F, 0.556F, 0.554F), 0.01F));
}

TEST_F(ReferenceObjectsTest, NothingIsDrawnWhenNothingIsAskedFor) {
  const ResolvedScene scene = sceneOf(makePlane(), emissive(glm::vec3(0.2F)), glm::vec3(1.0F));
  const Image with = drawn(scene, {.balls = true, .chart = true});
  const Image without = drawn(scene, {});
  EXPECT_GT(largestDifference(with, without), 0.1F);
  const Image again = drawn(scene, {});
  EXPECT_EQ(largestDifference(without, again), 0.0F);
}

TEST_F(ReferenceObjectsTest, APixelReadsOutAsItIsInThePicture) {
  const ResolvedScene scene = sceneOf(makePlane(), emissive(glm::vec3(0.25F, 0.5F, 0.125F)), glm::vec3(0.0F));
  const Image image = still(scene, 2);
  ViewSettings raw;
  raw.transform = "Raw";
  const auto readout = m_renderer->readPixel({100, 60}, raw);
  ASSERT_TRUE(readout.has_value());
  EXPECT_THAT(readout->radiance, IsColour(pixel(image, 100, 60), 1e-6F));
  EXPECT_THAT(readout->display, IsColour(glm::vec3(0.25F, 0.5F, 0.125F), 1e-3F));
  EXPECT_FALSE(m_renderer->readPixel({200, 0}, raw).has_value());
}

}  // namespace
}  // namespace dermis::test
