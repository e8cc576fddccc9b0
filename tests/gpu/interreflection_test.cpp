// Light that a body sends to itself, in scenes whose answer is known.
#include <cmath>

#include "core/scene/primitives.h"
#include "gpu/frame_support.h"

namespace dermis::test {
namespace {

class Interreflection : public FrameTest {
 protected:
  void SetUp() override {
    FrameTest::SetUp();
    RendererOptions options;
    options.bakeMeshes = true;
    makeRenderer(options);
    m_renderer->keepAovs({Aov::Occlusion});
  }
};

Material matt(const glm::vec3& albedo) {
  Material material = materialOf(ShadingModel::Skin);
  MaterialParameters& p = material.parameters;
  p.baseAlbedo.rgb = albedo;
  p.specularIntensity = 0.0F;
  p.subsurfaceWeight = 0.0F;
  p.transmissionWeight = 0.0F;
  return material;
}

TEST_F(Interreflection, WhiteBodyInAWhiteWorldIsWhite) {
  Model model;
  appendModel(model, makeSphere(96), {glm::vec3(0.42F), {}, {-0.35F, 0.0F, 0.0F}});
  appendModel(model, makeSphere(96), {glm::vec3(0.4F), {}, {0.45F, 0.1F, 0.2F}});
  for (const float intensity : {0.0F, 1.0F}) {
    Material material = matt(glm::vec3(1.0F));
    material.parameters.specularIntensity = intensity;
    ResolvedScene scene = sceneOf(model, material);
    scene.scene.environment.background.kind = BackgroundKind::None;
    const Image picture = still(scene);
    int seen = 0, hidden = 0;
    const Image occlusion = m_renderer->readAov(Aov::Occlusion);
    for (int y = 0; y < picture.height; ++y)
      for (int x = 0; x < picture.width; ++x) {
        const glm::vec4 colour = pixel(picture, x, y);
        if (colour.a < 1.0F) continue;
        ++seen;
        hidden += pixel(occlusion, x, y).r < 0.8F ? 1 : 0;
        for (int c = 0; c < 3; ++c) {
          ASSERT_GE(colour[c], 0.995F) << x << ", " << y << ", specular " << intensity;
          ASSERT_LE(colour[c], 1.005F) << x << ", " << y << ", specular " << intensity;
        }
      }
    EXPECT_GT(seen, 400);
    EXPECT_GT(hidden, 30) << "somewhere there is light to be lost";
  }
}

// A lamp that grazes the floor lights a wall at its side, and the wall the floor: by its albedo times its form factor.
TEST_F(Interreflection, WallLightsTheFloorInItsColour) {
  constexpr float kHeight = 0.8F, kWall = -0.9F;
  const Model plane = planeOf(40);
  Model model;
  appendModel(model, plane, {{0.9F, 20.0F, 1.0F}, {}, {0.0F, 0.0F, 0.0F}});
  appendModel(model, plane, {{0.5F * kHeight, 20.0F, 1.0F}, {0.0F, 90.0F, 0.0F}, {kWall, 0.0F, 0.5F * kHeight}});
  const glm::vec3 albedo(0.8F, 0.4F, 0.2F);
  ResolvedScene scene = sceneOf(model, matt(albedo), glm::vec3(0.0F));
  Light lamp;
  lamp.type = LightType::Directional;
  lamp.direction = {-1.0F, 0.0F, 0.0F};
  lamp.intensity = 3.14159265F;
  scene.scene.lights = {lamp};
  const Image picture = still(scene);
  for (const int x : {6, 12, 20}) {
    const glm::vec3 colour = pixel(picture, x, m_size.y / 2);
    const float d = 2.0F * (static_cast<float>(x) + 0.5F) / static_cast<float>(m_size.x) - 1.0F - kWall;
    const float factor = 0.5F * (1.0F - d / std::sqrt(d * d + kHeight * kHeight));
    for (int c = 0; c < 3; ++c) {
      // Once by the wall, which sends on its albedo; the floor sends that to the viewer times its own. What goes to and
      // fro between them adds at most what either sends to the other. For the wall the lamp stands on the border of
      // what the floor hides, where nine coefficients are a quarter too dark.
      const float once = albedo[c] * albedo[c] * factor;
      EXPECT_GT(colour[c], 0.7F * once) << "x " << x << ", channel " << c;
      EXPECT_LT(colour[c], once / (1.0F - 0.5F * albedo[c])) << "x " << x << ", channel " << c;
    }
  }
}

}  // namespace
}  // namespace dermis::test
