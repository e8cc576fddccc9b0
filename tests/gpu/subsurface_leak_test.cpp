// Who gives light to whom: not other objects, not other materials; and white stays white.
#include <algorithm>

#include "gpu/subsurface_support.h"

namespace dermis::test {
namespace {

class SubsurfaceLeak : public SubsurfaceTest {
 protected:
  /// The map lights the right half only. 1 unit is 10 mm.
  static ResolvedScene halves(const Material& material, float behindMm, bool sameSlot) {
    ResolvedScene scene = sceneOf(twoHalves(0.1F * behindMm, sameSlot), material);
    scene.millimetresPerUnit = 10.0F;
    setMap(scene, TextureSlot::Albedo, stepMap());
    return scene;
  }
  /// The brightest pixel of the dark half, a pixel away from the edge that anti-aliasing mixes.
  static float brightestOfDark(const Image& image) {
    float most = 0.0F;
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width / 2 - 1; ++x)
        for (int c = 0; c < 3; ++c) most = std::max(most, pixel(image, x, y)[c]);
    return most;
  }
};

TEST_F(SubsurfaceLeak, FiveMillimetresApartGivesNothing) {
  m_size = {120, 120};
  const Material defaultSkin = [] {
    Material material = bareSkin();
    const MaterialParameters standard;
    material.parameters.subsurfaceRadiusMm = standard.subsurfaceRadiusMm;
    material.parameters.subsurfaceRadiusReading = standard.subsurfaceRadiusReading;
    return material;
  }();
  for (const bool sameSlot : {true, false}) {
    const ResolvedScene scene = halves(defaultSkin, 5.0F, sameSlot);
    // Black is an albedo of 1e-5 to the shader.
    EXPECT_LE(brightestOfDark(still(scene, 32)), 1.1e-5F) << sameSlot;
    EXPECT_LE(brightestOfDark(moving(scene)), 1.1e-5F) << sameSlot;
  }
  // The same without the step does exchange.
  EXPECT_GT(brightestOfDark(still(halves(defaultSkin, 0.0F, true), 8)), 0.2F);
  EXPECT_GT(brightestOfDark(moving(halves(defaultSkin, 0.0F, true))), 0.2F);
}

TEST_F(SubsurfaceLeak, NeighbouringMaterialsGiveNothing) {
  m_size = {96, 96};
  ResolvedScene scene = halves(bareSkin(), 0.0F, false);
  scene.slots[1].material.parameters.subsurfaceScale = 2.0F;
  EXPECT_LE(brightestOfDark(still(scene, 16)), 1.1e-5F);
  EXPECT_LE(brightestOfDark(moving(scene)), 1.1e-5F);
}

// What would have come from the neighbour is tinted; black keeps only the light of the own side.
TEST_F(SubsurfaceLeak, BoundaryColour) {
  m_size = {96, 96};
  Material material = bareSkin();
  material.parameters.subsurfaceRadiusMm = glm::vec3(0.3F);
  ResolvedScene scene = halves(material, 0.0F, false);
  scene.slots[1].material.parameters.subsurfaceBoundaryColor.rgb = {1.0F, 0.5F, 0.0F};
  const Image picture = still(scene, 64);
  const DiffusionProfile profile = DiffusionProfile::burley(glm::dvec3(0.3));
  const double mmPerPixel = 20.0 / 96;
  for (const int column : {48, 50, 54}) {
    const glm::vec4 seen = pixel(picture, column, 48);
    double own = 0.0;  // share of the profile on the own side, over the pixel
    for (int i = 0; i < 9; ++i) own += profile.edgeSpread((column - 48 + (i + 0.5) / 9) * mmPerPixel).x / 9.0;
    EXPECT_NEAR(seen.r, 1.0, 0.005) << column;
    EXPECT_NEAR(seen.g, own + 0.5 * (1.0 - own), 0.02) << column;
    EXPECT_NEAR(seen.b, own, 0.03) << column;
  }
}

TEST_F(SubsurfaceLeak, WhiteStaysWhite) {
  m_size = {96, 96};
  Material material = bareSkin();
  material.parameters.specularIntensity = 1.0F;
  for (const float mm : {0.3F, 3.0F, 30.0F}) {
    material.parameters.subsurfaceRadiusMm = {mm, 0.5F * mm, 0.2F * mm};
    for (const float weight : {1.0F, 0.5F}) {
      material.parameters.subsurfaceWeight = weight;
      const ResolvedScene scene = sceneOf(makeSphere(128), material);
      for (const bool isMoving : {false, true}) {
        const Image picture = isMoving ? moving(scene) : still(scene, 2);
        float least = 2.0F, most = 0.0F;
        for (int y = 0; y < 96; ++y)
          for (int x = 0; x < 96; ++x) {
            const glm::vec2 at = (glm::vec2(x, y) + 0.5F) / 48.0F - 1.0F;
            if (glm::length(at) > 0.95F) continue;
            for (int c = 0; c < 3; ++c) {
              least = std::min(least, pixel(picture, x, y)[c]);
              most = std::max(most, pixel(picture, x, y)[c]);
            }
          }
        EXPECT_GE(least, 0.995F) << mm << (isMoving ? " moving" : " still") << " weight " << weight;
        EXPECT_LE(most, 1.005F) << mm << (isMoving ? " moving" : " still") << " weight " << weight;
      }
    }
  }
}

TEST_F(SubsurfaceLeak, KernelsAreMadeOnlyForWhatChangesThem) {
  ResolvedScene scene = stepScene(bareSkin(), 24.0F);
  still(scene, 1);
  const auto made = [&] { return m_renderer->statistics().diffusionKernelsMade; };
  EXPECT_EQ(made(), 1U);
  scene.slots[0].material.parameters.specularPerceptualRoughness = 0.3F;
  scene.slots[0].material.parameters.subsurfaceAlbedoMix = 0.5F;
  scene.slots[0].material.parameters.subsurfaceWeight = 0.7F;
  scene.scene.lights.push_back(pointLight({0, 0, 2}, 1.0F));
  still(scene, 1);
  EXPECT_EQ(made(), 1U);
  scene.slots[0].material.parameters.subsurfaceScale = 2.0F;
  still(scene, 1);
  EXPECT_EQ(made(), 2U);
  scene.slots[0].material.parameters.subsurfaceProfile = DiffusionFamily::Gaussians;
  still(scene, 1);
  EXPECT_EQ(made(), 3U);
  scene.slots[0].material.parameters.subsurfaceRadiusMm = glm::vec3(9.0F);
  still(scene, 1);
  EXPECT_EQ(made(), 3U) << "Gaussians have no radius";
}

}  // namespace
}  // namespace dermis::test
