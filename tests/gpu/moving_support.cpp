#include "gpu/moving_support.h"

#include <cmath>

#include "core/builtin/environments.h"
#include "core/scene/primitives.h"

namespace dermis::test {

ResolvedScene everything() {
  Material skin = materialOf(ShadingModel::Skin);
  skin.parameters.transmissionThicknessSource = ThicknessSource::Map;
  skin.parameters.transmissionThicknessMinMm = 1.0F;
  skin.parameters.transmissionThicknessMaxMm = 20.0F;
  Model model = makeSphere(256);
  appendModel(model, makeSphere(64), {glm::vec3(0.25F), {}, {-0.5F, 0.5F, 1.1F}});
  ResolvedScene scene = sceneOf(std::move(model), skin);
  scene.environment = builtinEnvironment("studio", 128);
  std::vector<float> albedo, normal, specular, thickness;
  constexpr int kSide = 64;
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      const float wave = 0.5F + 0.5F * std::sin(0.7F * static_cast<float>(x)) * std::cos(0.5F * static_cast<float>(y));
      albedo.insert(albedo.end(), {0.6F + 0.2F * wave, 0.4F + 0.1F * wave, 0.35F});
      normal.insert(normal.end(), {0.5F + 0.1F * std::sin(0.4F * static_cast<float>(x)), 0.5F, 0.98F});
      specular.push_back(0.7F + 0.3F * wave);
      // u = ¼ faces −X, ¾ faces +X.
      const float u = static_cast<float>(x) / kSide;
      thickness.push_back(0.5F - 0.5F * std::sin(6.2831853F * u));
    }
  TextureBinding raw;
  raw.colorSpace = "raw";
  setMap(scene, TextureSlot::Albedo, imageOf(kSide, kSide, 3, PixelType::U8, albedo), raw);
  setMap(scene, TextureSlot::Normal, imageOf(kSide, kSide, 3, PixelType::U8, normal), raw);
  setMap(scene, TextureSlot::Specular, imageOf(kSide, kSide, 1, PixelType::U8, specular), raw);
  setMap(scene, TextureSlot::Thickness, imageOf(kSide, kSide, 1, PixelType::U8, thickness), raw);
  scene.scene.lights = {pointLight({-2.0F, 1.5F, 3.0F}, 3.0F), pointLight({2.5F, 0.5F, 2.0F}, 1.5F),
                        pointLight({0.0F, 3.0F, 1.0F}, 1.0F), pointLight({-1.5F, 0.0F, -3.0F}, 12.0F)};
  scene.scene.lights.back().shadow = false;  // or the ball would hold its light back from the map's thin skin
  return scene;
}

void MovingTest::SetUp() {
  m_size = {kEdge, kEdge};
  FrameTest::SetUp();
}

void MovingTest::makeSoftwareRenderer() {
  RendererOptions options;
  options.software = true;
  makeRenderer(options);
}

FrameRequest MovingTest::movingFrame(const ResolvedScene& scene, const Window& window) const {
  FrameRequest frame = request(scene);
  frame.moving = true;
  frame.framebuffer = window.framebuffer.id();
  return frame;
}

}  // namespace dermis::test
