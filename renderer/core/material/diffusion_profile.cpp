#include "core/material/diffusion_profile.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace dermis {

namespace {

constexpr double kPi = std::numbers::pi;
/// All but this share of the light leaves within extent().
constexpr double kBeyondExtent = 1.0 / 4000.0;

/// ∫₀^∞ e^(−u cosh t) / cosh^order t dt: order 0 is the Bessel function K₀(u), order 1 its integral from u to infinity
/// (Bickley & Naylor 1935). The trapezoid rule of a function that is analytic in a strip converges exponentially: with
/// this step to 1e-14 (Trefethen & Weideman 2014).
double besselIntegral(int order, double u) {
  constexpr double kStep = 0.125;
  double sum = 0.0;
  for (int i = 0; i < 400; ++i) {
    const double c = std::cosh(kStep * i);
    const double term = std::exp(-u * c) / (order == 1 ? c : 1.0);
    sum += i == 0 ? 0.5 * term : term;
    if (term < 1e-17 * sum) break;
  }
  return kStep * sum;
}
double besselK0(double u) { return besselIntegral(0, u); }
double besselK0Beyond(double u) { return besselIntegral(1, u); }

/// The share x of the light, in units of d, that leaves beyond x = r/d.
double burleyBeyond(double x) { return 0.25 * std::exp(-x) + 0.75 * std::exp(-x / 3.0); }

/// Its inverse, the real root of y³ + 3y = 4u for y = e^(−x/3) (Golubev 2018, "Efficient Screen-Space Subsurface
/// Scattering Using Burley's Normalized Diffusion in Real-Time").
double burleyRadius(double beyond) {
  const double g = 1.0 + 4.0 * beyond * (2.0 * beyond + std::sqrt(1.0 + 4.0 * beyond * beyond));
  const double root = std::cbrt(g);
  return 3.0 * std::log((1.0 + 1.0 / root + root) / (4.0 * beyond));
}

template <class F>
glm::dvec3 eachChannel(F&& f) {
  return {f(0), f(1), f(2)};
}

}  // namespace

double burleyScaling(RadiusReading reading, double albedo) {
  switch (reading) {
    case RadiusReading::DiffuseMeanFreePath:
      return 3.5 + 100.0 * std::pow(albedo - 0.33, 4.0);
    case RadiusReading::MeanFreePath:
      return 1.9 - albedo + 3.5 * (albedo - 0.8) * (albedo - 0.8);
    case RadiusReading::BurleyD:
      break;
  }
  return 1.0;
}

DiffusionProfile DiffusionProfile::burley(const glm::dvec3& d) {
  DiffusionProfile profile;
  profile.m_d = glm::max(d, 0.0);
  return profile;
}

DiffusionProfile DiffusionProfile::gaussians(const GaussianTable& table, const glm::dvec3& scale) {
  DiffusionProfile profile;
  profile.m_family = DiffusionFamily::Gaussians;
  for (int c = 0; c < 3; ++c) {
    double total = 0.0;
    for (int i = 0; i < table.count; ++i) total += table.terms.at(static_cast<std::size_t>(i)).weight[c];
    if (!(total > 0.0)) continue;  // a channel without any weight doesn't diffuse
    for (std::size_t i = 0; i < static_cast<std::size_t>(table.count); ++i) {
      const GaussianTerm& term = table.terms.at(i);
      profile.m_terms.at(static_cast<std::size_t>(c)).at(i) = {static_cast<double>(term.variance) * scale[c] * scale[c],
                                                               term.weight[c] / total};
    }
  }
  return profile;
}

DiffusionProfile DiffusionProfile::of(const Material& material, const glm::vec3& albedo) {
  const MaterialParameters& p = material.parameters;
  if (material.model == ShadingModel::Eye) {
    // The sclera scatters strongly: reduced mean free paths at 620, 540 and 460 nm (Bashkatov et al. 2010, "Optical
    // properties of human sclera in spectral range 370–2500 nm").
    const glm::dvec3 pathMm(0.27, 0.20, 0.16);
    return burley(eachChannel(
        [&](int c) { return pathMm[c] / burleyScaling(RadiusReading::MeanFreePath, p.eyeScleraColor.rgb[c]); }));
  }
  if (material.model != ShadingModel::Skin) return {};
  const glm::dvec3 scale = static_cast<double>(p.subsurfaceScale) * glm::dvec3(p.subsurfaceColor.rgb);
  if (p.subsurfaceProfile == DiffusionFamily::Gaussians) return gaussians(p.subsurfaceGaussians, scale);
  return burley(eachChannel([&](int c) {
    const double a = std::clamp(static_cast<double>(albedo[c]), 0.0, 1.0);
    return scale[c] * p.subsurfaceRadiusMm[c] / burleyScaling(p.subsurfaceRadiusReading, a);
  }));
}

double DiffusionProfile::beyond(int channel, double r) const {
  if (m_family == DiffusionFamily::Burley) return m_d[channel] > 0.0 ? burleyBeyond(r / m_d[channel]) : 0.0;
  double sum = 0.0;
  for (const Term& term : m_terms.at(static_cast<std::size_t>(channel)))
    if (term.variance > 0.0) sum += term.weight * std::exp(-0.5 * r * r / term.variance);
  return sum;
}

glm::dvec3 DiffusionProfile::direct() const {
  return eachChannel([&](int c) { return std::max(1.0 - beyond(c, 0.0), 0.0); });
}

glm::dvec3 DiffusionProfile::lengths() const {
  if (m_family == DiffusionFamily::Burley) return m_d;
  return eachChannel([&](int c) {
    double variance = 0.0;
    for (const Term& term : m_terms.at(static_cast<std::size_t>(c))) variance += term.weight * term.variance;
    return std::sqrt(variance);
  });
}

glm::dvec3 DiffusionProfile::extent() const {
  return eachChannel([&](int c) { return radius(c, 1.0 - kBeyondExtent); });
}

glm::dvec3 DiffusionProfile::value(double r) const {
  return eachChannel([&](int c) {
    if (m_family == DiffusionFamily::Burley) {
      const double d = m_d[c];
      return d > 0.0 ? (std::exp(-r / d) + std::exp(-r / (3.0 * d))) / (8.0 * kPi * d * r) : 0.0;
    }
    double sum = 0.0;
    for (const Term& term : m_terms.at(static_cast<std::size_t>(c)))
      if (term.variance > 0.0)
        sum += term.weight * std::exp(-0.5 * r * r / term.variance) / (2.0 * kPi * term.variance);
    return sum;
  });
}

glm::dvec3 DiffusionProfile::radialCdf(double r) const {
  return eachChannel([&](int c) { return 1.0 - beyond(c, std::max(r, 0.0)); });
}

double DiffusionProfile::radius(int channel, double u) const {
  const double target = std::max(1.0 - u, std::numeric_limits<double>::min());
  if (target >= beyond(channel, 0.0)) return 0.0;
  if (m_family == DiffusionFamily::Burley) return m_d[channel] * burleyRadius(target);
  // The share beyond falls monotonically: bracket it, then halve the bracket in its square, which is nearly linear.
  double high = 0.0;
  for (const Term& term : m_terms.at(static_cast<std::size_t>(channel))) high = std::max(high, term.variance);
  while (beyond(channel, std::sqrt(high)) > target) high *= 2.0;
  double low = 0.0;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (beyond(channel, std::sqrt(middle)) > target ? low : high) = middle;
  }
  return std::sqrt(0.5 * (low + high));
}

glm::dvec3 DiffusionProfile::lineSpread(double x) const {
  // ∫ e^(−r/a)/r dy = 2 K₀(|x|/a), with r² = x² + y².
  return eachChannel([&](int c) {
    if (m_family == DiffusionFamily::Burley) {
      const double d = m_d[c];
      if (!(d > 0.0)) return 0.0;
      return (besselK0(std::abs(x) / d) + besselK0(std::abs(x) / (3.0 * d))) / (4.0 * kPi * d);
    }
    double sum = 0.0;
    for (const Term& term : m_terms.at(static_cast<std::size_t>(c)))
      if (term.variance > 0.0)
        sum += term.weight * std::exp(-0.5 * x * x / term.variance) / std::sqrt(2.0 * kPi * term.variance);
    return sum;
  });
}

glm::dvec3 DiffusionProfile::edgeSpread(double x) const {
  const double distance = std::abs(x);
  return eachChannel([&](int c) {
    double past = 0.0;  // what the line spread holds beyond |x|, on one side; light without width holds none there
    if (x == 0.0) {
      past = 0.5;
    } else if (m_family == DiffusionFamily::Burley) {
      const double d = m_d[c];
      if (d > 0.0) past = (besselK0Beyond(distance / d) + 3.0 * besselK0Beyond(distance / (3.0 * d))) / (4.0 * kPi);
    } else {
      for (const Term& term : m_terms.at(static_cast<std::size_t>(c)))
        if (term.variance > 0.0) past += 0.5 * term.weight * std::erfc(distance / std::sqrt(2.0 * term.variance));
    }
    return x > 0.0 ? 1.0 - past : past;
  });
}

}  // namespace dermis
