// LDR-FLIP. Andersson, Nilsson, Akenine-Möller, Oskarsson, Åström, Fairchild: "FLIP: A Difference Evaluator for
// Alternating Images", Proc. ACM Comput. Graph. Interact. Tech. 3(2), 2020. Section numbers below are the paper's.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/glm.hpp>
#include <numbers>

#include "core/image/comparison.h"

namespace dermis {
namespace {

/// 0.7 m from a 0.7 m wide screen of 3840 pixels, the paper's default.
constexpr double kPixelsPerDegree = 67.0206;

using Plane = std::vector<float>;
using Kernel = std::vector<double>;  ///< odd length, middle at size/2
struct Planes {
  std::array<Plane, 3> c;
};

struct Extent {
  int width, height;
  [[nodiscard]] std::size_t count() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(height); }
};

/// Linear Rec.709 to XYZ (D65), and back.
glm::dmat3 xyzFromRgb() {
  return glm::transpose(glm::dmat3(0.4123865632529916, 0.35759149092062537, 0.18045049120356368,  //
                                   0.21263682167732384, 0.7151829818412507, 0.07218019648142547,  //
                                   0.019330620152483987, 0.11919716364020845, 0.9503725870054354));
}
const glm::dmat3 kXyzFromRgb = xyzFromRgb();
const glm::dmat3 kRgbFromXyz = glm::inverse(kXyzFromRgb);
const glm::dvec3 kWhite = kXyzFromRgb * glm::dvec3(1.0);

double fromSrgb(double v) { return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4); }

/// Section 4.1: the linear opponent space YCxCz.
glm::dvec3 opponentFromRgb(const glm::dvec3& rgb) {
  const glm::dvec3 n = kXyzFromRgb * rgb / kWhite;
  return {116.0 * n.y - 16.0, 500.0 * (n.x - n.y), 200.0 * (n.y - n.z)};
}
glm::dvec3 rgbFromOpponent(const glm::dvec3& o) {
  const double y = (o.x + 16.0) / 116.0;
  return kRgbFromXyz * (glm::dvec3(y + o.y / 500.0, y, y - o.z / 200.0) * kWhite);
}

/// CIELAB with the Hunt adjustment of its chroma (section 4.1.2).
glm::dvec3 huntLabFromRgb(const glm::dvec3& rgb) {
  const glm::dvec3 n = kXyzFromRgb * rgb / kWhite;
  const auto f = [](double t) {
    constexpr double kDelta = 6.0 / 29.0;
    return t > kDelta * kDelta * kDelta ? std::cbrt(t) : t / (3.0 * kDelta * kDelta) + 4.0 / 29.0;
  };
  const double l = 116.0 * f(n.y) - 16.0;
  return {l, 0.01 * l * 500.0 * (f(n.x) - f(n.y)), 0.01 * l * 200.0 * (f(n.y) - f(n.z))};
}

/// The HyAB distance (section 4.1.3).
double hyab(const glm::dvec3& a, const glm::dvec3& b) { return std::abs(a.x - b.x) + std::hypot(a.y - b.y, a.z - b.z); }

/// One-dimensional convolution along rows or columns; the border repeats.
Plane convolved(const Plane& in, const Extent& e, const Kernel& kernel, bool alongRows) {
  Plane out(e.count());
  const int radius = static_cast<int>(kernel.size() / 2);
  const int length = alongRows ? e.width : e.height;
  const auto step = static_cast<std::size_t>(alongRows ? 1 : e.width);
  for (int y = 0; y < e.height; ++y)
    for (int x = 0; x < e.width; ++x) {
      const std::size_t at =
          static_cast<std::size_t>(y) * static_cast<std::size_t>(e.width) + static_cast<std::size_t>(x);
      const int position = alongRows ? x : y;
      const std::size_t first = at - static_cast<std::size_t>(position) * step;
      double sum = 0.0;
      for (int k = -radius; k <= radius; ++k) {
        const auto from = static_cast<std::size_t>(std::clamp(position + k, 0, length - 1));
        const int tap = k + radius;
        sum += kernel[static_cast<std::size_t>(tap)] * static_cast<double>(in[first + from * step]);
      }
      out[at] = static_cast<float>(sum);
    }
  return out;
}

/// One term of a contrast sensitivity function: a·sqrt(π/b)·exp(−π²x²/b), x in degrees (section 4.1.1).
struct SensitivityTerm {
  double a, b;
};
constexpr std::array<std::array<SensitivityTerm, 2>, 3> kSensitivity = {{
    {{{1.0, 0.0047}, {0.0, 1e-5}}},
    {{{1.0, 0.0053}, {0.0, 1e-5}}},
    {{{34.1, 0.04}, {13.5, 0.025}}},
}};

/// Blurs each opponent channel as an eye would, by the Gaussians of its sensitivity: each term is separable.
Plane seen(const Plane& channel, const Extent& e, const std::array<SensitivityTerm, 2>& terms) {
  const double pi2 = std::numbers::pi * std::numbers::pi;
  const int radius = static_cast<int>(std::ceil(3.0 * std::sqrt(0.04 / (2.0 * pi2)) * kPixelsPerDegree));
  Plane sum(e.count(), 0.0F);
  double total = 0.0;
  std::array<Kernel, 2> kernels;
  std::array<double, 2> weights{};
  for (std::size_t t = 0; t < 2; ++t) {
    double line = 0.0;
    for (int k = -radius; k <= radius; ++k) {
      const double x = k / kPixelsPerDegree;
      kernels.at(t).push_back(std::exp(-pi2 * x * x / terms.at(t).b));
      line += kernels.at(t).back();
    }
    weights.at(t) = terms.at(t).a * std::sqrt(std::numbers::pi / terms.at(t).b);
    total += weights.at(t) * line * line;
  }
  for (std::size_t t = 0; t < 2; ++t) {
    if (weights.at(t) == 0.0) continue;
    const Plane blurred = convolved(convolved(channel, e, kernels.at(t), true), e, kernels.at(t), false);
    const auto weight = static_cast<float>(weights.at(t) / total);
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += weight * blurred[i];
  }
  return sum;
}

struct Features {
  Plane edges, points;
};

/// Magnitudes of the first and second derivative of the luminance, at the width of a line (section 4.2).
Features features(const Plane& opponentY, const Extent& e) {
  Plane y(opponentY.size());
  for (std::size_t i = 0; i < y.size(); ++i) y[i] = (opponentY[i] + 16.0F) / 116.0F;
  const double sigma = 0.5 * 0.082 * kPixelsPerDegree;
  const int radius = static_cast<int>(std::ceil(3.0 * sigma));
  Kernel gauss, edge, point;
  for (int k = -radius; k <= radius; ++k) {
    const double g = std::exp(-k * k / (2.0 * sigma * sigma));
    gauss.push_back(g);
    edge.push_back(-k * g);
    point.push_back((k * k / (sigma * sigma) - 1.0) * g);
  }
  // Positive weights sum to 1 and negative ones to −1.
  const auto balance = [](Kernel& kernel) {
    double positive = 0.0, negative = 0.0;
    for (const double w : kernel) (w > 0.0 ? positive : negative) += w;
    for (double& w : kernel) w /= w > 0.0 ? positive : -negative;
  };
  balance(gauss);
  balance(edge);
  balance(point);
  const auto magnitude = [&](const Kernel& kernel) {
    const Plane dx = convolved(convolved(y, e, kernel, true), e, gauss, false);
    const Plane dy = convolved(convolved(y, e, gauss, true), e, kernel, false);
    Plane m(dx.size());
    for (std::size_t i = 0; i < m.size(); ++i) m[i] = std::hypot(dx[i], dy[i]);
    return m;
  };
  return {magnitude(edge), magnitude(point)};
}

Planes opponentPlanes(const Plane (&coded)[3], const Extent& e) {
  Planes planes;
  for (Plane& p : planes.c) p.resize(e.count());
  for (std::size_t i = 0; i < e.count(); ++i) {
    glm::dvec3 rgb;
    for (int c = 0; c < 3; ++c) rgb[c] = fromSrgb(std::clamp(static_cast<double>(coded[c][i]), 0.0, 1.0));
    const glm::dvec3 o = opponentFromRgb(rgb);
    for (int c = 0; c < 3; ++c) planes.c.at(static_cast<std::size_t>(c))[i] = static_cast<float>(o[c]);
  }
  return planes;
}

}  // namespace

std::vector<float> flipMap(const std::vector<float> (&a)[3], const std::vector<float> (&b)[3], int width, int height) {
  const Extent e{width, height};
  const Planes oa = opponentPlanes(a, e);
  const Planes ob = opponentPlanes(b, e);
  Planes sa, sb;
  for (std::size_t c = 0; c < 3; ++c) {
    sa.c.at(c) = seen(oa.c.at(c), e, kSensitivity.at(c));
    sb.c.at(c) = seen(ob.c.at(c), e, kSensitivity.at(c));
  }
  const Features fa = features(oa.c[0], e);
  const Features fb = features(ob.c[0], e);

  // The largest colour difference of the gamut, green to blue, anchors the scale (section 4.1.3).
  constexpr double kColourExponent = 0.7, kBend = 0.4, kBendValue = 0.95;
  const double largest = std::pow(hyab(huntLabFromRgb({0, 1, 0}), huntLabFromRgb({0, 0, 1})), kColourExponent);
  const auto lab = [](const Planes& p, std::size_t i) {
    const glm::dvec3 rgb = rgbFromOpponent({p.c[0][i], p.c[1][i], p.c[2][i]});
    return huntLabFromRgb(glm::clamp(rgb, 0.0, 1.0));
  };
  std::vector<float> map(e.count());
  for (std::size_t i = 0; i < map.size(); ++i) {
    const double distance = std::pow(hyab(lab(sa, i), lab(sb, i)), kColourExponent);
    const double bend = kBend * largest;
    const double colour = distance < bend ? kBendValue / bend * distance
                                          : kBendValue + (distance - bend) / (largest - bend) * (1.0 - kBendValue);
    const double edge = std::abs(static_cast<double>(fa.edges[i]) - static_cast<double>(fb.edges[i]));
    const double point = std::abs(static_cast<double>(fa.points[i]) - static_cast<double>(fb.points[i]));
    const double feature = std::sqrt(std::clamp(std::max(edge, point) / std::numbers::sqrt2, 0.0, 1.0));
    // Section 4.3: features make a colour difference count more.
    map[i] = static_cast<float>(std::pow(std::clamp(colour, 0.0, 1.0), 1.0 - feature));
  }
  return map;
}

}  // namespace dermis
