// How often shadow maps are drawn, which lights have them, and that every way of drawing a frame shows the same ones.
#include <cmath>

#include "core/scene/primitives.h"
#include "gpu/shadow_support.h"

namespace dermis::test {
namespace {

class ShadowCache : public ShadowTest {
 protected:
  std::uint64_t drawn() { return m_renderer->statistics().shadowMapsDrawn; }
};

TEST_F(ShadowCache, MapsAreKeptWhileNothingTheyDependOnMoves) {
  Light light = lampOf(LightType::Spot);
  ResolvedScene scene = litFromAbove(both(ground(), awning()), light);
  scene.scene.lights.push_back(lampOf(LightType::Directional));
  show(scene);
  FrameRequest frame = request(scene);
  frame.moving = true;
  m_renderer->renderFrame(frame);
  EXPECT_EQ(drawn(), 2U);
  for (int i = 0; i < 5; ++i) m_renderer->renderFrame(frame);
  EXPECT_EQ(drawn(), 2U) << "nothing moved";
  for (int i = 0; i < 5; ++i) {
    frame.camera.position.x += 0.005F;
    frame.camera.target.x += 0.005F;
    m_renderer->renderFrame(frame);
  }
  EXPECT_EQ(drawn(), 2U) << "the camera moved a little";
  scene.slots[0].material.parameters.baseAlbedo.rgb = glm::vec3(0.5F);
  scene.scene.environment.rotationDegrees = 20.0F;
  show(scene);
  m_renderer->renderFrame(frame);
  EXPECT_EQ(drawn(), 2U) << "a colour is no caster";
  scene.scene.lights[0].intensity = 5.0F;
  show(scene);
  m_renderer->renderFrame(frame);
  EXPECT_EQ(drawn(), 2U) << "a lamp that is dimmed stands where it stood";
  scene.scene.lights[0].position.x += 0.1F;
  show(scene);
  m_renderer->renderFrame(frame);
  EXPECT_EQ(drawn(), 3U) << "only the lamp that moved";
  frame.camera.orthographicHeight = 0.1F;
  m_renderer->renderFrame(frame);
  EXPECT_GT(drawn(), 3U) << "the maps cover much more than what is seen";
  const std::uint64_t before = drawn();
  scene.model = std::make_shared<Model>(ground());
  scene.slots.resize(1);
  show(scene);
  m_renderer->renderFrame(frame);
  EXPECT_EQ(drawn(), before + 2) << "another model";
}

TEST_F(ShadowCache, LightsWithoutShadowsHaveNoMaps) {
  m_size = {32, 32};
  Light light = lampOf(LightType::Directional);
  light.direction = {1.0F, 0.0F, -1.0F};
  light.shadow = false;
  ResolvedScene scene = litFromAbove(both(ground(), awning()), light);
  const glm::vec4 open = pixel(still(scene, 2), 8, 16);
  EXPECT_EQ(drawn(), 0U);
  EXPECT_GT(open.r, 0.1F);
  scene.scene.lights[0].shadow = true;
  EXPECT_EQ(pixel(still(scene, 2), 8, 16).r, 0.0F) << "x = −0.23 lies in the awning's shadow, −1 to −0.1";
  EXPECT_GT(drawn(), 0U);
  const std::uint64_t before = drawn();
  scene.slots[0].material.model = scene.slots[1].material.model = ShadingModel::Thesis;
  EXPECT_GT(pixel(still(scene, 2), 8, 16).r, 0.1F) << "the published shader has none";
  EXPECT_EQ(drawn(), before);
}

// Sixteen lamps in a row, each with its own shadow of the awning's edge: what arrives is the sum of what each sends.
TEST_F(ShadowCache, SixteenLightsAtOnce) {
  m_size = {48, 48};
  std::vector<Light> lights;
  for (int i = 0; i < 16; ++i) {
    Light light = lampOf(i % 2 == 0 ? LightType::Point : LightType::Directional);
    light.intensity = 1.0F;
    light.position.x = -1.6F + 0.05F * static_cast<float>(i);
    light.direction = glm::normalize(glm::vec3(0.6F + 0.04F * static_cast<float>(i), 0.0F, -1.0F));
    lights.push_back(light);
  }
  ResolvedScene scene = litFromAbove(both(ground(), awning()), lights[0]);
  std::vector<double> sum(48 * 48, 0.0);
  for (const Light& light : lights) {
    scene.scene.lights = {light};
    const Image one = still(scene, 16);
    for (int y = 0; y < 48; ++y)
      for (int x = 0; x < 48; ++x) sum[at(x, y)] += static_cast<double>(pixel(one, x, y).r);
  }
  scene.scene.lights = lights;
  const Image all = still(scene, 16);
  double most = 0.0, least = 1e9;
  for (int y = 0; y < 48; ++y)
    for (int x = 0; x < 48; ++x) {
      most = std::max(most, sum[at(x, y)]);
      least = std::min(least, sum[at(x, y)]);
      EXPECT_NEAR(static_cast<double>(pixel(all, x, y).r), sum[at(x, y)], 0.03 * sum[at(x, y)] + 0.02) << x << ' ' << y;
    }
  EXPECT_GT(most, 2.0 * least) << "there must be shadows";
}

// A moving picture of a dense mesh is drawn in two steps on software GL: its shadows are those of the direct way.
TEST_F(ShadowCache, DeferredPicturesHaveTheSameShadows) {
  m_size = {96, 96};
  Light light = lampOf(LightType::Point);
  light.position = {-2.0F, 1.0F, 2.0F};
  light.intensity = 6.0F;
  Model model = makeSphere(256);
  Model ball = makeSphere(64);
  appendModel(model, ball, {glm::vec3(0.3F), {}, {-0.9F, 0.4F, 1.0F}});
  ResolvedScene scene = litFromAbove(std::move(model), light, {0.0F, 0.0F}, 1.1F);
  const std::vector<std::vector<std::uint8_t>> pictures = {movingPicture(scene, true), movingPicture(scene, false)};
  ASSERT_EQ(pictures[0].size(), pictures[1].size());
  int different = 0, lit = 0, dark = 0;
  for (std::size_t i = 0; i < pictures[0].size(); i += 4) {
    const int a = pictures[0][i], b = pictures[1][i];
    if (pictures[1][i + 3] == 255) (b > 60 ? lit : dark) += 1;
    if (std::abs(a - b) > 12) ++different;
  }
  EXPECT_GT(lit, 500);
  EXPECT_GT(dark, 500);
  // The outlines are smoothed in two different ways.
  EXPECT_LT(different, 96 * 96 / 50);
}

}  // namespace
}  // namespace dermis::test
