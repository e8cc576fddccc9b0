// The eye: what is seen through the cornea and how it is lit, against rays traced in doubles.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "core/scene/primitives.h"
#include "gpu/frame_support.h"
#include "gpu/models_probe.h"
#include "gpu/sphere_fixture.h"
#include "reference/eye_trace.h"
#include "reference/microfacet.h"

namespace dermis::test {
namespace {

using reference::EyeModel;
using reference::traceEye;

// ---- the optics alone

class EyeOptics : public GlTest {
 protected:
  gl::ShaderLibrary m_library;
};

TEST_F(EyeOptics, RaysAreRefractedOntoTheIris) {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> unit(-1.0F, 1.0F);
  std::vector<ProbeInput> inputs;
  for (int i = 0; i < 4000; ++i) {
    ProbeInput input;
    input.a = {6.0F * unit(random), 6.0F * unit(random), 11.0F, 0.0F};
    input.b = glm::vec4(glm::normalize(glm::vec3(0.8F * unit(random), 0.8F * unit(random), -1.0F)), 0.0F);
    input.c = {5.4F + 0.6F * unit(random), 3.0F + 0.4F * unit(random), 1.38F + 0.08F * unit(random), 0.0F};
    inputs.push_back(input);
  }
  const auto outputs = runProbe(m_library, R"(
#include "models/eye_optics.glsl"
void probe(vec4 a, vec4 b, vec4 c, vec4 d, out vec4 x, out vec4 y) {
  EyeShape e = eyeShape(c.x, c.y, c.z);
  vec4 entry = corneaEntry(e, a.xyz, b.xyz);
  x = entry;
  y = vec4(onIris(e, entry.xyz, b.xyz), corneaNormal(e, entry.xyz).xy);
}
)",
                                inputs);
  ASSERT_EQ(outputs.size(), inputs.size());
  int hits = 0;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const EyeModel eye{inputs[i].c.x, inputs[i].c.y, inputs[i].c.z};
    const auto hit = traceEye(eye, glm::dvec3(inputs[i].a), glm::normalize(glm::dvec3(inputs[i].b)));
    if (!hit) continue;
    ++hits;
    EXPECT_EQ(outputs[i].a.w, 1.0F);
    EXPECT_LT(glm::length(glm::dvec3(outputs[i].a) - hit->entry), 1e-4);
    EXPECT_LT(glm::length(glm::dvec2(outputs[i].b) - hit->iris), 2e-4) << i;
    EXPECT_LT(glm::length(glm::dvec2(outputs[i].b.z, outputs[i].b.w) - glm::dvec2(hit->normal)), 1e-4);
  }
  EXPECT_GT(hits, 1500);
}

// A beam of a million rays, binned where they land, says how bright the iris is.
TEST_F(EyeOptics, LampsLightTheIrisAsRaysLand) {
  const EyeModel eye{5.9, 3.0, 1.376};
  constexpr int kCells = 24;
  constexpr double kHalf = 4.8;  // mm
  for (const double degrees : {0.0, 25.0, 50.0}) {
    const double angle = degrees * std::numbers::pi / 180.0;
    const glm::dvec3 toLight(std::sin(angle), 0.0, std::cos(angle));
    const glm::dvec3 across(std::cos(angle), 0.0, -std::sin(angle));
    std::vector<double> power(kCells * kCells, 0.0);
    constexpr int kRays = 1600;
    constexpr double kBeam = 7.0, kStep = 2.0 * kBeam / kRays;
    for (int j = 0; j < kRays; ++j)
      for (int i = 0; i < kRays; ++i) {
        const glm::dvec3 from = glm::dvec3(0.0, 0.0, 12.0) + across * ((i + 0.5) * kStep - kBeam) +
                                glm::dvec3(0, 1, 0) * ((j + 0.5) * kStep - kBeam);
        const auto hit = traceEye(eye, from, -toLight);
        if (!hit) continue;
        const int x = static_cast<int>(std::floor((hit->iris.x + kHalf) / (2.0 * kHalf) * kCells));
        const int y = static_cast<int>(std::floor((hit->iris.y + kHalf) / (2.0 * kHalf) * kCells));
        if (x < 0 || y < 0 || x >= kCells || y >= kCells) continue;
        power.at(static_cast<std::size_t>(y * kCells + x)) += kStep * kStep;
      }
    const double cell = 2.0 * kHalf / kCells;
    std::vector<ProbeInput> inputs;
    for (int y = 0; y < kCells; ++y)
      for (int x = 0; x < kCells; ++x) {
        ProbeInput input;
        input.a = glm::vec4(glm::dvec4((x + 0.5) * cell - kHalf, (y + 0.5) * cell - kHalf, 0.0, 0.0));
        input.b = glm::vec4(glm::vec3(toLight), 0.0F);
        inputs.push_back(input);
      }
    const auto outputs = runProbe(m_library, R"(
#include "models/eye_optics.glsl"
void probe(vec4 a, vec4 b, vec4 c, vec4 d, out vec4 x, out vec4 y) {
  IrisBeam beam = irisBeam(eyeShape(5.9, 3.0, 1.376), a.xy, b.xyz);
  x = vec4(beam.gain, beam.cosine, 0.0, 0.0);
  y = vec4(0.0);
}
)",
                                  inputs);
    ASSERT_EQ(outputs.size(), inputs.size());
    double worst = 0.0;
    int compared = 0;
    for (std::size_t i = 0; i < inputs.size(); ++i) {
      if (glm::length(glm::dvec2(inputs[i].a)) > 4.2) continue;
      const double want = power[i] / (cell * cell);
      // Where light has to come in near the rim a cell is part lit.
      bool whole = want > 0.0;
      for (const int step : {-1, 1, -kCells, kCells}) {
        const auto next = static_cast<std::size_t>(static_cast<int>(i) + step);
        whole = whole && next < power.size() && power[next] > 0.5 * power[i] && power[next] < 2.0 * power[i];
      }
      if (!whole) continue;
      ++compared;
      worst = std::max(worst, std::abs(static_cast<double>(outputs[i].a.x) - want) / want);
    }
    RecordProperty("worst at " + std::to_string(degrees), std::to_string(worst));
    EXPECT_GT(compared, 200) << degrees;
    EXPECT_LT(worst, 0.03) << degrees;
  }
}

// ---- whole pictures of a plain sphere, radius 1: a human eye enlarged

class Eye : public FrameTest {
 protected:
  static Material eye() {
    Material material = materialOf(ShadingModel::Eye);
    material.parameters.eyeIrisVariation = 0.0F;
    material.parameters.eyeLimbusDarkness = 0.0F;
    return material;
  }
  struct Seen {
    bool cornea = false;
    glm::dvec2 iris{0.0};
    glm::dvec3 normal{0.0}, point{0.0};  ///< point in mm of the eye
    double rimDistance = 0.0;            ///< of the entry from the cornea's rim, mm
  };
  /// What the pixel of a 2-unit-high orthographic picture sees.
  [[nodiscard]] std::optional<Seen> seenAt(const ResolvedScene& scene, int x, int y) const {
    const auto point = reference::sphereUnderPixel(scene.camera, m_size.x, m_size.y, x, y);
    if (!point || point->normal.z < 0.05 || glm::dot(point->normal, point->view) < 0.15) return std::nullopt;
    Seen seen;
    seen.point = 12.0 * point->normal;
    seen.normal = point->normal;
    EyeModel wide;
    const auto hit = traceEye(wide, seen.point, -point->view);
    if (hit) {
      seen.cornea = true;
      seen.iris = hit->iris;
      seen.normal = hit->normal;
      seen.rimDistance = wide.rim - std::hypot(hit->entry.x, hit->entry.y);
    }
    return seen;
  }
};

TEST_F(Eye, TheIrisIsWhereRefractionPutsIt) {
  m_size = {160, 160};
  ResolvedScene scene = sceneOf(makeSphere(160), eye());
  const MaterialParameters& p = scene.slots[0].material.parameters;
  const reference::Layer layer(glm::dvec3(reference::f0FromIor(1.4)), {{0.03 * 0.75, 0.15}, {0.03 * 1.30, 0.85}});
  m_renderer->keepAovs({Aov::Diffuse});
  for (const glm::vec3 from : {glm::vec3(0, 0, 5), glm::vec3(2, 1, 4), glm::vec3(-4, 0.5F, 3)}) {
    scene.camera.position = from;
    still(scene);
    const Image diffuse = m_renderer->readAov(Aov::Diffuse);
    int pupil = 0, iris = 0, moved = 0;
    for (int y = 0; y < m_size.y; ++y)
      for (int x = 0; x < m_size.x; ++x) {
        const auto seen = seenAt(scene, x, y);
        if (!seen || !seen->cornea || seen->rimDistance < 0.4) continue;
        const double r = glm::length(seen->iris);
        const bool inPupil = r<1.8 - 0.25, inIris = r> 1.8 + 0.25 && r < 5.9 - 0.45;
        if (!inPupil && !inIris) continue;
        (inPupil ? pupil : iris) += 1;
        // Where it would be without refraction: would that be wrong here?
        const double flat = std::hypot(seen->point.x, seen->point.y);
        moved += (flat < 1.8) != inPupil ? 1 : 0;
        const glm::dvec3 view = glm::normalize(glm::dvec3(from));
        for (int c = 0; c < 3; ++c) {
          const double albedo = inPupil ? 0.002 : static_cast<double>(p.eyeIrisColor.rgb[c]);
          const double want = albedo * (1.0 - layer.albedo(glm::dot(seen->normal, view))[c]);
          EXPECT_NEAR(pixel(diffuse, x, y)[c], want, 0.006 * want + 2e-4) << x << ", " << y;
        }
      }
    EXPECT_GT(pupil, 150) << from.x;
    EXPECT_GT(iris, 1000) << from.x;
    if (from.x != 0.0F) {
      EXPECT_GT(moved, 25) << from.x;
    }
  }
}

TEST_F(Eye, AMapMovesWithTheIris) {
  m_size = {160, 160};
  Material material = eye();
  material.parameters.eyeIrisColor.rgb = material.parameters.eyeScleraColor.rgb = glm::vec3(1.0F);
  ResolvedScene scene = sceneOf(makeSphere(160), material);
  // Red says u, green says v.
  std::vector<float> texels;
  constexpr int kTexels = 256;
  for (int y = 0; y < kTexels; ++y)
    for (int x = 0; x < kTexels; ++x)
      texels.insert(texels.end(),
                    {(static_cast<float>(x) + 0.5F) / kTexels, 1.0F - (static_cast<float>(y) + 0.5F) / kTexels, 0.5F});
  TextureBinding raw;
  raw.colorSpace = "raw";
  setMap(scene, TextureSlot::Albedo, imageOf(kTexels, kTexels, 3, PixelType::Float, texels), raw);
  m_renderer->keepAovs({Aov::Diffuse});
  for (const glm::vec3 from : {glm::vec3(0, 0, 5), glm::vec3(2, 1, 4)}) {
    scene.camera.position = from;
    still(scene);
    const Image diffuse = m_renderer->readAov(Aov::Diffuse);
    int compared = 0;
    double unmoved = 0.0, worst = 0.0;
    for (int y = 0; y < m_size.y; ++y)
      for (int x = 0; x < m_size.x; ++x) {
        const auto seen = seenAt(scene, x, y);
        if (!seen || !seen->cornea || seen->rimDistance < 0.4 || glm::length(seen->iris) > 4.5) continue;
        // The texel painted at this place of the iris: above it on the sphere.
        const glm::dvec2 at = seen->iris / 12.0;
        const double z = std::sqrt(1.0 - glm::dot(at, at));
        const glm::dvec2 want(0.5 + std::atan2(at.x, z) / (2.0 * std::numbers::pi),
                              1.0 - std::acos(at.y) / std::numbers::pi);
        // Blue says how much the cornea lets through.
        const glm::vec4 got = pixel(diffuse, x, y);
        const glm::dvec2 read(0.5 * got.r / got.b, 0.5 * got.g / got.b);
        worst = std::max(worst, std::abs(read.x - want.x));
        worst = std::max(worst, 0.5 * std::abs(read.y - want.y));
        unmoved = std::max(
            unmoved, std::abs(0.5 + std::atan2(seen->point.x, seen->point.z) / (2.0 * std::numbers::pi) - want.x));
        ++compared;
      }
    EXPECT_GT(compared, 1500);
    // In turns; a millimetre is 0.013.
    EXPECT_LT(worst, 0.003) << "0.2 mm";
    if (from.x != 0.0F) {
      EXPECT_GT(unmoved, 0.006);
    }
  }
}

TEST_F(Eye, AShellReflectsInTheCorneasPlace) {
  m_size = {64, 64};
  Model model = makeSphere(64);
  model.slots.push_back({"shell", Material{}});
  ResolvedScene scene = sceneOf(model, eye());
  m_renderer->keepAovs({Aov::Specular});
  still(scene);
  const Image alone = m_renderer->readAov(Aov::Specular);
  scene.slots[1].material.model = ShadingModel::Lens;
  still(scene);
  const Image shelled = m_renderer->readAov(Aov::Specular);
  EXPECT_GT(pixel(alone, 32, 32).r, 0.02F);
  EXPECT_EQ(pixel(shelled, 32, 32).r, 0.0F);
  EXPECT_EQ(pixel(shelled, 8, 32).r, pixel(alone, 8, 32).r) << "the sclera has no shell";
}

}  // namespace
}  // namespace dermis::test
