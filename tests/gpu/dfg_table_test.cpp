// The DFG tables, looked up as the shader looks them up, against a quadrature over light directions.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "gl_fixture.h"
#include "lighting/bake_readback.h"
#include "lighting/lighting_probe.h"
#include "reference/quadrature.h"

namespace dermis::test {
namespace {

struct Pair {
  double scale, bias;
};

/// ∫ D G V·H / (N·V N·H) over half vectors. With D the GGX distribution, cos²θ_h = (1 − u) / (1 + (α² − 1) u) makes
/// D cosθ_h dω = du dφ / 2π (Walter et al. 2007, equations 35 and 36); for each u the azimuths that v sees are
/// integrated between their exact ends, so that grazing views keep their digits.
Pair integrate(DfgGeometry geometry, double nv, double roughness) {
  static const auto kNodes = reference::gaussLegendre(96);
  const double alpha = roughness * roughness;
  const double alpha2 = alpha * alpha;
  const double sv = std::sqrt(1.0 - nv * nv);
  const double k = roughness * roughness / 2.0;
  Pair sum{0.0, 0.0};
  for (const auto& nodeU : kNodes) {
    // u = w²(3 − 2w) crowds points at both ends.
    const double w = nodeU.x;
    const double u = w * w * (3.0 - 2.0 * w);
    const double weightU = nodeU.weight * 6.0 * w * (1.0 - w);
    const double ch2 = (1.0 - u) / (1.0 + (alpha2 - 1.0) * u);
    const double ch = std::sqrt(ch2);
    const double sh = std::sqrt(std::max(0.0, 1.0 - ch2));
    // v·h = sv sh cosφ + nv ch > 0, and n·l = 2 (v·h) ch − nv > 0 is the stricter of the two: cosφ > limit.
    const double limit =
        sv * sh > 0.0 ? (nv / (2.0 * ch) - nv * ch) / (sv * sh) : (nv * (2.0 * ch2 - 1.0) > 0.0 ? -2.0 : 2.0);
    if (limit >= 1.0) continue;
    const double end = limit <= -1.0 ? std::numbers::pi : std::acos(limit);
    for (const auto& nodePhi : kNodes) {
      const double phi = end * nodePhi.x;
      const double vh = sv * sh * std::cos(phi) + nv * ch;
      const double nl = 2.0 * vh * ch - nv;
      if (nl <= 0.0 || vh <= 0.0) continue;
      double g = 0.0;  // G / N·V
      if (geometry == DfgGeometry::Smith) {
        g = 2.0 * nl /
            (nl * std::sqrt(alpha2 + (1.0 - alpha2) * nv * nv) + nv * std::sqrt(alpha2 + (1.0 - alpha2) * nl * nl));
      } else {
        g = nl / ((nl * (1.0 - k) + k) * (nv * (1.0 - k) + k));
      }
      const double f = std::pow(1.0 - std::min(1.0, vh), 5.0);
      const double value = g * vh / ch * weightU * nodePhi.weight * end / std::numbers::pi;
      sum.scale += (1.0 - f) * value;
      sum.bias += f * value;
    }
  }
  return sum;
}

class DfgTable : public GlTest {
 protected:
  gl::ShaderLibrary m_shaders;
};

TEST_F(DfgTable, BothGeometryTermsAgreeWithQuadratureOnAGrid) {
  for (const DfgGeometry geometry : {DfgGeometry::Smith, DfgGeometry::SchlickIbl}) {
    std::vector<LightingQuery> queries;
    std::vector<Pair> want;
    for (int y = 1; y <= 16; ++y) {  // roughness 0 is a mirror, below
      for (int x = 0; x <= 16; ++x) {
        const double nv = std::max(1.0e-4, x / 16.0);
        queries.push_back(LightingQuery::dfg(geometry, static_cast<float>(nv), static_cast<float>(y) / 16.0F));
        want.push_back(integrate(geometry, nv, y / 16.0));
      }
    }
    const auto got = probeLighting(m_shaders, nullptr, queries);
    ASSERT_TRUE(got.has_value()) << got.error().message;
    double worst = 0.0;
    double square = 0.0;
    for (std::size_t i = 0; i < want.size(); ++i) {
      for (const double e : {(*got)[i].x - want[i].scale, (*got)[i].y - want[i].bias}) {
        worst = std::max(worst, std::abs(e));
        square += e * e;
      }
    }
    EXPECT_LE(worst, 0.002);
    EXPECT_LE(std::sqrt(square / (2.0 * static_cast<double>(want.size()))), 0.0005);
  }
}

TEST_F(DfgTable, AMirrorReflectsByFresnelAlone) {
  std::vector<LightingQuery> queries;
  for (int x = 0; x <= 16; ++x)
    queries.push_back(LightingQuery::dfg(DfgGeometry::Smith, static_cast<float>(x) / 16.0F, 0.0F));
  const auto got = probeLighting(m_shaders, nullptr, queries);
  ASSERT_TRUE(got.has_value());
  for (int x = 0; x <= 16; ++x) {
    const float f = std::pow(1.0F - static_cast<float>(x) / 16.0F, 5.0F);
    EXPECT_NEAR((*got)[static_cast<std::size_t>(x)].x, 1.0F - f, 0.002F);
    EXPECT_NEAR((*got)[static_cast<std::size_t>(x)].y, f, 0.002F);
  }
}

TEST_F(DfgTable, ReadBackHasTheLowestRoughnessInItsFirstRow) {
  const auto image = readBackDfg(DfgGeometry::Smith, 32);
  ASSERT_TRUE(image.has_value());
  ASSERT_EQ(image->width, 32);
  ASSERT_EQ(image->channels, 3);
  std::vector<float> values(std::size_t{3} * 32 * 32);
  std::memcpy(values.data(), image->pixels.data(), image->pixels.size());
  // Facing, a smooth lobe loses nothing and a rough one much.
  EXPECT_GT(values[3 * 31], 0.99F);
  EXPECT_LT(values[3 * (31 * 32 + 31)], 0.5F);
}

}  // namespace
}  // namespace dermis::test
