#include "reference/microfacet.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "reference/quadrature.h"

namespace dermis::reference {

using std::numbers::pi;

double ggxDistribution(double nDotH, double alpha) {
  if (nDotH <= 0.0) return 0.0;
  const double cos2 = nDotH * nDotH;
  const double tan2 = std::max(1.0 - cos2, 0.0) / cos2;
  const double denominator = cos2 * (alpha * alpha + tan2);
  return alpha * alpha / (pi * denominator * denominator);
}

double smithLambda(double cosTheta, double alpha) {
  const double cos2 = cosTheta * cosTheta;
  const double tan2 = std::max(1.0 - cos2, 0.0) / cos2;
  return 0.5 * (std::sqrt(1.0 + alpha * alpha * tan2) - 1.0);
}

double smithHeightCorrelated(double nDotV, double nDotL, double alpha) {
  return 1.0 / (1.0 + smithLambda(nDotV, alpha) + smithLambda(nDotL, alpha));
}

double schlickGeometry(double nDotV, double nDotL, double k) {
  return nDotV / (nDotV * (1.0 - k) + k) * (nDotL / (nDotL * (1.0 - k) + k));
}

dvec3 schlickFresnel(const dvec3& f0, double vDotH) {
  return f0 + (dvec3(1.0) - f0) * std::pow(std::clamp(1.0 - vDotH, 0.0, 1.0), 5.0);
}

double f0FromIor(double ior) { return (ior - 1.0) * (ior - 1.0) / ((ior + 1.0) * (ior + 1.0)); }

dvec3 ggxBrdf(const dvec3& f0, double alpha, const dvec3& n, const dvec3& v, const dvec3& l) {
  const double nDotV = glm::dot(n, v), nDotL = glm::dot(n, l);
  if (nDotV <= 0.0 || nDotL <= 0.0) return dvec3(0.0);
  const dvec3 h = glm::normalize(v + l);
  const double d = ggxDistribution(std::min(glm::dot(n, h), 1.0), alpha);
  const double g = smithHeightCorrelated(nDotV, nDotL, alpha);
  return schlickFresnel(f0, glm::dot(v, h)) * (d * g / (4.0 * nDotV * nDotL));
}

SplitSum integrateSplitSum(double nDotV, double alpha, const GeometryTerm& geometry, std::size_t nodes) {
  // ∫ f(v, l) n·l dω_l over half vectors h, where dω_l = 4 v·h dω_h. With tan θ_h = α s/(1 − s), D n·h dω_h is
  // 2s(1 − s)/(s² + (1 − s)²)² ds dφ/2π, so the narrowest lobe is as easy as the widest one. Light from above ends
  // where tan 2θ_h = −cot θ_v / cos φ; the inner integral stops there, so its integrand is smooth.
  const dvec3 v(std::sqrt(std::max(1.0 - nDotV * nDotV, 0.0)), 0.0, nDotV);
  const std::vector<QuadratureNode> us = gaussLegendre(nodes);
  SplitSum sum;
  for (std::size_t j = 0; j < 2 * nodes; ++j) {
    // Half a turn, the integrand being even in φ, in two halves whose points crowd where they meet: for grazing v the
    // limit turns from π/2 to 0 there.
    const QuadratureNode& t = us[j / 2];
    const double phi = 0.5 * pi * (j % 2 == 0 ? 1.0 - t.x * t.x : 1.0 + t.x * t.x);
    const double phiShare = t.weight * t.x;
    const double tanMost = std::tan(0.5 * std::atan2(v.z, -v.x * std::cos(phi)));
    const double most = tanMost / (alpha + tanMost);
    for (const QuadratureNode& node : us) {
      const double x = node.x * most, rest = 1.0 - x;
      const double tan2 = alpha * alpha * x * x / (rest * rest);
      const double density = 2.0 * x * rest / ((x * x + rest * rest) * (x * x + rest * rest));
      const double cosH = 1.0 / std::sqrt(1.0 + tan2), sinH = std::sqrt(tan2) * cosH;
      const dvec3 h(sinH * std::cos(phi), sinH * std::sin(phi), cosH);
      const double vDotH = glm::dot(v, h);
      const double nDotL = 2.0 * vDotH * h.z - v.z;
      if (vDotH <= 0.0 || nDotL <= 0.0) continue;
      const double share = density * node.weight * most * phiShare;
      const double reflected = geometry(nDotV, nDotL) * vDotH / (nDotV * cosH) * share;
      const double grazing = std::pow(1.0 - vDotH, 5.0);
      sum.scale += reflected * (1.0 - grazing);
      sum.bias += reflected * grazing;
    }
  }
  return sum;
}

namespace {
constexpr std::size_t kCurveIntervals = 160;
constexpr double kLeastNDotV = 1e-4;
}  // namespace

SplitSumCurve::SplitSumCurve(double alpha, const GeometryTerm& geometry) {
  m_points.reserve(kCurveIntervals + 1);
  for (std::size_t i = 0; i <= kCurveIntervals; ++i) {
    const double root = static_cast<double>(i) / static_cast<double>(kCurveIntervals);
    m_points.push_back(integrateSplitSum(std::max(root * root, kLeastNDotV), alpha, geometry));
  }
}

SplitSumCurve SplitSumCurve::smith(double perceptualRoughness) {
  const double alpha = perceptualRoughness * perceptualRoughness;
  return {alpha, [alpha](double v, double l) { return smithHeightCorrelated(v, l, alpha); }};
}

SplitSum SplitSumCurve::at(double nDotV) const {
  const double x = std::sqrt(std::clamp(nDotV, 0.0, 1.0)) * static_cast<double>(kCurveIntervals);
  const std::size_t i = std::min(static_cast<std::size_t>(x), kCurveIntervals - 1);
  const double t = x - static_cast<double>(i);
  const SplitSum &a = m_points[i], &b = m_points[i + 1];
  return {a.scale + t * (b.scale - a.scale), a.bias + t * (b.bias - a.bias)};
}

Layer::Layer(const dvec3& bodyF0, std::vector<Lobe> lobes, const dvec3& metalF0, double metallic)
    : m_bodyF0(bodyF0), m_metalF0(metalF0), m_metallic(metallic), m_lobes(std::move(lobes)) {
  for (const Lobe& lobe : m_lobes) m_curves.push_back(SplitSumCurve::smith(lobe.perceptualRoughness));
  for (const QuadratureNode& node : gaussLegendre(48))
    m_bodyAverage += bodyAlbedo(node.x) * (2.0 * node.x * node.weight);
}

namespace {
/// Turquin 2019: what the lobe gains where its facets reflect f0 and perfect ones would have lost 1 − mirror.
dvec3 compensation(const dvec3& f0, double mirror) { return dvec3(1.0) + f0 * (1.0 / mirror - 1.0); }
}  // namespace

dvec3 Layer::lobeAlbedoOf(const dvec3& f0, std::size_t i, double nDotV) const {
  const SplitSum single = m_curves[i].at(nDotV);
  return m_lobes[i].weight * single.albedo(f0) * compensation(f0, single.albedo(dvec3(1.0)).x);
}

dvec3 Layer::albedoOf(const dvec3& f0, double nDotV) const {
  dvec3 sum(0.0);
  for (std::size_t i = 0; i < m_lobes.size(); ++i) sum += lobeAlbedoOf(f0, i, nDotV);
  return sum;
}

dvec3 Layer::lobeAlbedo(std::size_t i, double nDotV) const {
  return glm::mix(lobeAlbedoOf(m_bodyF0, i, nDotV), lobeAlbedoOf(m_metalF0, i, nDotV), m_metallic);
}

dvec3 Layer::albedo(double nDotV) const {
  return glm::mix(albedoOf(m_bodyF0, nDotV), albedoOf(m_metalF0, nDotV), m_metallic);
}

dvec3 Layer::brdf(const dvec3& n, const dvec3& v, const dvec3& l) const {
  dvec3 sum(0.0);
  for (std::size_t i = 0; i < m_lobes.size(); ++i) {
    const double alpha = m_lobes[i].perceptualRoughness * m_lobes[i].perceptualRoughness;
    const double mirror = m_curves[i].at(std::max(glm::dot(n, v), 0.0)).albedo(dvec3(1.0)).x;
    const dvec3 body = ggxBrdf(m_bodyF0, alpha, n, v, l) * compensation(m_bodyF0, mirror);
    const dvec3 metal = ggxBrdf(m_metalF0, alpha, n, v, l) * compensation(m_metalF0, mirror);
    sum += m_lobes[i].weight * glm::mix(body, metal, m_metallic);
  }
  return sum;
}

dvec3 Layer::lampWeight(double in, double out) const {
  return imageWeight(out) * (dvec3(1.0) - bodyAlbedo(in)) / glm::max(dvec3(1.0) - m_bodyAverage, dvec3(1e-9));
}

dvec3 Layer::imageWeight(double out) const { return (1.0 - m_metallic) * (dvec3(1.0) - bodyAlbedo(out)); }

}  // namespace dermis::reference
