#include "reference/published.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <numbers>

#include "reference/quadrature.h"

namespace dermis::reference {

using std::numbers::pi;

Surroundings constantSurroundings(const dvec3& radiance) {
  return {[=](const dvec3&) { return radiance; }, [=](const dvec3&) { return radiance; },
          [=](const dvec3&, double) { return radiance; }};
}

namespace {

/// Mean of cos θ_l about the axis, weighted by D(h) n·l over directions l with n = v (Karis 2013's prefiltering).
double meanCosineOfLobe(double perceptualRoughness) {
  const double alpha = perceptualRoughness * perceptualRoughness;
  double sum = 0.0, weights = 0.0;
  for (const QuadratureNode& u : gaussLegendre(256)) {
    const double tan2 = alpha * alpha * u.x / (1.0 - u.x);
    const double cosL = 2.0 / (1.0 + tan2) - 1.0;  // l leans twice as far as h
    if (cosL <= 0.0) continue;
    sum += u.weight * cosL * cosL;
    weights += u.weight * cosL;
  }
  return sum / weights;
}

}  // namespace

Surroundings linearSurroundings(const dvec3& base, const dvec3& x, const dvec3& y, const dvec3& z) {
  const auto slope = [=](const dvec3& d) { return x * d.x + y * d.y + z * d.z; };
  const auto known =
      std::make_shared<std::map<double, double>>();  // a sphere asks for the same roughness at each pixel
  return {[=](const dvec3& d) { return base + slope(d); },
          [=](const dvec3& n) { return base + slope(n) * (2.0 / 3.0); },
          [=](const dvec3& r, double roughness) {
            const auto [mean, isNew] = known->try_emplace(roughness, 0.0);
            if (isNew) mean->second = meanCosineOfLobe(roughness);
            return base + slope(r) * mean->second;
          }};
}

SplitSumCurve thesisSplitSum(double roughness) {
  const double k = roughness * roughness / 2.0;
  return {roughness * roughness, [k](double v, double l) { return schlickGeometry(v, l, k); }};
}

dvec3 thesisRadiance(const ThesisMaterial& m, const SplitSumCurve& table, const dvec3& n, const dvec3& v,
                     const std::vector<Arriving>& lights, const Surroundings* around) {
  const dvec3 f0 = glm::mix(dvec3(0.04), m.albedo, m.metallic);
  const dvec3 f0s = glm::mix(f0, dvec3(m.specular), m.metallic);
  const double alpha = m.roughness * m.roughness;
  const double nDotV = std::max(glm::dot(n, v), 0.0);
  dvec3 lo(0.0);
  for (const Arriving& light : lights) {
    const dvec3 h = glm::normalize(light.toLight + v);
    const double nDotL = std::max(glm::dot(n, light.toLight), 0.0);
    const double nDotH = std::max(glm::dot(n, h), 0.0);
    const double spread = nDotH * nDotH * (alpha * alpha - 1.0) + 1.0;
    const double d = alpha * alpha / (pi * spread * spread);
    const double k = (m.roughness + 1.0) * (m.roughness + 1.0) / 8.0;
    const double g = schlickGeometry(nDotV, nDotL, k);
    const dvec3 f = f0s + (1.0 - f0s) * std::pow(1.0 - std::max(glm::dot(h, v), 0.0), 5.0);
    const dvec3 specular = d * g * f / (4.0 * nDotV * nDotL + 0.0001);
    const dvec3 kd = (1.0 - f) * (1.0 - m.metallic);
    const dvec3 sss = m.sssColor * (1.0 - std::exp(-m.thickness * m.sssScale * nDotL));
    lo += (kd * m.albedo / pi + specular + sss) * light.irradiance * nDotL;
  }
  if (around == nullptr) return lo;
  const dvec3 f = f0s + (glm::max(dvec3(1.0 - m.roughness), f0s) - f0s) * std::pow(1.0 - nDotV, 5.0);
  const dvec3 kd = (1.0 - f) * (1.0 - m.metallic);
  const SplitSum dfg = table.at(nDotV);
  const dvec3 diffuse = around->irradianceOverPi(n) * m.albedo;
  const dvec3 specular = around->prefiltered(glm::reflect(-v, n), m.roughness) * (f * dfg.scale + dfg.bias);
  return lo + (kd * diffuse + specular) * m.occlusion;
}

dvec3 labReflection(const dvec3& n, const dvec3& v, const Surroundings& around) {
  return glm::pow(around.radiance(glm::reflect(-v, n)), dvec3(1.0 / 2.2));
}

dvec3 labMicrofacet(const dvec3& f0, double perceptualRoughness, LabTerm geometry, const dvec3& n, const dvec3& v,
                    const Surroundings& around) {
  const dvec3 l = glm::reflect(-v, n), h = glm::normalize(l + v);
  const double intensity = (f0.x + f0.y + f0.z) / 3.0;
  const double nv = glm::dot(n, v), nl = glm::dot(n, l), nh = glm::dot(n, h), vh = glm::dot(v, h);
  const dvec3 f = f0 + (1.0 - f0) * std::pow(1.0 - nl, 5.0) + 0.4 * (1.0 - intensity);
  double g = 1.0;
  if (geometry == LabTerm::Smith) {
    const double k = 0.3 * 0.3 / 2.0;
    const auto sub = [k](double x) { return x / (x * (1.0 - k) + k); };
    g = sub(nv) * sub(nl);
  }
  if (geometry == LabTerm::CookTorrance) g = std::min({1.0, 2.0 * nh * nv / vh, 2.0 * nh * nl / vh});
  const dvec3 d = glm::pow(around.prefiltered(l, perceptualRoughness), dvec3(1.0 / 2.2));
  return (1.0 - intensity) * d + f * g * d / (4.0 * nl * nl);
}

}  // namespace dermis::reference
