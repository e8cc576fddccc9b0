// Normal map, detail normal with its mask, cavity: against their formulas in doubles; and what happens to normals that
// a pixel can't resolve.
#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <numbers>
#include <random>

#include "core/scene/primitives.h"
#include "gpu/frame_support.h"
#include "gpu/gl_fixture.h"
#include "reference/microfacet.h"

namespace dermis::test {
namespace {

glm::dvec3 slope(double x, double y) { return glm::normalize(glm::dvec3(x, y, 1.0)); }
std::vector<float> encoded(const glm::dvec3& n) {
  return {static_cast<float>(0.5 + 0.5 * n.x), static_cast<float>(0.5 + 0.5 * n.y),
          static_cast<float>(0.5 + 0.5 * n.z)};
}
std::shared_ptr<const Image> normalMap(const glm::dvec3& n) { return imageOf(1, 1, 3, PixelType::Float, encoded(n)); }
double degreesBetween(const glm::dvec3& a, const glm::dvec3& b) {
  return std::acos(std::clamp(glm::dot(glm::normalize(a), glm::normalize(b)), -1.0, 1.0)) * 180.0 / std::numbers::pi;
}

class DetailNormal : public FrameTest {
 protected:
  static ResolvedScene skinPlane() { return sceneOf(makePlane(), materialOf(ShadingModel::Skin)); }
  Image normals(const ResolvedScene& scene) {
    m_renderer->keepAovs({Aov::Normal});
    still(scene);
    return m_renderer->readAov(Aov::Normal);
  }
};

TEST_F(DetailNormal, LiesOnTheBaseAsIfThatWereFlat) {
  const glm::dvec3 base = slope(0.5, -0.3), detail = slope(-0.2, 0.4);
  ResolvedScene scene = skinPlane();
  MaterialParameters& p = scene.slots[0].material.parameters;
  setMap(scene, TextureSlot::Normal, normalMap(base));
  EXPECT_LT(degreesBetween(glm::dvec3(pixel(normals(scene), 24, 24)), base), 0.1);
  setMap(scene, TextureSlot::DetailNormal, normalMap(detail));
  EXPECT_LT(degreesBetween(glm::dvec3(pixel(normals(scene), 24, 24)), base), 0.1) << "detail_strength is 0";
  for (const double strength : {0.5, 1.0, 2.0})
    for (const double mask : {-1.0, 0.0, 0.4, 1.0}) {  // −1: no map, which counts as 1
      p.surfaceDetailStrength = static_cast<float>(strength);
      if (mask >= 0.0)
        setMap(scene, TextureSlot::DetailMask, imageOf(1, 1, 1, PixelType::Float, {static_cast<float>(mask)}));
      else
        scene.slots[0].images.at(static_cast<std::size_t>(TextureSlot::DetailMask)) = nullptr;
      // The turn that takes +Z to the base normal, about the axis across both, applied to the detail.
      const double factor = strength * (mask < 0.0 ? 1.0 : mask);
      const glm::dvec3 bent = slope(factor * detail.x / detail.z, factor * detail.y / detail.z);
      const glm::dvec3 axis = glm::normalize(glm::cross(glm::dvec3(0, 0, 1), base));
      const glm::dvec3 want = glm::angleAxis(std::acos(base.z), axis) * bent;
      EXPECT_LT(degreesBetween(glm::dvec3(pixel(normals(scene), 24, 24)), want), 0.1)
          << "strength " << strength << ", mask " << mask;
    }
}

TEST_F(DetailNormal, StrengthFlipAndScaleActOnTheSlope) {
  ResolvedScene scene = skinPlane();
  scene.slots[0].material.parameters.surfaceNormalStrength = 1.5F;
  TextureBinding binding;
  binding.flipGreen = true;
  binding.scale = 0.5F;
  setMap(scene, TextureSlot::Normal, normalMap(slope(0.4, 0.2)), binding);
  EXPECT_LT(degreesBetween(glm::dvec3(pixel(normals(scene), 24, 24)), slope(0.3, -0.15)), 0.1);
}

TEST_F(DetailNormal, TilesOverTheUnitSquare) {
  ResolvedScene scene = skinPlane();
  MaterialParameters& p = scene.slots[0].material.parameters;
  p.surfaceDetailStrength = 1.0F;
  p.surfaceDetailTiling = 3.0F;
  // Left half leans left, right half right.
  std::vector<float> texels;
  for (int x = 0; x < 16; ++x)
    for (const float value : encoded(slope(x < 8 ? -0.5 : 0.5, 0.0))) texels.push_back(value);
  setMap(scene, TextureSlot::DetailNormal, imageOf(16, 1, 3, PixelType::Float, texels));
  const Image image = normals(scene);
  for (int tile = 0; tile < 3; ++tile) {
    EXPECT_NEAR(pixel(image, 16 * tile + 4, 10).r, -slope(0.5, 0.0).x, 0.01);
    EXPECT_NEAR(pixel(image, 16 * tile + 12, 30).r, slope(0.5, 0.0).x, 0.01);
  }
}

TEST_F(DetailNormal, AMapWithoutZIsGivenOne) {
  // Red and green are a normal's, blue is something else's.
  ResolvedScene scene = skinPlane();
  scene.slots[0].material.parameters.surfaceDetailStrength = 1.0F;
  const glm::dvec3 n = slope(0.3, -0.2);
  std::vector<float> texels;
  for (int i = 0; i < 16; ++i)
    for (const float value :
         {static_cast<float>(0.5 + 0.5 * n.x), static_cast<float>(0.5 + 0.5 * n.y), 0.05F * static_cast<float>(i)})
      texels.push_back(value);
  setMap(scene, TextureSlot::DetailNormal, imageOf(4, 4, 3, PixelType::U8, texels));
  const Image image = normals(scene);
  for (int y = 2; y < 48; y += 9)
    for (int x = 2; x < 48; x += 9) EXPECT_LT(degreesBetween(glm::dvec3(pixel(image, x, y)), n), 0.6) << x << ", " << y;
}

TEST_F(DetailNormal, CavityTakesReflectionAndNothingElse) {
  ResolvedScene scene = skinPlane();
  m_renderer->keepAovs({Aov::Specular, Aov::Diffuse});
  still(scene);
  const float open = pixel(m_renderer->readAov(Aov::Specular), 24, 24).r;
  const float body = pixel(m_renderer->readAov(Aov::Diffuse), 24, 24).r;
  setMap(scene, TextureSlot::Cavity, imageOf(1, 1, 1, PixelType::Float, {0.5F}));
  scene.slots[0].material.parameters.specularCavity = 0.6F;
  still(scene);
  EXPECT_NEAR(pixel(m_renderer->readAov(Aov::Specular), 24, 24).r, 0.3F * open, 1e-4F);
  EXPECT_EQ(pixel(m_renderer->readAov(Aov::Diffuse), 24, 24).r, body);
}

// Bumps far finer than a pixel: the highlight that they make together.
TEST_F(DetailNormal, UnresolvedNormalsWidenTheLobe) {
  m_size = {96, 96};
  constexpr int kTexels = 1024;
  std::mt19937 random(5);
  std::normal_distribution<double> slopes(0.0, 0.25);
  std::vector<float> texels;
  std::vector<glm::dvec3> bumps;
  for (int i = 0; i < kTexels * kTexels; ++i) {
    const glm::dvec3 n = slope(slopes(random), slopes(random));
    if (i % 997 == 0) bumps.push_back(n);
    for (const float value : encoded(n)) texels.push_back(value);
  }
  ResolvedScene scene = sceneOf(makePlane(), materialOf(ShadingModel::MetallicRoughness), glm::vec3(0.0F));
  MaterialParameters& p = scene.slots[0].material.parameters;
  p.baseAlbedo.rgb = glm::vec3(1.0F);
  p.baseMetallic = 1.0F;
  p.specularPerceptualRoughness = 0.5F;
  Light lamp;
  lamp.type = LightType::Directional;
  lamp.intensity = 1.0F;
  lamp.shadow = false;
  setMap(scene, TextureSlot::Normal, imageOf(kTexels, kTexels, 3, PixelType::U8, texels));
  // The truth is the mean over the bumps, seen at each angle of the lamp.
  const reference::Layer narrow(glm::dvec3(0.04), {{0.5, 1.0}}, glm::dvec3(1.0), 1.0);
  double total = 0.0, totalTruth = 0.0;
  for (const double degrees : {0.0, 20.0, 40.0, 60.0}) {
    const double angle = degrees * std::numbers::pi / 180.0;
    const glm::dvec3 l(std::sin(angle), 0.0, std::cos(angle)), v(0.0, 0.0, 1.0);
    lamp.direction = -glm::vec3(l);
    scene.scene.lights = {lamp};
    const double got = static_cast<double>(pixel(still(scene), 48, 48).r);
    double truth = 0.0;
    for (const glm::dvec3& n : bumps) {
      if (glm::dot(n, l) <= 0.0) continue;
      // Projected area of the facet over its share of the plane.
      truth += glm::dot(n, v) / n.z * narrow.brdf(n, v, l).x * glm::dot(n, l) / static_cast<double>(bumps.size());
    }
    total += got;
    totalTruth += truth;
    EXPECT_GT(got, 0.5 * truth) << degrees;
    EXPECT_LT(got, 2.0 * truth) << degrees;
    RecordProperty("at " + std::to_string(degrees), std::to_string(got / truth));
  }
  // Adding variances is exact for Beckmann's lobe. GGX has long tails, so its core comes out up to 1.6 times too
  // bright; without widening it would be 4 times.
  EXPECT_NEAR(total / totalTruth, 1.0, 0.4);
  // And none of it where each texel is a pixel's.
  setMap(scene, TextureSlot::Normal, normalMap(slope(0.0, 0.0)));
  lamp.direction = {0.0F, 0.0F, -1.0F};
  scene.scene.lights = {lamp};
  const glm::dvec3 up(0.0, 0.0, 1.0);
  EXPECT_NEAR(pixel(still(scene), 48, 48).r, narrow.brdf(up, up, up).x, 0.005 * narrow.brdf(up, up, up).x);
}

}  // namespace
}  // namespace dermis::test
