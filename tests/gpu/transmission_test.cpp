// Light through slabs: the shader against its twin and against random walks, and the three ways to know a thickness.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/bake/mesh_bake.h"
#include "core/material/scattering_length.h"
#include "gpu/frame_support.h"
#include "gpu/models_probe.h"

namespace dermis::test {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;

/// Two facing sheets of 40 mm a side, a unit a millimetre: the front at z = 0 looks to +Z.
Model slab(float thickness) {
  Model model;
  constexpr int kCells = 8;
  for (const bool front : {true, false})
    for (int j = 0; j <= kCells; ++j)
      for (int i = 0; i <= kCells; ++i) {
        const glm::vec2 uv = glm::vec2(i, j) / static_cast<float>(kCells);
        model.positions.emplace_back(uv * 40.0F - 20.0F, front ? 0.0F : -thickness);
        model.normals.emplace_back(0.0F, 0.0F, front ? 1.0F : -1.0F);
        model.tangents.emplace_back(1.0F, 0.0F, 0.0F, front ? 1.0F : -1.0F);
        model.uvs.push_back(uv);
      }
  const std::uint32_t side = (kCells + 1) * (kCells + 1);
  for (std::uint32_t j = 0; j < kCells; ++j)
    for (std::uint32_t i = 0; i < kCells; ++i) {
      const std::uint32_t v = j * (kCells + 1) + i, up = v + kCells + 1;
      for (const std::uint32_t corner : {v, v + 1, up + 1, v, up + 1, up}) model.indices.push_back(corner);
      for (const std::uint32_t corner : {v, up + 1, v + 1, v, up, up + 1}) model.indices.push_back(side + corner);
    }
  model.slots = {{"default", Material{}}};
  model.parts = {{0, 0, static_cast<std::uint32_t>(model.indices.size())}};
  for (const glm::vec3& p : model.positions) model.bounds.grow(p);
  model.millimetresPerUnit = 1.0F;
  return model;
}

/// The volume of the random walks, without a specular layer: what is seen is the body alone.
Material walkedMaterial() {
  Material material = materialOf(ShadingModel::Skin);
  MaterialParameters& p = material.parameters;
  p.baseAlbedo.rgb = {0.8F, 0.5F, 0.4F};
  p.specularIntensity = 0.0F;
  p.subsurfaceRadiusMm = {0.2628F, 0.3537F, 0.2476F};
  p.subsurfaceRadiusReading = RadiusReading::MeanFreePath;
  p.transmissionThicknessMaxMm = 50.0F;
  return material;
}

/// From `behind` a plane of irradiance π: a perfect transmitter shows 1.
Light backLight(bool shadow) {
  Light light;
  light.type = LightType::Directional;
  light.direction = {0, 0, 1};
  light.intensity = kPi;
  light.shadow = shadow;
  return light;
}

struct WalkedSlab {
  float thickness;
  glm::vec3 reflected, transmitted;
};
// Monte-Carlo random walks, 6 million a slab, through an index-matched volume of mean free path (0.2628, 0.3537,
// 0.2476) mm and single-scattering albedo (0.99175, 0.91370, 0.85295), made with an independent path tracer
// (Blender 3.4.1 Cycles).
constexpr std::array<WalkedSlab, 4> kWalked = {{{1, {0.70982F, 0.48404F, 0.40199F}, {0.23131F, 0.18179F, 0.06217F}},
                                                {2, {0.78606F, 0.50553F, 0.40428F}, {0.10823F, 0.04382F, 0.00507F}},
                                                {4, {0.80922F, 0.50595F, 0.40419F}, {0.03088F, 0.00271F, 0.00003F}},
                                                {8, {0.81034F, 0.50624F, 0.40415F}, {0.00186F, 0.00001F, 0.0F}}}};

/// T(t) and R(t)/R(∞) as their definitions have them.
struct Twin {
  double transmitted, kept;
};
Twin twin(double albedo, double meanFreePath, double thickness) {
  const double a = albedo;
  const double alpha = 1.0 - std::exp(-5.09406 * a + 2.61188 * a * a - 4.31805 * a * a * a);
  const double kappa = std::sqrt(3.0 * (1.0 - alpha)) / meanFreePath;
  const double source = 2.0 / 3.0 * meanFreePath, beyond = 0.7104 * meanFreePath;
  const auto reflected = [&](double t) {
    return std::sinh(kappa * (t + beyond - source)) / std::sinh(kappa * (t + 2.0 * beyond));
  };
  return {std::sinh(kappa * (source + beyond)) / std::sinh(kappa * (thickness + 2.0 * beyond)),
          reflected(thickness) / std::exp(-kappa * (source + beyond))};
}

class Transmission : public FrameTest {
 protected:
  /// The middle of a slab seen from the front, with what lies behind it.
  glm::vec4 middle(float thickness, const Material& material, const std::vector<Light>& lights,
                   const glm::vec3& world = glm::vec3(0.0F), bool baked = true) {
    return pixel(still(scene(thickness, material, lights, world, baked)), m_size.x / 2, m_size.y / 2);
  }
  static ResolvedScene scene(float thickness, const Material& material, const std::vector<Light>& lights,
                             const glm::vec3& world, bool baked = true) {
    ResolvedScene made = sceneOf(slab(thickness), material, world);
    made.millimetresPerUnit = 1.0F;
    made.camera.position = {0, 0, 100};
    made.camera.orthographicHeight = 4.0F;
    made.scene.lights = lights;
    if (baked) {
      MeshBakeOptions options;
      options.millimetresPerUnit = 1.0F;
      made.bake = *bakeMesh(*made.model, options);
    }
    return made;
  }
};

TEST_F(Transmission, SlabsLetThroughWhatRandomWalksDo) {
  glm::vec3 last(1.0F);
  for (const WalkedSlab& walked : kWalked) {
    const glm::vec4 got = middle(walked.thickness, walkedMaterial(), {backLight(false)});
    for (int c = 0; c < 3; ++c) {
      const double albedo[] = {0.8, 0.5, 0.4}, path[] = {0.2628, 0.3537, 0.2476};
      const double expected = twin(albedo[c], path[c], static_cast<double>(walked.thickness)).transmitted;
      EXPECT_NEAR(got[c], expected, 0.005 * expected + 2e-5) << walked.thickness << " mm, channel " << c;
      EXPECT_LT(got[c], last[c]) << "thicker lets less through";
      if (walked.transmitted[c] < 0.01F) continue;
      EXPECT_NEAR(got[c] / walked.transmitted[c], 1.0, 0.15) << walked.thickness << " mm, channel " << c;
    }
    last = glm::vec3(got);
  }
}

TEST_F(Transmission, SlabsSendBackTheRest) {
  Light front = backLight(false);
  front.direction = {0, 0, -1};
  for (const WalkedSlab& walked : kWalked) {
    const glm::vec4 back = middle(walked.thickness, walkedMaterial(), {front});
    const glm::vec4 through = middle(walked.thickness, walkedMaterial(), {backLight(false)});
    for (int c = 0; c < 3; ++c) {
      EXPECT_NEAR(back[c] / walked.reflected[c], 1.0, 0.05) << walked.thickness << " mm, channel " << c;
      EXPECT_LE(back[c] + through[c], 1.0F);
    }
  }
}

TEST_F(Transmission, ReadingsOfOneVolumeAgree) {
  Material material = walkedMaterial();
  const glm::vec4 expected = middle(2.0F, material, {backLight(false)});
  MaterialParameters& p = material.parameters;
  // The same volume as 1/σ_tr = ℓ/√(3(1 − α)), and as Burley's d for diffuse light.
  p.subsurfaceRadiusReading = RadiusReading::DiffuseMeanFreePath;
  for (int c = 0; c < 3; ++c) {
    const float a = p.baseAlbedo.rgb[c];
    p.subsurfaceRadiusMm[c] /= std::sqrt(3.0F * std::exp(-5.09406F * a + 2.61188F * a * a - 4.31805F * a * a * a));
  }
  EXPECT_THAT(middle(2.0F, material, {backLight(false)}), IsColour(expected, 5e-4F));
  p.subsurfaceRadiusReading = RadiusReading::BurleyD;
  p.subsurfaceRadiusMm = {0.2389F, 0.2062F, 0.1202F};
  EXPECT_THAT(middle(2.0F, material, {backLight(false)}), IsColour(expected, 5e-4F));
  // A scale and a colour that cancel out.
  p.subsurfaceRadiusMm *= 4.0F;
  p.subsurfaceScale = 0.5F;
  p.subsurfaceColor.rgb = glm::vec3(0.5F);
  EXPECT_THAT(middle(2.0F, material, {backLight(false)}), IsColour(expected, 5e-4F));
}

TEST(ScatteringLengths, GaussiansCountByTheirMeanSquaredRadius) {
  // One Gaussian of variance v spreads ⟨r²⟩ = 2v, Burley's profile 14 d².
  MaterialParameters p;
  p.subsurfaceProfile = DiffusionFamily::Gaussians;
  p.subsurfaceGaussians = {};
  p.subsurfaceGaussians.count = 1;
  p.subsurfaceGaussians.terms[0] = {7.0F, {1.0F, 0.5F, 2.0F}};
  p.subsurfaceScale = 3.0F;
  const ScatteringLength length = scatteringLength(p);
  EXPECT_EQ(length.reading, RadiusReading::BurleyD);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(length.mm[c], 3.0F, 1e-5F);
}

TEST_F(Transmission, MapGivesTheThickness) {
  Material material = walkedMaterial();
  MaterialParameters& p = material.parameters;
  p.transmissionThicknessSource = ThicknessSource::Map;
  p.transmissionThicknessMinMm = 1.0F;
  p.transmissionThicknessMaxMm = 5.0F;
  const auto shown = [&](float value, bool invert) {
    ResolvedScene mapped = scene(3.0F, material, {backLight(false)}, glm::vec3(0.0F));
    TextureBinding binding;
    binding.invert = invert;
    setMap(mapped, TextureSlot::Thickness, imageOf(1, 1, 1, PixelType::Float, {value}), binding);
    return pixel(still(mapped), m_size.x / 2, m_size.y / 2);
  };
  EXPECT_NEAR(shown(0.25F, false).x, twin(0.8, 0.2628, 2.0).transmitted, 1e-3);
  EXPECT_NEAR(shown(0.25F, true).x, twin(0.8, 0.2628, 4.0).transmitted, 1e-3);
  EXPECT_NEAR(shown(0.0F, false).x, twin(0.8, 0.2628, 1.0).transmitted, 1e-3);
  // Without a map: the largest.
  EXPECT_NEAR(middle(3.0F, material, {backLight(false)}).x, twin(0.8, 0.2628, 5.0).transmitted, 1e-3);
}

TEST_F(Transmission, AllThreeSourcesAgree) {
  for (const float thickness : {1.0F, 2.0F, 4.0F})
    for (const glm::vec3 direction : {glm::vec3(0, 0, 1), glm::vec3(0.4F, 0.2F, 0.9F)}) {
      Light light = backLight(true);
      light.direction = direction;
      Material material = walkedMaterial();
      const glm::vec4 mesh = middle(thickness, material, {light});
      EXPECT_GT(mesh.x, 0.02F);

      material.parameters.transmissionThicknessSource = ThicknessSource::Map;
      material.parameters.transmissionThicknessMaxMm = 8.0F;
      ResolvedScene mapped = scene(thickness, material, {light}, glm::vec3(0.0F));
      setMap(mapped, TextureSlot::Thickness, imageOf(1, 1, 1, PixelType::Float, {thickness / 8.0F}));
      const glm::vec4 map = pixel(still(mapped), m_size.x / 2, m_size.y / 2);

      material.parameters.transmissionThicknessSource = ThicknessSource::Shadow;
      const glm::vec4 shadow = middle(thickness, material, {light});
      for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(map[c], mesh[c], 0.01F * mesh[c] + 1e-5F) << thickness << " mm, channel " << c;
        EXPECT_NEAR(shadow[c], mesh[c], 0.05F * mesh[c] + 1e-4F) << thickness << " mm, channel " << c;
      }
    }
}

TEST_F(Transmission, FarSideInTheShadowIsDark) {
  // A board some way behind the slab.
  const auto behindABoard = [&](bool shadow) {
    ResolvedScene made = scene(2.0F, walkedMaterial(), {backLight(shadow)}, glm::vec3(0.0F));
    auto model = std::make_shared<Model>(*made.model);
    const auto first = static_cast<std::uint32_t>(model->positions.size());
    for (const glm::vec2 corner : {glm::vec2(-1, -1), glm::vec2(1, -1), glm::vec2(1, 1), glm::vec2(-1, 1)}) {
      model->positions.emplace_back(corner * 20.0F, -12.0F);
      model->normals.emplace_back(0.0F, 0.0F, -1.0F);
      model->tangents.emplace_back(1.0F, 0.0F, 0.0F, 1.0F);
      model->uvs.emplace_back(0.0F);
    }
    for (const std::uint32_t corner : {0U, 2U, 1U, 0U, 3U, 2U}) model->indices.push_back(first + corner);
    model->parts.front().indexCount = static_cast<std::uint32_t>(model->indices.size());
    for (const glm::vec3& p : model->positions) model->bounds.grow(p);
    made.model = model;
    MeshBakeOptions options;
    options.millimetresPerUnit = 1.0F;
    made.bake = *bakeMesh(*made.model, options);
    return pixel(still(made), m_size.x / 2, m_size.y / 2);
  };
  EXPECT_NEAR(behindABoard(false).x, twin(0.8, 0.2628, 2.0).transmitted, 2e-3);
  EXPECT_EQ(behindABoard(true).x, 0.0F);
}

TEST_F(Transmission, LampInFrontDoesNotComeFromBehind) {
  Light front = backLight(true);
  front.direction = {0, 0, -1};
  m_renderer->keepAovs({Aov::Transmission});
  (void)middle(1.0F, walkedMaterial(), {front});
  EXPECT_EQ(pixel(m_renderer->readAov(Aov::Transmission), m_size.x / 2, m_size.y / 2).x, 0.0F);
}

TEST_F(Transmission, UnknownThicknessIsTheLargest) {
  Material material = walkedMaterial();
  material.parameters.transmissionThicknessMaxMm = 3.0F;
  const glm::vec4 got = middle(1.0F, material, {backLight(false)}, glm::vec3(0.0F), false);
  EXPECT_NEAR(got.x, twin(0.8, 0.2628, 3.0).transmitted, 1e-3);
}

TEST_F(Transmission, ThickBodyIsLeftAlone) {
  Material without = walkedMaterial();
  without.parameters.transmissionWeight = 0.0F;
  Light front = backLight(false);
  front.direction = {0, 0, -1};
  const std::vector<Light> lights = {front, backLight(false)};
  EXPECT_THAT(middle(30.0F, walkedMaterial(), lights), IsColour(middle(30.0F, without, lights), 1e-5F));
}

TEST_F(Transmission, WorldBehindShinesThrough) {
  // Light from all around: front and back together.
  const glm::vec4 got = middle(1.0F, walkedMaterial(), {}, glm::vec3(1.0F));
  for (int c = 0; c < 3; ++c) {
    const double albedo[] = {0.8, 0.5, 0.4}, path[] = {0.2628, 0.3537, 0.2476};
    const Twin expected = twin(albedo[c], path[c], 1.0);
    EXPECT_NEAR(got[c], albedo[c] * expected.kept + expected.transmitted, 3e-3);
  }
}

TEST_F(Transmission, WhiteSlabInAWhiteWorldIsWhite) {
  for (const float thickness : {0.1F, 0.5F, 1.0F, 3.0F, 10.0F})
    for (const float intensity : {0.0F, 1.0F}) {
      Material material = walkedMaterial();
      material.parameters.baseAlbedo.rgb = glm::vec3(1.0F);
      material.parameters.specularIntensity = intensity;
      m_renderer->keepAovs({Aov::Energy});
      const glm::vec4 got = middle(thickness, material, {}, glm::vec3(1.0F));
      const float energy = pixel(m_renderer->readAov(Aov::Energy), m_size.x / 2, m_size.y / 2).x;
      for (int c = 0; c < 3; ++c) EXPECT_NEAR(got[c], 1.0F, 0.005F) << thickness << " mm";
      EXPECT_LE(energy, 1.0F + 1e-3F);
      EXPECT_GE(energy, 0.99F);
    }
}

TEST_F(Transmission, TintColoursWhatComesThroughAlone) {
  Material material = walkedMaterial();
  const glm::vec4 white = middle(1.0F, material, {backLight(false)});
  material.parameters.transmissionTint.rgb = {0.5F, 0.25F, 0.0F};
  EXPECT_THAT(middle(1.0F, material, {backLight(false)}), IsColour(glm::vec4(0.5F, 0.25F, 0.0F, 1.0F) * white, 1e-5F));
  material.parameters.transmissionTint.rgb = glm::vec3(1.0F);
  material.parameters.transmissionWeight = 0.5F;
  EXPECT_THAT(middle(1.0F, material, {backLight(false)}), IsColour(0.5F * white, 1e-5F));
}

TEST_F(Transmission, SharesAreThoseOfTheirDefinition) {
  const std::string probe = R"(
#include "transmission.glsl"
void probe(vec4 a, vec4 b, vec4 c, vec4 d, out vec4 x, out vec4 y) {
  SlabShares shares = slabShares(slabScattering(a.rgb, b.rgb, 1), a.w);
  vec3 through = b.w * shares.transmitted;
  x = vec4(shares.transmitted, 0.0);
  y = vec4(a.rgb * keptByBody(shares, a.rgb, b.w, through) + through, 0.0);
}
)";
  std::vector<ProbeInput> inputs;
  for (const float thickness : {0.0F, 0.05F, 0.3F, 1.0F, 5.0F, 50.0F, 500.0F})
    for (const float path : {0.01F, 0.3F, 3.0F})
      for (const float amount : {0.3F, 1.0F})
        for (const glm::vec3 albedo : {glm::vec3(0.0F, 0.1F, 0.3F), glm::vec3(0.6F, 0.9F, 1.0F)})
          inputs.push_back({glm::vec4(albedo, thickness), glm::vec4(glm::vec3(path), amount), {}, {}});
  gl::ShaderLibrary library;
  const auto outputs = runProbe(library, probe, inputs);
  ASSERT_EQ(outputs.size(), inputs.size());
  for (std::size_t i = 0; i < inputs.size(); ++i)
    for (int c = 0; c < 3; ++c) {
      const double t = static_cast<double>(inputs[i].a.w), path = static_cast<double>(inputs[i].b.x);
      const double albedo = static_cast<double>(inputs[i].a[c]);
      EXPECT_LE(outputs[i].b[c], 1.0F + 1e-5F) << t << " mm, " << path << " mm, albedo " << albedo;
      EXPECT_GE(outputs[i].a[c], 0.0F);
      if (t / path > 400.0) continue;  // where the twin's sinh overflows there is nothing left
      const double expected = twin(albedo, path, t).transmitted;
      EXPECT_NEAR(outputs[i].a[c], expected, 1e-3 * expected + 1e-6)
          << t << " mm, " << path << " mm, albedo " << albedo;
    }
}

}  // namespace
}  // namespace dermis::test
