// What shadows.glsl tells of the way through a body, asked directly: the maps and blocks that a frame leaves bound.
#include <cmath>

#include "gpu/models_probe.h"
#include "gpu/shadow_support.h"

namespace dermis::test {
namespace {

constexpr double kThick = 0.04;  // 4 mm

class ShadowThickness : public ShadowTest {
 protected:
  /// a: position, light; b: normal, shrink in mm; c.x: thickness in mm of the far side.
  std::vector<ProbeOutput> ask(const std::vector<ProbeInput>& inputs) {
    gl::ShaderLibrary library;
    return runProbe(library,
                    "#include \"shadows.glsl\"\n"
                    "void probe(vec4 a, vec4 b, vec4 c, vec4 d, out vec4 x, out vec4 y) {\n"
                    "  x = vec4(shadowAt(int(a.w), a.xyz, b.xyz), shadowThicknessMm(int(a.w), a.xyz, b.xyz, b.w),\n"
                    "           shadowOfFarSide(int(a.w), a.xyz, b.xyz, c.x), 0.0);\n  y = x;\n}\n",
                    inputs);
  }
  /// A slab from z = −0.04 to 0, open at the sides, lit from below.
  ResolvedScene slab(const std::vector<Light>& lights) {
    Model model = both(ground(), quad({-2, -2, -kThick}, {-2, 2, -kThick}, {2, 2, -kThick}, {2, -2, -kThick}, "below"));
    ResolvedScene scene = litFromAbove(std::move(model), lights.front());
    scene.scene.lights = lights;
    return scene;
  }
  static std::vector<Light> fromBelow() {
    Light sun = lampOf(LightType::Directional), lamp = lampOf(LightType::Point), spot = lampOf(LightType::Spot);
    sun.direction = glm::normalize(glm::vec3(0.6F, 0.2F, 1.0F));
    lamp.position = {-0.5F, 0.2F, -1.5F};
    spot.position = {0.3F, 0.4F, -2.0F};
    spot.direction = {-0.1F, -0.2F, 1.0F};
    Light unshadowed = lamp;
    unshadowed.shadow = false;
    return {sun, lamp, spot, unshadowed};
  }
};

TEST_F(ShadowThickness, IsTheWayInsideFromWhereLightEnters) {
  const std::vector<Light> lights = fromBelow();
  const ResolvedScene scene = slab(lights);
  for (const int samples : {1, 3}) {
    still(scene, samples);
    std::vector<ProbeInput> inputs;
    for (int light = 0; light < 4; ++light)
      for (int i = 0; i < 25; ++i)
        for (const float shrink : {0.0F, 0.5F})
          inputs.push_back({{-0.4F + 0.2F * static_cast<float>(i % 5), -0.4F + 0.2F * static_cast<float>(i / 5), 0.0F,
                             static_cast<float>(light)},
                            {0.0F, 0.0F, 1.0F, shrink},
                            {4.0F, 0.0F, 0.0F, 0.0F},
                            {}});
    const auto got = ask(inputs);
    ASSERT_EQ(got.size(), inputs.size());
    for (std::size_t i = 0; i < got.size(); ++i) {
      const auto light = static_cast<std::size_t>(inputs[i].a.w);
      if (light == 3) {
        EXPECT_EQ(got[i].a.x, 1.0F) << "no map, no shadow";
        EXPECT_GT(got[i].a.y, 1e6F) << "nothing known";
        continue;
      }
      const dvec3 inside(inputs[i].a.x, inputs[i].a.y, -0.01 * static_cast<double>(inputs[i].b.w));
      const dvec3 l = towards(lights[light], inside);
      const double want = (kThick + inside.z) / -l.z * 100.0;
      EXPECT_NEAR(got[i].a.x, 0.0F, 1e-5F) << "the near side is dark, light " << light;
      EXPECT_NEAR(static_cast<double>(got[i].a.y), want, 0.03) << "mm, light " << light;
      EXPECT_NEAR(got[i].a.z, 1.0F, 1e-5F) << "the far side is lit, light " << light;
    }
  }
}

// Something stands between the light and the slab: the far side is dark.
TEST_F(ShadowThickness, FarSideKnowsWhatStandsBeforeIt) {
  ResolvedScene scene = slab(fromBelow());
  scene.model = std::make_shared<Model>(
      both(*scene.model, quad({-1.9, -1.9, -0.5}, {-1.9, 1.9, -0.5}, {1.9, 1.9, -0.5}, {1.9, -1.9, -0.5}, "before")));
  scene.slots.push_back(scene.slots.front());
  still(scene, 1);
  const auto got = ask({{{0.1F, 0.1F, 0.0F, 0.0F}, {0.0F, 0.0F, 1.0F, 0.0F}, {4.0F, 0.0F, 0.0F, 0.0F}, {}}});
  ASSERT_EQ(got.size(), 1U);
  EXPECT_EQ(got[0].a.z, 0.0F);
  const double l = towards(fromBelow()[0], dvec3(0.0)).z;
  EXPECT_NEAR(static_cast<double>(got[0].a.y), 50.0 / -l, 0.1) << "the distance to what the light sees first";
}

}  // namespace
}  // namespace dermis::test
