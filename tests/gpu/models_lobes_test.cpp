// Every lobe of brdf.glsl against its twin in tests/reference, on a grid.
#include <cmath>
#include <random>

#include "gpu/gl_fixture.h"
#include "gpu/models_probe.h"
#include "reference/microfacet.h"
#include "reference/quadrature.h"

namespace dermis::test {
namespace {

using reference::dvec3;

constexpr double kRelative = 1e-4;  // of single precision and the hardware's sqrt, pow and exp2

class ModelsLobes : public GlTest {
 protected:
  std::vector<ProbeOutput> run(const std::string& body, const std::vector<ProbeInput>& inputs) {
    gl::ShaderLibrary library;
    return runProbe(library,
                    "#include \"brdf.glsl\"\nvoid probe(vec4 a, vec4 b, vec4 c, vec4 d, out vec4 x, out vec4 y) {\n" +
                        body + "\n}\n",
                    inputs);
  }
};

void expectNear(double got, double want, const std::string& where) {
  EXPECT_NEAR(got, want, kRelative * std::abs(want) + 1e-7) << where;
}

const std::vector<double> kRoughness = {0.02, 0.05, 0.1, 0.2, 0.3, 0.45, 0.6, 0.8, 1.0};
const std::vector<double> kCosines = {1e-3, 0.01, 0.05, 0.1, 0.2, 0.35, 0.5, 0.7, 0.85, 0.95, 0.999, 1.0};

dvec3 direction(double cosine, double phi) {
  const double sine = std::sqrt(1.0 - cosine * cosine);
  return {sine * std::cos(phi), sine * std::sin(phi), cosine};
}

TEST_F(ModelsLobes, DistributionIsWalters) {
  std::vector<ProbeInput> inputs;
  std::vector<double> wanted;
  for (const double roughness : kRoughness)
    // From the peak outwards in multiples of the lobe's own width, where the digits are.
    for (const double widths : {0.0, 0.1, 0.3, 1.0, 2.0, 5.0, 20.0}) {
      const double alpha = static_cast<float>(roughness * roughness);
      const double theta = std::atan(widths * alpha);
      const dvec3 h = direction(std::cos(theta), 0.7);
      inputs.push_back({glm::vec4(glm::vec3(h), static_cast<float>(alpha)), {}, {}, {}});
      wanted.push_back(reference::ggxDistribution(std::cos(theta), alpha));
    }
  const auto got = run(
      "vec3 n = vec3(0, 0, 1), s = cross(n, a.xyz); x = vec4(D_GGX(dot(n, a.xyz), dot(s, s), a.w)); y = x;", inputs);
  ASSERT_EQ(got.size(), wanted.size());
  for (std::size_t i = 0; i < got.size(); ++i)
    expectNear(static_cast<double>(got[i].a.x), wanted[i],
               "alpha " + std::to_string(inputs[i].a.w) + ", row " + std::to_string(i));
}

TEST_F(ModelsLobes, VisibilityIsHeitzs) {
  std::vector<ProbeInput> inputs;
  std::vector<double> wanted;
  for (const double roughness : kRoughness)
    for (const double v : kCosines)
      for (const double l : kCosines) {
        inputs.push_back({{v, l, roughness * roughness, 0}, {}, {}, {}});
        const glm::dvec4 in(inputs.back().a);
        wanted.push_back(reference::smithHeightCorrelated(in.x, in.y, in.z) / (4.0 * in.x * in.y));
      }
  const auto got = run(
      "x = vec4(V_SmithGGXCorrelated(a.x, a.y, smithRoot(a.x, a.z * a.z), smithRoot(a.y, a.z * a.z))); y = x;", inputs);
  ASSERT_EQ(got.size(), wanted.size());
  for (std::size_t i = 0; i < got.size(); ++i)
    expectNear(static_cast<double>(got[i].a.x), wanted[i], "row " + std::to_string(i));
}

// The product that the layer uses, with one division, on random pairs of directions.
TEST_F(ModelsLobes, DistributionTimesVisibility) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::vector<ProbeInput> inputs;
  for (const double roughness : kRoughness)
    for (int i = 0; i < 200; ++i) {
      // l near the mirror of v, as far from it as the lobe is wide: elsewhere a narrow lobe is 0.
      const dvec3 v = direction(0.03 + 0.97 * unit(random), 6.28 * unit(random));
      const dvec3 h = direction(1.0 / std::hypot(1.0, 3.0 * unit(random) * roughness * roughness), 6.28 * unit(random));
      const dvec3 l = 2.0 * glm::dot(v, h) * h - v;
      if (l.z < 0.03 || glm::dot(v, h) <= 0.0) continue;
      inputs.push_back({glm::vec4(glm::vec3(v), static_cast<float>(roughness)), glm::vec4(glm::vec3(l), 0), {}, {}});
    }
  const auto got = run(R"(
  vec3 n = vec3(0, 0, 1), h = normalize(a.xyz + b.xyz), s = cross(n, h);
  float alpha2 = a.w * a.w * a.w * a.w;
  x = vec4(DV_GGX(h.z * h.z, dot(s, s), a.z, b.z, alpha2, smithRoot(a.z, alpha2)), 0, 0, 0);
  y = vec4(0);)",
                       inputs);
  ASSERT_EQ(got.size(), inputs.size());
  for (std::size_t i = 0; i < got.size(); ++i) {
    const double roughness = static_cast<double>(inputs[i].a.w);
    const dvec3 v = glm::normalize(dvec3(inputs[i].a)), l = glm::normalize(dvec3(inputs[i].b));
    const double want = reference::ggxBrdf(dvec3(1.0), roughness * roughness, {0, 0, 1}, v, l).x;
    // Directions in single precision move a narrow lobe by as much as they are rounded.
    const double rounding = 1e-6 / (roughness * roughness);
    EXPECT_NEAR(static_cast<double>(got[i].a.x), want, (2.0 * kRelative + rounding) * want)
        << "roughness " << roughness;
  }
}

TEST_F(ModelsLobes, PublishedGeometryTermsAreSchlicks) {
  std::vector<ProbeInput> inputs;
  for (const double roughness : kRoughness)
    for (const double v : kCosines)
      for (const double l : kCosines) inputs.push_back({{v, l, roughness, 0}, {}, {}, {}});
  const auto got =
      run("x = vec4(G_SmithSchlickGGX(a.x, a.y, k_SchlickGGXLamp(a.z)), "
          "G_SmithSchlickGGX(a.x, a.y, k_SchlickGGXImage(a.z)), 0, 0); y = x;",
          inputs);
  ASSERT_EQ(got.size(), inputs.size());
  for (std::size_t i = 0; i < got.size(); ++i) {
    const glm::dvec4 in(inputs[i].a);
    const std::string where = "row " + std::to_string(i);
    expectNear(static_cast<double>(got[i].a.x),
               reference::schlickGeometry(in.x, in.y, (in.z + 1.0) * (in.z + 1.0) / 8.0), where);
    expectNear(static_cast<double>(got[i].a.y), reference::schlickGeometry(in.x, in.y, in.z * in.z / 2.0), where);
  }
}

TEST_F(ModelsLobes, FresnelIsSchlicks) {
  std::vector<ProbeInput> inputs;
  for (const double ior : {1.0, 1.2, 1.376, 1.4, 1.5, 2.0, 3.0})
    for (const double cosine : {0.0, 0.01, 0.1, 0.3, 0.5, 0.8, 1.0})
      inputs.push_back({{ior, cosine, 0, 0}, {1.0F, 0.71F, 0.29F, 0}, {}, {}});
  const auto got =
      run("float f0 = F0_fromIor(a.x); x = vec4(F_Schlick(vec3(f0), a.y), f0); y = vec4(F_Schlick(b.rgb, a.y), 0);",
          inputs);
  ASSERT_EQ(got.size(), inputs.size());
  for (std::size_t i = 0; i < got.size(); ++i) {
    const glm::dvec4 in(inputs[i].a);
    const double f0 = reference::f0FromIor(in.x);
    const std::string where = "row " + std::to_string(i);
    expectNear(static_cast<double>(got[i].a.w), f0, where);
    expectNear(static_cast<double>(got[i].a.x), reference::schlickFresnel(dvec3(f0), in.y).x, where);
    const dvec3 gold = reference::schlickFresnel(dvec3(glm::vec3(inputs[i].b)), in.y);
    for (int c = 0; c < 3; ++c) expectNear(static_cast<double>(got[i].b[c]), gold[c], where);
  }
}

// E_GGX_average is a fit: to the cosine average of the compensated lobe, integrated from the BRDF.
TEST_F(ModelsLobes, AverageAlbedoFitsItsIntegral) {
  std::vector<ProbeInput> inputs;
  std::vector<dvec3> wanted;
  const dvec3 f0(0.0, 0.04, 0.5);
  for (const double roughness : {0.02, 0.07, 0.15, 0.25, 0.35, 0.5, 0.65, 0.8, 0.9, 1.0}) {
    inputs.push_back({{roughness, 0, 0, 0}, glm::vec4(f0, 1.0), {}, {}});
    wanted.push_back(reference::Layer(f0, {{roughness, 1.0}}).bodyAverage());
  }
  const auto got = run("x = vec4(E_GGX_average(b.rgb, a.x), 0); y = vec4(E_GGX_average(vec3(1), a.x), 0);", inputs);
  ASSERT_EQ(got.size(), wanted.size());
  for (std::size_t i = 0; i < got.size(); ++i) {
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(static_cast<double>(got[i].a[c]), wanted[i][c], 3e-4)
          << "roughness " << inputs[i].a.x << ", F0 " << f0[c];
    EXPECT_NEAR(static_cast<double>(got[i].b.x), 1.0, 1e-6) << "a perfect mirror, roughness " << inputs[i].a.x;
  }
}

TEST_F(ModelsLobes, CompensationTurnsAMirrorWhite) {
  std::vector<ProbeInput> inputs;
  for (const double roughness : kRoughness)
    for (const double v : {0.05, 0.3, 0.7, 1.0}) {
      const double alpha = roughness * roughness;
      const auto g = [alpha](double a, double b) { return reference::smithHeightCorrelated(a, b, alpha); };
      const reference::SplitSum sum = reference::integrateSplitSum(v, alpha, g);
      inputs.push_back({{v, roughness, sum.scale, sum.bias}, {}, {}, {}});
    }
  const auto got = run(
      "x = vec4(E_GGX(vec3(1), a.zw), 0); y = vec4(E_GGX(vec3(0.04), a.zw), energyCompensation(vec3(0.04), a.zw).x);",
      inputs);
  ASSERT_EQ(got.size(), inputs.size());
  for (std::size_t i = 0; i < got.size(); ++i) {
    const glm::dvec4 in(inputs[i].a);
    expectNear(static_cast<double>(got[i].a.x), 1.0, "row " + std::to_string(i));
    const double gain = 1.0 + 0.04 * (1.0 / (in.z + in.w) - 1.0);
    expectNear(static_cast<double>(got[i].b.w), gain, "row " + std::to_string(i));
    expectNear(static_cast<double>(got[i].b.x), (0.04 * in.z + in.w) * gain, "row " + std::to_string(i));
  }
}

// What dims reflections must leave them alone where nothing is in the way.
TEST_F(ModelsLobes, OcclusionTermsAreOneInTheOpen) {
  std::vector<ProbeInput> inputs;
  for (const double roughness : kRoughness)
    for (const double v : kCosines) inputs.push_back({{v, roughness * roughness, 0, 0}, {}, {}, {}});
  const auto got =
      run("x.x = specularOcclusion(a.x, 1.0, a.y); x.y = specularOcclusion(a.x, 0.0, a.y);"
          "x.z = specularOcclusion(a.x, 0.5, a.y); x.w = horizonOcclusion(vec3(sqrt(1.0 - a.x * a.x), 0, a.x), vec3(0, "
          "0, 1)); y = x;",
          inputs);
  for (std::size_t i = 0; i < got.size(); ++i) {
    EXPECT_EQ(got[i].a.x, 1.0F) << i;
    EXPECT_NEAR(got[i].a.y, 0.0F, 1e-6F) << i;
    EXPECT_GE(got[i].a.z, 0.0F) << i;
    EXPECT_LE(got[i].a.z, 1.0F) << i;
    EXPECT_EQ(got[i].a.w, 1.0F) << i;
  }
}

}  // namespace
}  // namespace dermis::test
