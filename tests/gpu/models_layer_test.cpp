// The lit layer that skin, eye, lens and metallic_roughness share (models/layered.glsl): against its twin, and against
// the laws it must keep. The DFG table it reads here is the reference's own quadrature, so that nothing is judged by
// itself.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "gpu/gl_fixture.h"
#include "gpu/models_probe.h"
#include "reference/microfacet.h"
#include "reference/quadrature.h"

namespace dermis::test {
namespace {

using reference::dvec3;

/// A table as lighting/dfg.glsl reads it, over sqrt(n·v) and perceptual roughness, 0 and 1 on texel centres.
gl::Texture quadratureTable() {
  constexpr int kColumns = 128, kRows = 64;
  std::vector<float> texels;
  for (int y = 0; y < kRows; ++y) {
    const double roughness = std::max(static_cast<double>(y) / (kRows - 1), 0.01);
    const double alpha = roughness * roughness;
    const auto g = [alpha](double v, double l) { return reference::smithHeightCorrelated(v, l, alpha); };
    for (int x = 0; x < kColumns; ++x) {
      const double root = static_cast<double>(x) / (kColumns - 1);
      const reference::SplitSum sum = reference::integrateSplitSum(std::max(root * root, 1e-5), alpha, g, 24);
      texels.push_back(static_cast<float>(sum.scale));
      texels.push_back(static_cast<float>(sum.bias));
    }
  }
  gl::TextureSpec spec;
  spec.format = GL_RG32F;
  spec.width = kColumns;
  spec.height = kRows;
  spec.label = "DFG by quadrature";
  gl::Texture texture = gl::Texture::create(spec);
  texture.upload(0, GL_RG, GL_FLOAT, texels.data());
  return texture;
}

/// One configuration of the layer, and its GLSL as the body of a function.
struct Case {
  std::string name;
  dvec3 bodyF0;
  std::vector<reference::Layer::Lobe> lobes;
  dvec3 metalF0{1.0};
  double metallic = 0.0;
};

std::string vec3Text(const dvec3& v) {
  return "vec3(" + std::to_string(v.x) + ", " + std::to_string(v.y) + ", " + std::to_string(v.z) + ")";
}

std::string probeText(const Case& c, const std::string& body) {
  std::string text = "#define DERMIS_LOBES " + std::to_string(c.lobes.size()) + "\n#include \"models/layered.glsl\"\n" +
                     "Layer layer() {\n  Layer l;\n  l.body_f0 = " + vec3Text(c.bodyF0) +
                     ";\n  l.metal_f0 = " + vec3Text(c.metalF0) + ";\n  l.metallic = " + std::to_string(c.metallic) +
                     ";\n";
  for (std::size_t i = 0; i < c.lobes.size(); ++i)
    text += std::string(i == 0 ? "  l.first" : "  l.second") + " = Lobe(" +
            std::to_string(c.lobes[i].perceptualRoughness) + ", " + std::to_string(c.lobes[i].weight) + ");\n";
  return text + "  return l;\n}\nvoid probe(vec4 a, vec4 b, vec4 c, vec4 d, out vec4 x, out vec4 y) {\n" + body +
         "\n}\n";
}

std::vector<Case> cases() {
  const dvec3 skin(reference::f0FromIor(1.40)), lens(reference::f0FromIor(1.376)), gold(1.0, 0.71, 0.29);
  return {{"skin", skin, {{0.45 * 0.75, 0.15}, {0.45 * 1.30, 0.85}}},
          {"skin, half intensity", skin, {{0.3, 0.25}, {0.6, 0.25}}},
          {"skin, F0 of gold", gold, {{0.2, 0.5}, {0.5, 0.5}}},
          {"plastic", dvec3(0.04), {{0.3, 1.0}}},
          {"gold", dvec3(0.04), {{0.6, 1.0}}, gold, 1.0},
          {"gold dust", dvec3(0.04), {{0.8, 1.0}}, gold, 0.4},
          {"lens", lens, {{0.1, 1.0}}}};
}

/// Random directions above the surface; n = +Z.
dvec3 hemisphere(std::mt19937& random) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const double z = 0.03 + 0.97 * unit(random), phi = 2.0 * std::numbers::pi * unit(random);
  const double s = std::sqrt(1.0 - z * z);
  return glm::normalize(dvec3(glm::vec3(s * std::cos(phi), s * std::sin(phi), z)));
}

class ModelsLayer : public GlTest {
 protected:
  void SetUp() override {
    GlTest::SetUp();
    static const gl::Texture kTable = quadratureTable();
    kTable.bind(18);
  }
  std::vector<ProbeOutput> run(const Case& c, const std::string& body, const std::vector<ProbeInput>& inputs) {
    gl::ShaderLibrary library;
    return runProbe(library, probeText(c, body), inputs);
  }
};

const std::string kLampBody = R"(
  vec3 n = vec3(0, 0, 1);
  LayerPoint p = layerPoint(layer(), n, a.xyz);
  x = vec4(layerSpecular(p, b.xyz, b.z, 0.0), 0);
  y = vec4(bodyTransmittance(layer(), b.z) * p.body_in * p.body_out, 0);)";

TEST_F(ModelsLayer, LampIsItsTwin) {
  std::mt19937 random(1);
  for (const Case& c : cases()) {
    const reference::Layer layer(c.bodyF0, c.lobes, c.metalF0, c.metallic);
    std::vector<ProbeInput> inputs;
    for (int i = 0; i < 400; ++i)
      inputs.push_back(
          {glm::vec4(glm::vec3(hemisphere(random)), 0), glm::vec4(glm::vec3(hemisphere(random)), 0), {}, {}});
    const auto got = run(c, kLampBody, inputs);
    ASSERT_EQ(got.size(), inputs.size());
    for (std::size_t i = 0; i < got.size(); ++i) {
      const dvec3 v = glm::normalize(dvec3(inputs[i].a)), l = glm::normalize(dvec3(inputs[i].b));
      const dvec3 specular = layer.brdf({0, 0, 1}, v, l), body = layer.lampWeight(l.z, v.z);
      for (int k = 0; k < 3; ++k) {
        EXPECT_NEAR(static_cast<double>(got[i].a[k]), specular[k], 2e-3 * specular[k] + 1e-6)
            << c.name << ", specular, " << i;
        EXPECT_NEAR(static_cast<double>(got[i].b[k]), body[k], 1.5e-3) << c.name << ", body, " << i;
      }
    }
  }
}

// Without the compensation, which looks only at the viewer, the lobes are reciprocal; the body is as it is.
TEST_F(ModelsLayer, ReciprocalAndNotNegative) {
  std::mt19937 random(2);
  for (const Case& c : cases()) {
    std::vector<ProbeInput> inputs;
    for (int i = 0; i < 2000; ++i)
      inputs.push_back(
          {glm::vec4(glm::vec3(hemisphere(random)), 0), glm::vec4(glm::vec3(hemisphere(random)), 0), {}, {}});
    const auto got = run(c, R"(
  vec3 n = vec3(0, 0, 1);
  LayerPoint p = layerPoint(layer(), n, a.xyz), q = layerPoint(layer(), n, b.xyz);
  vec3 compensated = layerSpecular(p, b.xyz, b.z, 0.0);
  vec3 f0 = mix(layer().body_f0, layer().metal_f0, layer().metallic);  // as without compensation
  p.first.at_normal = q.first.at_normal = layer().first.weight * f0;
  p.first.at_grazing = q.first.at_grazing = layer().first.weight * (1.0 - f0);
#if DERMIS_LOBES == 2
  p.second.at_normal = q.second.at_normal = layer().second.weight * f0;
  p.second.at_grazing = q.second.at_grazing = layer().second.weight * (1.0 - f0);
#endif
  vec3 there = layerSpecular(p, b.xyz, b.z, 0.0) + bodyTransmittance(layer(), b.z) * p.body_in * p.body_out / kPi;
  vec3 back = layerSpecular(q, a.xyz, a.z, 0.0) + bodyTransmittance(layer(), a.z) * q.body_in * q.body_out / kPi;
  x = vec4(there, min(min(compensated.r, compensated.g), compensated.b));
  y = vec4(back, 0);)",
                         inputs);
    ASSERT_EQ(got.size(), inputs.size());
    double worst = 0.0;
    for (std::size_t i = 0; i < got.size(); ++i) {
      for (int k = 0; k < 3; ++k) {
        const auto there = static_cast<double>(got[i].a[k]), back = static_cast<double>(got[i].b[k]);
        EXPECT_GE(there, 0.0) << c.name;
        worst = std::max(worst, std::abs(there - back) / std::max(there, 1.0));
      }
      EXPECT_GE(got[i].a.w, 0.0F) << c.name;
    }
    EXPECT_LE(worst, 1e-5) << c.name;
  }
}

// A white body under the layer, lit by a lamp from every direction at once: nothing is lost and nothing is made. The
// integral over lamps is quadrature of the shader's own values.
TEST_F(ModelsLayer, LampsFromEverywhereMakeAWhiteBodyWhite) {
  for (const double roughness : {0.15, 0.3, 0.6, 1.0})
    for (const double metallic : {0.0, 0.5, 1.0}) {
      const Case c{
          "white", dvec3(0.04), {{roughness, 0.4}, {std::min(1.0, roughness * 1.3), 0.6}}, dvec3(1.0), metallic};
      for (const double cosine : {0.2, 0.6, 0.95}) {
        const dvec3 v(std::sqrt(1.0 - cosine * cosine), 0.0, cosine);
        std::vector<ProbeInput> inputs;
        std::vector<double> solidAngles;  // with the lamp's cosine
        // Points crowd round the mirror direction, whose lobe is narrow: l mirrors v in h, and h is spread as GGX is.
        const double alpha = roughness * roughness;
        const auto nodes = reference::gaussLegendre(64);
        for (const auto& u : nodes)
          for (int j = 0; j < 128; ++j) {
            const double phi = 2.0 * std::numbers::pi * (j + 0.5) / 128.0;
            const double tan2 = alpha * alpha * u.x / (1.0 - u.x);
            const double cosH = 1.0 / std::sqrt(1.0 + tan2), sinH = std::sqrt(tan2) * cosH;
            const dvec3 h(sinH * std::cos(phi), sinH * std::sin(phi), cosH);
            const double vDotH = glm::dot(v, h);
            const dvec3 l = 2.0 * vDotH * h - v;
            if (vDotH <= 0.0 || l.z <= 1e-4) continue;
            const double pdf = reference::ggxDistribution(cosH, alpha) * cosH / (4.0 * vDotH);
            inputs.push_back({glm::vec4(glm::vec3(v), 0), glm::vec4(glm::vec3(l), 0), {}, {}});
            solidAngles.push_back(l.z * u.weight / 128.0 / pdf);
          }
        const std::size_t specularCount = inputs.size();
        for (const auto& u : nodes) {  // the body's share: ∫ 2μ dμ, no dependence on φ
          inputs.push_back(
              {glm::vec4(glm::vec3(v), 0), glm::vec4(glm::vec3(std::sqrt(1.0 - u.x * u.x), 0.0, u.x), 0), {}, {}});
          solidAngles.push_back(2.0 * u.x * u.weight);
        }
        const auto got = run(c, kLampBody, inputs);
        ASSERT_EQ(got.size(), inputs.size());
        double sum = 0.0;
        for (std::size_t i = 0; i < got.size(); ++i)
          sum += solidAngles[i] * static_cast<double>(i < specularCount ? got[i].a.x : got[i].b.x);
        EXPECT_NEAR(sum, 1.0, 0.005) << "roughness " << roughness << ", metallic " << metallic << ", cosine " << cosine;
      }
    }
}

// In a white world, what is reflected and what the body lets out are everything, for any share of metal.
TEST_F(ModelsLayer, ImageLightIsKept) {
  for (const double metallic : {0.0, 0.3, 0.7, 1.0})
    for (const double roughness : {0.02, 0.3, 0.6, 1.0}) {
      const Case c{"white", dvec3(0.04), {{roughness, 1.0}}, dvec3(1.0), metallic};
      std::vector<ProbeInput> inputs;
      for (const double cosine : {0.0, 0.1, 0.3, 0.6, 1.0})
        inputs.push_back({glm::vec4(glm::vec3(std::sqrt(1.0 - cosine * cosine), 0.0, cosine), 0), {}, {}, {}});
      const auto got = run(c,
                           "LayerPoint p = layerPoint(layer(), vec3(0, 0, 1), a.xyz); x = vec4(p.first.reflectance + "
                           "p.body_out, 0); y = x;",
                           inputs);
      for (const ProbeOutput& o : got)
        EXPECT_NEAR(o.a.x, 1.0F, 1e-5F) << "roughness " << roughness << ", metallic " << metallic;
    }
}

// Nothing reflected: the body is Lambert's, exactly.
TEST_F(ModelsLayer, NoIntensityLeavesTheBodyAlone) {
  const Case c{"off", dvec3(0.04), {{0.3, 0.0}, {0.6, 0.0}}};
  const auto got = run(c, kLampBody + "\n  y.w = p.body_out.x;", {{{0.6F, 0, 0.8F, 0}, {0, 0.8F, 0.6F, 0}, {}, {}}});
  ASSERT_EQ(got.size(), 1U);
  EXPECT_EQ(got[0].a.x, 0.0F);
  EXPECT_EQ(got[0].b.x, 1.0F);
  EXPECT_EQ(got[0].b.w, 1.0F);
}

}  // namespace
}  // namespace dermis::test
