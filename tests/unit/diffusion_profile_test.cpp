// Diffusion profiles against quadrature that knows only R(r), and against published curves.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "core/material/diffusion_profile.h"
#include "reference/quadrature.h"

namespace dermis {
namespace {

constexpr double kPi = std::numbers::pi;

/// Burley's profile as published, with d.
double burleyDensity(double r, double d) { return (std::exp(-r / d) + std::exp(-r / (3.0 * d))) / (8.0 * kPi * d * r); }

double gaussianDensity(const GaussianTable& table, int channel, double r) {
  double sum = 0.0, total = 0.0;
  for (int i = 0; i < table.count; ++i) {
    const GaussianTerm& term = table.terms.at(static_cast<std::size_t>(i));
    sum += term.weight[channel] * std::exp(-r * r / (2.0 * term.variance)) / (2.0 * kPi * term.variance);
    total += term.weight[channel];
  }
  return sum / total;
}

/// ∫ f over a..b: composite Gauss-Legendre on a grid that doubles from a towards b, fine at the lower end.
double integral(const std::function<double(double)>& f, double a, double b) {
  static const auto kNodes = reference::gaussLegendre(24);
  double sum = 0.0;
  for (int piece = 0; piece < 48; ++piece) {
    const double low = a + (b - a) * (piece == 0 ? 0.0 : std::exp2(piece - 48.0));
    const double high = a + (b - a) * std::exp2(piece - 47.0);
    for (const auto& node : kNodes) sum += node.weight * (high - low) * f(low + node.x * (high - low));
  }
  return sum;
}

struct Case {
  const char* name;
  DiffusionProfile profile;
  std::function<double(int, double)> density;  ///< written here, not asked of the profile
};

std::vector<Case> cases() {
  const glm::dvec3 d(0.4381, 0.3398, 0.19);
  const GaussianTable table = MaterialParameters().subsurfaceGaussians;
  return {{"burley", DiffusionProfile::burley(d), [d](int c, double r) { return burleyDensity(r, d[c]); }},
          {"gaussians", DiffusionProfile::gaussians(table),
           [table](int c, double r) { return gaussianDensity(table, c, r); }}};
}

TEST(DiffusionProfile, IsTheDensityAndItIntegratesToOneOverThePlane) {
  for (const Case& test : cases())
    for (int c = 0; c < 3; ++c) {
      for (const double r : {0.01, 0.2, 1.0, 4.0})
        EXPECT_NEAR(test.profile.value(r)[c], test.density(c, r), 1e-6 * test.density(c, r) + 1e-12) << test.name;
      const double most = 60.0;
      const double whole = integral([&](double r) { return 2.0 * kPi * r * test.profile.value(r)[c]; }, 0.0, most);
      EXPECT_NEAR(whole, 1.0, 1e-3) << test.name << c;
      const double tail =
          integral([&](double r) { return 2.0 * kPi * r * test.density(c, r); }, test.profile.extent()[c], most);
      EXPECT_NEAR(tail, 1.0 / 4000.0, 2e-6) << test.name << " beyond its extent";
      if (test.profile.family() == DiffusionFamily::Burley) {
        EXPECT_GE(test.profile.extent()[c], 12.0 * test.profile.lengths()[c]);
      }
    }
}

TEST(DiffusionProfile, CdfAndItsInverse) {
  for (const Case& test : cases())
    for (int c = 0; c < 3; ++c) {
      double last = 0.0;
      for (const double r : {0.003, 0.02, 0.1, 0.3, 1.0, 2.5, 7.0}) {
        const double within = integral([&](double x) { return 2.0 * kPi * x * test.density(c, x); }, 0.0, r);
        const double cdf = test.profile.radialCdf(r)[c];
        EXPECT_NEAR(cdf, within, 1e-5) << test.name << c << " at " << r;
        EXPECT_GT(cdf, last) << test.name << " is monotone";
        last = cdf;
      }
      for (const double u : {0.0, 1e-4, 0.01, 0.3, 0.5, 0.9, 0.999})
        EXPECT_NEAR(test.profile.radialCdf(test.profile.radius(c, u))[c], u, 1e-9) << test.name << c;
    }
}

TEST(DiffusionProfile, LineAndEdge) {
  for (const Case& test : cases())
    for (int c = 0; c < 3; ++c) {
      // y = x sinh t turns ∫ R(√(x² + y²)) dy into a smooth integral.
      const auto line = [&](double x) {
        return 2.0 * integral([&](double t) { return test.density(c, x * std::cosh(t)) * x * std::cosh(t); }, 0.0,
                              std::acosh(std::max(60.0 / x, 2.0)));
      };
      for (const double x : {0.01, 0.1, 0.5, 2.0})
        EXPECT_NEAR(test.profile.lineSpread(x)[c], line(x), 1e-5 * line(x) + 1e-9) << test.name << c << " at " << x;
      EXPECT_DOUBLE_EQ(test.profile.lineSpread(-0.5)[c], test.profile.lineSpread(0.5)[c]);
      EXPECT_NEAR(2.0 * integral([&](double x) { return test.profile.lineSpread(x)[c]; }, 0.0, 60.0), 1.0, 1e-3);
      double last = 0.0;
      for (const double x : {-4.0, -1.0, -0.3, -0.05, 0.0, 0.05, 0.3, 1.0, 4.0}) {
        // Of the ring at r, the share acos(|x|/r)/π lies beyond the edge.
        const double distance = std::abs(x);
        const double beyond =
            integral([&](double r) { return 2.0 * r * test.density(c, r) * std::acos(distance / r); }, distance, 60.0);
        const double edge = test.profile.edgeSpread(x)[c];
        EXPECT_NEAR(edge, x > 0.0 ? 1.0 - beyond : beyond, 2e-5) << test.name << c << " at " << x;
        EXPECT_GE(edge, last);
        last = edge;
      }
    }
}

// The published six Gaussians (d'Eon & Luebke 2007), ½ Σ w (1 + erf(x/√2v)) evaluated apart from this program.
TEST(DiffusionProfile, PublishedStepEdge) {
  struct Row {
    double x;
    std::array<double, 3> edge;
  };
  constexpr std::array<Row, 9> kRows = {{
      {-3.0, {0.0165380, 0.0000671, 0.0000002}},
      {-1.0, {0.1250840, 0.0036566, 0.0006455}},
      {-0.3, {0.2608728, 0.0814265, 0.0321748}},
      {-0.1, {0.3625704, 0.2430882, 0.1834000}},
      {0.05, {0.5775696, 0.6460358, 0.6829843}},
      {0.2, {0.7022079, 0.8678697, 0.9307151}},
      {0.5, {0.7928782, 0.9683989, 0.9942633}},
      {2.0, {0.9535446, 0.9996594, 0.9999723}},
      {6.0, {0.9989232, 1.0000000, 1.0000000}},
  }};
  const DiffusionProfile profile = DiffusionProfile::gaussians(MaterialParameters().subsurfaceGaussians);
  for (const Row& row : kRows)
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(profile.edgeSpread(row.x)[c], row.edge.at(static_cast<std::size_t>(c)), 1e-6) << row.x;
}

// s(A) of both readings at A = 0.8, 0.5, 0.4: materials.md's formulas by hand.
TEST(DiffusionProfile, ReadingsOfTheRadius) {
  Material material;
  MaterialParameters& p = material.parameters;
  p.subsurfaceRadiusMm = {0.2628F, 0.3537F, 0.2476F};
  const glm::vec3 albedo(0.8F, 0.5F, 0.4F);
  p.subsurfaceRadiusReading = RadiusReading::MeanFreePath;
  glm::dvec3 d = DiffusionProfile::of(material, albedo).lengths();
  EXPECT_NEAR(d.x, 0.2628 / 1.1, 1e-6);
  EXPECT_NEAR(d.y, 0.3537 / 1.715, 1e-6);
  EXPECT_NEAR(d.z, 0.2476 / 2.06, 1e-6);
  p.subsurfaceRadiusReading = RadiusReading::DiffuseMeanFreePath;
  d = DiffusionProfile::of(material, albedo).lengths();
  EXPECT_NEAR(d.x, 0.2628 / (3.5 + 100 * 0.04879681), 1e-6);
  p.subsurfaceRadiusReading = RadiusReading::BurleyD;
  d = DiffusionProfile::of(material, albedo).lengths();
  EXPECT_NEAR(d.y, 0.3537, 1e-6);
  p.subsurfaceScale = 2.0F;
  p.subsurfaceColor.rgb = {1.0F, 0.5F, 0.0F};
  const DiffusionProfile scaled = DiffusionProfile::of(material, albedo);
  EXPECT_NEAR(scaled.lengths().x, 2.0 * 0.2628, 1e-6);
  EXPECT_NEAR(scaled.lengths().y, 0.3537, 1e-6);
  EXPECT_EQ(scaled.direct(), glm::dvec3(0.0, 0.0, 1.0)) << "what has no length leaves where it entered";
  EXPECT_EQ(scaled.extent().z, 0.0);
  EXPECT_EQ(scaled.radialCdf(0.0).z, 1.0);
}

TEST(DiffusionProfile, GaussiansAreNormalisedAndScaled) {
  Material material;
  MaterialParameters& p = material.parameters;
  p.subsurfaceProfile = DiffusionFamily::Gaussians;
  p.subsurfaceGaussians = {{{{1.0F, {2.0F, 0.5F, 0.0F}}, {0.0F, {0.0F, 0.5F, 0.0F}}}}, 2};
  p.subsurfaceScale = 3.0F;
  const DiffusionProfile profile = DiffusionProfile::of(material, glm::vec3(0.5F));
  EXPECT_NEAR(profile.lengths().x, 3.0, 1e-9);
  EXPECT_NEAR(profile.value(1.5).x, std::exp(-1.5 * 1.5 / 18.0) / (18.0 * kPi), 1e-9);
  EXPECT_NEAR(profile.direct().x, 0.0, 1e-12);
  EXPECT_NEAR(profile.direct().y, 0.5, 1e-12) << "a Gaussian without width";
  EXPECT_NEAR(profile.direct().z, 1.0, 1e-12) << "a channel without weights";
  EXPECT_NEAR(profile.edgeSpread(-1e-9).y, 0.25, 1e-6);
  EXPECT_NEAR(profile.edgeSpread(1e-9).y, 0.75, 1e-6);
}

}  // namespace
}  // namespace dermis
