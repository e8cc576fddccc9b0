// White furnaces and the plane whose light is known: nothing is lost and nothing is made.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "gpu/sphere_fixture.h"

namespace dermis::test {
namespace {

class Furnace : public SphereTest {
 protected:
  static void expectWhite(ShadingModel model, float roughness, float metallic, const std::string& what) {
    static const auto kWhite = constantEnvironment(glm::vec3(1.0F));
    Look look;
    look.material.model = model;
    look.environment = kWhite;
    look.camera = orthographicCamera();
    look.size = 64;
    MaterialParameters& p = look.material.parameters;
    p.baseAlbedo.rgb = glm::vec3(1.0F);
    p.baseMetallic = metallic;
    p.specularPerceptualRoughness = roughness;
    p.eyeIrisColor.rgb = p.eyeScleraColor.rgb = glm::vec3(1.0F);
    p.eyeLimbusDarkness = p.eyePupilRadiusMm = p.eyeIrisVariation = 0.0F;
    p.eyeCorneaPerceptualRoughness = roughness;
    const Picture picture = render(look);
    int seen = 0;
    double least = 2.0, most = 0.0;
    for (int y = 0; y < look.size; ++y)
      for (int x = 0; x < look.size; ++x) {
        const auto point = reference::sphereUnderPixel(look.camera, look.size, look.size, x, y);
        // A pixel inside the silhouette of the triangles too.
        if (!point || glm::dot(point->normal, point->view) < 0.05) continue;
        ++seen;
        for (int c = 0; c < 3; ++c) {
          least = std::min(least, picture.at(x, y)[c]);
          most = std::max(most, picture.at(x, y)[c]);
        }
      }
    EXPECT_GT(seen, 1500) << what;
    EXPECT_GE(least, 0.995) << what;
    EXPECT_LE(most, 1.005) << what;
  }
};

TEST_F(Furnace, WhiteStaysWhite) {
  for (const ShadingModel model : {ShadingModel::Skin, ShadingModel::MetallicRoughness, ShadingModel::Eye})
    for (const float roughness : {0.02F, 0.1F, 0.25F, 0.5F, 0.75F, 1.0F})
      for (const float metallic : {0.0F, 0.5F, 1.0F}) {
        if (model == ShadingModel::Eye && metallic > 0.0F) continue;
        expectWhite(model, roughness, metallic,
                    std::string(shadingModelRow(model).id) + ", roughness " + std::to_string(roughness) +
                        ", metallic " + std::to_string(metallic));
      }
}

// interfaces.md, Conventions: albedo 0.5 under irradiance π leaves 0.5, whatever sends it.
TEST_F(Furnace, PlaneUnderAKnownLamp) {
  Look look;
  look.plane = true;
  look.size = 33;
  look.camera.position = {0, 0, 5};
  look.camera.orthographicHeight = 2.0F;
  MaterialParameters& p = look.material.parameters;
  p.baseAlbedo.rgb = glm::vec3(0.5F);
  p.specularIntensity = 0.0F;
  p.subsurfaceWeight = 0.0F;
  p.transmissionWeight = 0.0F;
  constexpr auto kPi = std::numbers::pi_v<float>;
  Light light;
  light.shadow = false;
  light.type = LightType::Directional;
  light.direction = {0, 0, -1};
  light.intensity = kPi;
  look.lights = {light};
  EXPECT_NEAR(render(look).at(16, 16).x, 0.5, 1e-4) << "directional";
  look.lights[0].direction = {0, 0, 1};
  EXPECT_EQ(render(look).at(16, 16).x, 0.0) << "directional, from behind";
  light.type = LightType::Point;
  light.position = {0, 0, 2};
  light.intensity = 4.0F * kPi;
  for (const LightType type : {LightType::Point, LightType::Spot, LightType::Sphere, LightType::Rect}) {
    light.type = type;
    light.direction = {0, 0, -1};
    look.lights = {light};
    EXPECT_NEAR(render(look).at(16, 16).x, 0.5, 1e-4) << "light " << static_cast<int>(type);
  }
}

TEST_F(Furnace, PlaneInAGreyWorld) {
  Look look;
  look.plane = true;
  look.size = 33;
  look.camera.position = {0, 0, 5};
  look.camera.orthographicHeight = 2.0F;
  look.environment = constantEnvironment({0.25F, 0.5F, 2.0F});
  MaterialParameters& p = look.material.parameters;
  p.baseAlbedo.rgb = glm::vec3(1.0F);
  p.specularIntensity = 0.0F;
  p.subsurfaceWeight = 0.0F;
  p.transmissionWeight = 0.0F;
  const glm::dvec4 got = render(look).at(16, 16);
  EXPECT_NEAR(got.x, 0.25, 2e-4);
  EXPECT_NEAR(got.y, 0.5, 4e-4);
  EXPECT_NEAR(got.z, 2.0, 2e-3);
}

}  // namespace
}  // namespace dermis::test
