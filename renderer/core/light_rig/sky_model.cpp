#include "core/light_rig/sky_model.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/light_rig/light_colour.h"

namespace dermis {
namespace {

constexpr double kPi = std::numbers::pi;

/// Zenith chromaticity, appendix A.2: (T², T, 1) · M · (θ³, θ², θ, 1).
double zenithChromaticity(const std::array<std::array<double, 4>, 3>& m, double t, double theta) {
  const auto row = [&](std::size_t i) { return ((m[i][0] * theta + m[i][1]) * theta + m[i][2]) * theta + m[i][3]; };
  return (t * row(0) + row(1)) * t + row(2);
}

// Extraterrestrial radiance of the sun's disc from 380 to 750 nm in steps of 10 nm, 100 W/(m² nm sr), and the
// absorption of ozone there, 1/cm: table 2 of the paper. Water vapour and mixed gases absorb past 689 nm, where the eye
// sees less than a hundredth of its best, and are left out.
constexpr int kFirst = 380, kStep = 10;
constexpr std::array<double, 38> kSun = {165.5, 162.3, 211.2, 258.8, 258.2, 242.3, 267.6, 296.6, 305.4, 300.6,
                                         306.6, 288.3, 287.1, 278.2, 271.0, 272.3, 263.6, 255.0, 250.6, 253.1,
                                         253.5, 251.3, 246.3, 241.7, 236.8, 232.1, 228.2, 223.4, 219.7, 215.3,
                                         211.0, 207.3, 202.4, 198.7, 194.3, 190.7, 186.3, 182.6};
constexpr std::array<double, 38> kOzone = {0,     0,     0,     0,     0,     0,     0,     0.003, 0.006, 0.009,
                                           0.014, 0.021, 0.030, 0.040, 0.048, 0.063, 0.075, 0.085, 0.103, 0.120,
                                           0.120, 0.115, 0.125, 0.120, 0.105, 0.090, 0.079, 0.067, 0.057, 0.048,
                                           0.036, 0.028, 0.023, 0.018, 0.014, 0.011, 0.010, 0.009};
/// Solid angle of the disc that the table is of: 0.533° across.
constexpr double kSunSolidAngle = 6.794e-5;
constexpr double kLumensPerWatt = 683.0;

}  // namespace

double SkyModel::Perez::value(double cosTheta, double gamma, double cosGamma) const {
  // Equation 3 (Perez, Seals & Michalsky 1993).
  return (1.0 + a * std::exp(b / cosTheta)) * (1.0 + c * std::exp(d * gamma) + e * cosGamma * cosGamma);
}

SkyModel::SkyModel(double t, const glm::dvec3& sun) : m_sun(sun) {
  const double thetaS = std::acos(std::clamp(sun.y, 0.0, 1.0));
  // Appendix A.2. Luminance there is in thousands of cd/m².
  const double chi = (4.0 / 9.0 - t / 120.0) * (kPi - 2.0 * thetaS);
  const double luminance = 1000.0 * ((4.0453 * t - 4.9710) * std::tan(chi) - 0.2155 * t + 2.4192);
  constexpr std::array<std::array<double, 4>, 3> kX = {{{0.00166, -0.00375, 0.00209, 0.0},
                                                        {-0.02903, 0.06377, -0.03202, 0.00394},
                                                        {0.11693, -0.21196, 0.06052, 0.25886}}};
  constexpr std::array<std::array<double, 4>, 3> kY = {{{0.00275, -0.00610, 0.00317, 0.0},
                                                        {-0.04214, 0.08970, -0.04153, 0.00516},
                                                        {0.15346, -0.26756, 0.06670, 0.26688}}};
  m_zenith = {zenithChromaticity(kX, t, thetaS), zenithChromaticity(kY, t, thetaS), luminance};
  // Appendix A.2, the distribution's coefficients.
  m_perez = {
      {{-0.0193 * t - 0.2592, -0.0665 * t + 0.0008, -0.0004 * t + 0.2125, -0.0641 * t - 0.8989, -0.0033 * t + 0.0452},
       {-0.0167 * t - 0.2608, -0.0950 * t + 0.0092, -0.0079 * t + 0.2102, -0.0441 * t - 1.6537, -0.0109 * t + 0.0529},
       {0.1787 * t - 1.4630, -0.3554 * t + 0.4275, -0.0227 * t + 5.3251, 0.1206 * t - 2.5771, -0.0670 * t + 0.3703}}};
  for (std::size_t i = 0; i < 3; ++i) m_overhead.at(i) = m_perez.at(i).value(1.0, thetaS, std::cos(thetaS));
}

glm::dvec3 SkyModel::xyY(const glm::dvec3& direction) const {
  // The exponent's 1/cos θ is finite a hair above the horizon.
  const double cosTheta = std::max(direction.y, 1e-3);
  const double cosGamma = std::clamp(glm::dot(direction, m_sun), -1.0, 1.0);
  const double gamma = std::acos(cosGamma);
  glm::dvec3 value;
  for (int i = 0; i < 3; ++i) {
    const auto at = static_cast<std::size_t>(i);
    value[i] = m_zenith[i] * m_perez.at(at).value(cosTheta, gamma, cosGamma) / m_overhead.at(at);
  }
  return value;
}

glm::dvec3 SkyModel::radiance(const glm::dvec3& direction) const {
  const glm::dvec3 v = xyY(direction);
  return std::max(v.z, 0.0) * colourOfChromaticity({v.x, v.y});
}

glm::dvec3 sunIlluminance(double turbidity, double sunElevation) {
  if (sunElevation <= 0.0) return glm::dvec3(0.0);
  // Appendix A.1. Relative optical mass with the zenith angle in degrees (Kasten 1965).
  const double degrees = 90.0 - sunElevation * 180.0 / kPi;
  const double m = 1.0 / (std::sin(sunElevation) + 0.15 * std::pow(93.885 - degrees, -1.253));
  const double beta = 0.04608365822050 * turbidity - 0.04586025928522;
  constexpr double kOzoneCentimetres = 0.35;
  constexpr double kAngstromExponent = 1.3;
  glm::dvec3 xyz(0.0);
  for (std::size_t i = 0; i < kSun.size(); ++i) {
    const double nanometres = kFirst + kStep * static_cast<double>(i);
    const double micrometres = nanometres / 1000.0;
    const double rayleigh = 0.008735 * std::pow(micrometres, -4.08);
    const double aerosol = beta * std::pow(micrometres, -kAngstromExponent);
    const double left = std::exp(-m * (rayleigh + aerosol + kOzone.at(i) * kOzoneCentimetres));
    xyz += 100.0 * kSun.at(i) * left * colourMatching(nanometres);
  }
  return insideRec709(rec709FromXyz(xyz * (kLumensPerWatt * kStep * kSunSolidAngle)));
}

}  // namespace dermis
