#include "lighting/dfg_quadrature.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>
#include <numbers>
#include <vector>

namespace dermis {
namespace {

struct Rule {
  std::vector<double> x, w;  // on 0..1
};

/// Gauss-Legendre points by Newton's method on the Legendre polynomial.
const Rule& gaussLegendre(int n) {
  static std::mutex mutex;
  static std::map<int, Rule> rules;
  const std::lock_guard lock(mutex);
  Rule& rule = rules[n];
  if (!rule.x.empty()) return rule;
  for (int i = 0; i < n; ++i) {
    double x = std::cos(std::numbers::pi * (i + 0.75) / (n + 0.5));
    double slope = 1.0;
    for (int iteration = 0; iteration < 60; ++iteration) {
      double p0 = 1.0;
      double p1 = x;
      for (int k = 2; k <= n; ++k) {
        const double p2 = ((2 * k - 1) * x * p1 - (k - 1) * p0) / k;
        p0 = p1;
        p1 = p2;
      }
      slope = n * (x * p1 - p0) / (x * x - 1.0);
      const double step = p1 / slope;
      x -= step;
      if (std::abs(step) < 1e-15) break;
    }
    rule.x.push_back(0.5 * (1.0 - x));
    rule.w.push_back(1.0 / ((1.0 - x * x) * slope * slope));
  }
  return rule;
}

double pow5(double x) { return x * x * x * x * x; }

}  // namespace

DfgValue dfgQuadrature(DfgGeometry geometry, double cosine, double perceptualRoughness, int points) {
  const double mirror = pow5(1.0 - cosine);
  if (perceptualRoughness <= 0.0) return {1.0 - mirror, mirror};
  const double alpha = perceptualRoughness * perceptualRoughness;
  const double alpha2 = alpha * alpha;
  const double k = perceptualRoughness * perceptualRoughness / 2.0;
  const double sine = std::sqrt(1.0 - cosine * cosine);

  // Visible normals (Heitz 2018, "Sampling the GGX Distribution of Visible Normals"): v stretched to the hemisphere
  // configuration, the projected disc warped, and the normal unstretched. In those two numbers the integrand is the
  // ratio of the shadowing terms, smooth and bounded also where n·v or alpha goes to 0.
  const double length = std::sqrt(alpha2 * sine * sine + cosine * cosine);
  const double stretchedX = alpha * sine / length;
  const double stretchedZ = cosine / length;

  // G1(v) / (n·v) of the Smith term that the visible normals carry: 2 / (n·v + sqrt(alpha² + (1 − alpha²) (n·v)²)).
  const double rootV = std::sqrt(alpha2 + (1.0 - alpha2) * cosine * cosine);
  const Rule& rule = gaussLegendre(points);
  double scale = 0.0;
  double bias = 0.0;
  for (std::size_t i = 0; i < rule.x.size(); ++i) {
    // The disc in polar coordinates, r = sqrt(u): substituted so that the rim is approached smoothly.
    const double u = rule.x[i];
    const double r = std::sin(0.5 * std::numbers::pi * u);
    const double rWeight = rule.w[i] * 2.0 * r * std::cos(0.5 * std::numbers::pi * u) * 0.5 * std::numbers::pi;
    for (std::size_t j = 0; j < rule.x.size(); ++j) {
      const double phi = std::numbers::pi * rule.x[j];  // both halves are mirror images
      const double t1 = r * std::cos(phi);              // across v
      const double t2Disc = r * std::sin(phi);
      for (const double sign : {1.0, -1.0}) {
        const double s = 0.5 * (1.0 + stretchedZ);
        const double t2 = (1.0 - s) * std::sqrt(std::max(0.0, 1.0 - t1 * t1)) + s * sign * t2Disc;
        const double t3 = std::sqrt(std::max(0.0, 1.0 - t1 * t1 - t2 * t2));
        // Basis: across = y axis, up = v × across, in the plane of v and n.
        const double hx = -stretchedZ * t2 + stretchedX * t3;
        const double hy = t1;
        const double hz = stretchedX * t2 + stretchedZ * t3;
        double nx = alpha * hx;
        const double ny = alpha * hy;
        double nz = std::max(0.0, hz);
        const double inverse = 1.0 / std::sqrt(nx * nx + ny * ny + nz * nz);
        nx *= inverse, nz *= inverse;
        const double vh = std::max(0.0, sine * nx + cosine * nz);
        const double nl = 2.0 * vh * nz - cosine;
        if (nl <= 0.0) continue;
        double ratio = 0.0;
        if (geometry == DfgGeometry::Smith) {
          // G2 / G1(v): with lambda-form V = 0.5 / (nl·rootV + nv·rootL) (Heitz 2014, equation 99).
          const double rootL = std::sqrt(alpha2 + (1.0 - alpha2) * nl * nl);
          ratio = nl * (cosine + rootV) / (nl * rootV + cosine * rootL);
        } else {
          const double gv = 1.0 / (cosine * (1.0 - k) + k);  // G1(v) / (n·v)
          const double gl = nl / (nl * (1.0 - k) + k);
          ratio = gv * gl * 0.5 * (cosine + rootV);
        }
        const double weight = rWeight * rule.w[j] * 0.5 * ratio;
        const double fresnel = pow5(1.0 - vh);
        scale += weight * (1.0 - fresnel);
        bias += weight * fresnel;
      }
    }
  }
  return {scale, bias};
}

}  // namespace dermis
