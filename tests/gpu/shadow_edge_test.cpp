// Shadows lie where geometry says: edges, contacts, and no shadow where there is nothing in the way.
#include <algorithm>
#include <array>
#include <cmath>

#include "core/scene/primitives.h"
#include "gpu/shadow_support.h"

namespace dermis::test {
namespace {

constexpr std::array<LightType, 5> kTypes = {LightType::Point, LightType::Directional, LightType::Spot,
                                             LightType::Sphere, LightType::Rect};

/// Where the shadow of the awning's edge x = −0.6 falls in the row of the ground at `y`.
double edgeOnGround(const Light& light, double y, double height) {
  // The edge is a line along y: what counts is the plane through it and the light, in x and z.
  if (light.type == LightType::Directional) {
    const dvec3 l = towards(light, dvec3(0.0));
    return -0.6 - height * l.x / l.z;
  }
  const dvec3 lamp(light.position);
  const double t = lamp.z / (lamp.z - height);
  static_cast<void>(y);
  return lamp.x + t * (-0.6 - lamp.x);
}

class ShadowEdge : public ShadowTest {};

// The edge of a converged shadow is a step: its place is the sum of what is dark, and no pixel further than one and a
// half from it is anything but dark or lit.
TEST_F(ShadowEdge, FallsWhereTheLightSaysForEachType) {
  m_size = {96, 96};
  const double height = 0.5;
  const double pixelWidth = 1.0 / 96.0;
  for (const LightType type : kTypes) {
    const Light light = lampOf(type);
    const ResolvedScene scene = litFromAbove(both(ground(), awning(height)), light);
    const std::vector<double> share = arriving(scene, 64);
    double sum = 0.0, worst = 0.0;
    int rows = 0, blurred = 0;
    for (int y = 24; y < 72; ++y) {
      const double edge = edgeOnGround(light, -across(y), height);
      double dark = 0.0;
      for (int x = 0; x < m_size.x; ++x) {
        const double value = share[at(x, y)];
        ASSERT_GE(value, 0.0) << "unlit";
        dark += 1.0 - value;
        const double off = std::abs(across(x) - edge) / pixelWidth;
        if (off > 1.5 && std::min(value, 1.0 - value) > 0.005) ++blurred;
      }
      const double found = -0.5 + dark * pixelWidth;
      sum += found - edge;
      worst = std::max(worst, std::abs(found - edge) / pixelWidth);
      ++rows;
    }
    EXPECT_EQ(blurred, 0) << "type " << static_cast<int>(type);
    EXPECT_LT(worst, 0.25) << "pixels, type " << static_cast<int>(type);
    EXPECT_LT(std::abs(sum / rows) / pixelWidth, type == LightType::Sphere ? 0.1 : 0.05)
        << "pixels, type " << static_cast<int>(type);
    ::testing::Test::RecordProperty(
        "edge of type " + std::to_string(static_cast<int>(type)),
        std::to_string(worst) + " pixels at worst, " + std::to_string(sum / rows / pixelWidth) + " in the mean");
  }
}

// A lit plane and a lit sphere hold nothing back from themselves, however low the light is.
TEST_F(ShadowEdge, NothingShadowsItself) {
  m_size = {64, 64};
  for (const LightType type : kTypes)
    for (const float low : {0.03F, 0.1F, 0.4F, 1.5F}) {
      Light light = lampOf(type);
      light.direction = glm::normalize(glm::vec3(1.0F, 0.2F, -low));
      light.position = -8.0F * light.direction;
      light.outerDegrees = 30.0F;
      light.innerDegrees = 29.0F;
      for (const bool sphere : {false, true})
        for (const int samples : {1, 8}) {
          const ResolvedScene scene = litFromAbove(sphere ? makeSphere(128) : ground(), light);
          const std::vector<double> share = arriving(scene, samples);
          int wrong = 0;
          double least = 1.0;
          for (int y = 0; y < m_size.y; ++y)
            for (int x = 0; x < m_size.x; ++x) {
              const double px = across(x), py = -across(y);
              const double height = sphere ? std::sqrt(1.0 - px * px - py * py) : 0.0;
              const dvec3 point(px, py, height), normal = sphere ? point : dvec3(0.0, 0.0, 1.0);
              if (share[at(x, y)] < 0.0 || glm::dot(normal, towards(light, point)) < 0.03) continue;
              least = std::min(least, share[at(x, y)]);
              if (share[at(x, y)] < 0.999) ++wrong;
            }
          EXPECT_EQ(wrong, 0) << (sphere ? "sphere" : "plane") << ", type " << static_cast<int>(type) << ", low " << low
                              << ", samples " << samples << ", least " << least;
        }
    }
}

// A box that stands on the ground: its shadow begins at its foot, and so does the light on the other side.
TEST_F(ShadowEdge, BeginsAtTheContact) {
  m_size = {100, 100};
  Light light = lampOf(LightType::Directional);
  light.direction = glm::normalize(glm::vec3(1.0F, 0.0F, -1.0F));
  // A wall at x = 0, ten times as thin as a pixel, 0.3 high.
  Model scene = both(ground(), quad({0, -1, 0}, {0, 1, 0}, {0, 1, 0.3}, {0, -1, 0.3}, "wall"));
  const std::vector<double> share = arriving(litFromAbove(std::move(scene), light));
  for (int y = 20; y < 80; ++y)
    for (int x = 0; x < 100; ++x) {
      const double px = across(x);
      if (std::abs(px) < 0.0101 || std::abs(px - 0.3) < 0.0101) continue;  // the pixels that hold an edge
      EXPECT_NEAR(share[at(x, y)], px > 0.0 && px < 0.3 ? 0.0 : 1.0, 0.005) << px;
    }
}

// The camera hangs below the awning, which it can't see and which lies behind it.
TEST_F(ShadowEdge, CastersBehindTheCameraCount) {
  m_size = {64, 64};
  Light light = lampOf(LightType::Point);
  light.position = {-1.0F, 0.0F, 2.0F};
  Model model = both(ground(), awning(1.5));
  ResolvedScene scene = litFromAbove(std::move(model), light);
  scene.camera.orthographicHeight.reset();
  scene.camera.position = {-1.0F, 0.0F, 0.6F};
  scene.camera.target = {-1.0F, 0.0F, 0.0F};
  scene.camera.verticalFovDegrees = 40.0F;
  const std::vector<double> share = arriving(scene, 4);
  EXPECT_LT(*std::max_element(share.begin(), share.end()), 1e-6);
}

// One side is enough: an open sheet casts, whichever side it turns to the light.
TEST_F(ShadowEdge, SheetsCastFromBothSides) {
  m_size = {32, 32};
  for (const bool turned : {false, true}) {
    Model sheet = turned ? quad({-1, -1, 0.5}, {-1, 1, 0.5}, {1, 1, 0.5}, {1, -1, 0.5}, "sheet")
                         : quad({-1, -1, 0.5}, {1, -1, 0.5}, {1, 1, 0.5}, {-1, 1, 0.5}, "sheet");
    Light light = lampOf(LightType::Directional);
    light.direction = {1.0F, 0.0F, -2.0F};
    ResolvedScene scene = litFromAbove(both(ground(), sheet), light);
    scene.camera.position.z = 0.4F;
    scene.camera.orthographicHeight.reset();
    scene.camera.verticalFovDegrees = 60.0F;
    const std::vector<double> share = arriving(scene, 2);
    EXPECT_EQ(share[at(16, 16)], 0.0) << turned;
  }
}

// A lamp between what it lights needs to look all round.
TEST_F(ShadowEdge, LampBetweenTwoWalls) {
  m_size = {64, 64};
  Light light = lampOf(LightType::Point);
  light.position = {0.0F, 0.0F, 0.4F};
  // A low wall all round the lamp at a distance of 0.2, 0.2 high: the ground is dark from 0.2 to 0.4 along the axes.
  Model model = ground();
  model = both(model, quad({0.2, -0.2, 0}, {0.2, 0.2, 0}, {0.2, 0.2, 0.2}, {0.2, -0.2, 0.2}, "a"));
  model = both(model, quad({-0.2, -0.2, 0}, {-0.2, 0.2, 0}, {-0.2, 0.2, 0.2}, {-0.2, -0.2, 0.2}, "b"));
  model = both(model, quad({-0.2, 0.2, 0}, {0.2, 0.2, 0}, {0.2, 0.2, 0.2}, {-0.2, 0.2, 0.2}, "c"));
  model = both(model, quad({-0.2, -0.2, 0}, {0.2, -0.2, 0}, {0.2, -0.2, 0.2}, {-0.2, -0.2, 0.2}, "d"));
  // And a wall above the lamp, so that it lies inside the model.
  model = both(model, quad({-2, 1.5, -1}, {2, 1.5, -1}, {2, 1.5, 2}, {-2, 1.5, 2}, "e"));
  const std::vector<double> share = arriving(litFromAbove(std::move(model), light));
  for (int i = 0; i < 64; ++i) {
    const double r = std::abs(across(i));
    if (std::abs(r - 0.2) < 0.025 || std::abs(r - 0.4) < 0.025) continue;
    const double want = r > 0.2 && r < 0.4 ? 0.0 : 1.0;
    EXPECT_NEAR(share[at(i, 32)], want, 0.01) << "along x at " << across(i);
    EXPECT_NEAR(share[at(32, i)], want, 0.01) << "along y at " << across(i);
  }
}

// What a mask cuts out of a caster is not in the way.
TEST_F(ShadowEdge, CutOutsLetLightThrough) {
  m_size = {64, 64};
  Light light = lampOf(LightType::Directional);
  light.direction = {1.0F, 0.0F, -1.0F};
  ResolvedScene scene = litFromAbove(both(ground(), awning(0.5)), light, {-0.55F, 0.0F}, 0.5F);
  scene.camera.position.z = 0.45F;  // the awning is above
  scene.camera.orthographicHeight.reset();
  scene.camera.verticalFovDegrees = 70.0F;
  // Alpha by columns: the half towards −x is solid.
  Material& material = scene.slots[1].material;
  material.parameters.metallicRoughnessAlphaMode = AlphaMode::Mask;
  material.parameters.metallicRoughnessAlphaCutoff = 0.5F;
  std::vector<float> texels;
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 8; ++x) texels.insert(texels.end(), {1.0F, 1.0F, 1.0F, x < 4 ? 1.0F : 0.0F});
  scene.slots[1].images.at(static_cast<std::size_t>(TextureSlot::Albedo)) = imageOf(8, 8, 4, PixelType::U8, texels);
  material.texture(TextureSlot::Albedo).path = "mask.png";
  const std::vector<double> share = arriving(scene, 4);
  // On the ground the awning's −1.5..−0.6 is −1.0..−0.1, its middle −0.55: the middle of the picture.
  EXPECT_LT(share[at(20, 32)], 0.01);
  EXPECT_GT(share[at(44, 32)], 0.99);
}

}  // namespace
}  // namespace dermis::test
