// Colours of light and the clear sky against published values.
#include "core/light_rig/sky_model.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/light_rig/light_colour.h"
#include "reference/quadrature.h"

namespace dermis {
namespace {

constexpr double kPi = std::numbers::pi;

glm::dvec3 towards(double elevationDegrees, double azimuthDegrees = 0.0) {
  const double e = glm::radians(elevationDegrees), a = glm::radians(azimuthDegrees);
  return {std::cos(e) * std::sin(a), std::sin(e), std::cos(e) * std::cos(a)};
}

TEST(LightColour, ChromaticitiesAreThoseOfTheStandardIlluminants) {
  // CIE 15:2004, table T.3: illuminant A is a black body of 2856 K; D50, D65 and D75 are daylight.
  const glm::dvec2 a = blackBodyChromaticity(2856.0);
  EXPECT_NEAR(a.x, 0.44758, 0.0006);
  EXPECT_NEAR(a.y, 0.40745, 0.0006);
  struct Row {
    double kelvin, x, y;
  };
  for (const Row& row : {Row{5003.0, 0.34567, 0.35851}, Row{6504.0, 0.31272, 0.32903}, Row{7504.0, 0.29903, 0.31488}}) {
    const glm::dvec2 d = daylightChromaticity(row.kelvin);
    EXPECT_NEAR(d.x, row.x, 0.0004) << row.kelvin;
    EXPECT_NEAR(d.y, row.y, 0.0004) << row.kelvin;
  }
}

TEST(LightColour, TemperaturesKeepLuminanceAndStayInRec709) {
  for (const double kelvin : {1000.0, 1900.0, 2856.0, 4000.0, 6500.0, 15000.0}) {
    const glm::dvec3 rgb = colourOfChromaticity(blackBodyChromaticity(kelvin));
    EXPECT_NEAR(luminance(rgb), 1.0, 1e-4) << kelvin;
    EXPECT_GE(std::min({rgb.r, rgb.g, rgb.b}), 0.0) << kelvin;
    EXPECT_EQ(rgb.r > rgb.b, kelvin < 6600.0) << kelvin;
  }
  // Daylight of 6504 K is white.
  const glm::dvec3 white = colourOfChromaticity(daylightChromaticity(6504.0));
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(white[i], 1.0, 0.005);
}

TEST(LightColour, MatchingFunctionsOfEqualEnergyAreEqual) {
  glm::dvec3 sum(0.0);
  for (int nm = 380; nm <= 780; ++nm) sum += colourMatching(nm);
  // CIE 1931: the three integrals are 106.857 nm; the fit's authors give errors of about a percent.
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(sum[i], 106.857, 1.1) << i;
}

TEST(SkyModel, ZenithFollowsThePublishedFormulas) {
  // Worked by hand from appendix A.2 for turbidity 2.5 and a sun 30° from the zenith: χ = (4/9 − 1/48)(π − π/3) =
  // 0.887209, Y = 5.14225 tan χ + 1.88045.
  const SkyModel model(2.5, towards(60.0));
  EXPECT_NEAR(model.zenith().z, 1000.0 * (5.14225 * std::tan(0.887209) + 1.88045), 0.5);
  EXPECT_NEAR(model.zenith().z, 8192.0, 5.0);
  // With the sun in the zenith only the constants stay: x = 0.00394 T + 0.25886, y = 0.00516 T + 0.26688.
  const SkyModel overhead(4.0, towards(90.0));
  EXPECT_NEAR(overhead.zenith().x, 0.00394 * 4.0 + 0.25886, 1e-6);
  EXPECT_NEAR(overhead.zenith().y, 0.00516 * 4.0 + 0.26688, 1e-6);
}

TEST(SkyModel, TheDistributionIsTheZenithsOverheadAndBrightestAtTheSun) {
  const glm::dvec3 sun = towards(35.0, 20.0);
  const SkyModel model(3.0, sun);
  const glm::dvec3 overhead = model.xyY({0.0, 1.0, 0.0});
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(overhead[i], model.zenith()[i], 1e-9 * model.zenith()[i]);
  double brightest = 0.0;
  glm::dvec3 where(0.0);
  for (int e = 1; e < 90; ++e)
    for (int a = 0; a < 360; a += 2)
      if (const double y = model.xyY(towards(e, a)).z; y > brightest) {
        brightest = y;
        where = towards(e, a);
      }
  EXPECT_GT(glm::dot(where, sun), std::cos(glm::radians(6.0)));
  // Away from the sun a clear sky is bluer overhead than at the horizon.
  const glm::dvec3 high = model.xyY(towards(75.0, 200.0)), low = model.xyY(towards(5.0, 200.0));
  EXPECT_LT(high.x, low.x);
  EXPECT_LT(high.y, low.y);
}

TEST(SkyModel, TheSunGivesWhatItDoesOnMeasuredClearDays) {
  // IES Lighting Handbook's clear day (Gillette, Pierpoint & Treado 1984): 127.5 klx · exp(−0.21 m) on a surface that
  // faces the sun.
  for (const double elevation : {10.0, 20.0, 35.0, 50.0, 65.0}) {
    const double sine = std::sin(glm::radians(elevation));
    const double direct = luminance(sunIlluminance(2.0, glm::radians(elevation)));
    EXPECT_NEAR(direct / (127500.0 * std::exp(-0.21 / sine)), 1.0, 0.06) << elevation;
  }
}

TEST(SkyModel, TheSkyIsBrighterThanMeasuredOnesByAsMuchAsDocsSay) {
  // The same handbook's clear sky gives 0.8 + 15.5 √sin γ klx on level ground.
  const auto nodes = reference::gaussLegendre(24);
  for (const double elevation : {20.0, 35.0, 50.0, 65.0}) {
    const SkyModel model(2.0, towards(elevation));
    double diffuse = 0.0;
    for (const auto& high : nodes)  // ∫ L cos θ dω with u = sin² of the elevation
      for (const auto& round : nodes)
        diffuse += kPi * high.weight * round.weight *
                   model.xyY(towards(glm::degrees(std::asin(std::sqrt(high.x))), 360.0 * round.x)).z;
    const double measured = 800.0 + 15500.0 * std::sqrt(std::sin(glm::radians(elevation)));
    EXPECT_GT(diffuse / measured, 1.5) << elevation;
    EXPECT_LT(diffuse / measured, 2.3) << elevation;
  }
}

TEST(SkyModel, TheSunReddensAndDimsOnItsWayDown) {
  double last = 1e9, lastShare = 10.0;
  for (const double elevation : {80.0, 40.0, 20.0, 10.0, 5.0, 2.0}) {
    const glm::dvec3 e = sunIlluminance(3.0, glm::radians(elevation));
    EXPECT_LT(luminance(e), last);
    EXPECT_LT(e.b / e.r, lastShare);
    last = luminance(e);
    lastShare = e.b / e.r;
  }
  EXPECT_EQ(sunIlluminance(3.0, -0.01), glm::dvec3(0.0));
}

}  // namespace
}  // namespace dermis
