// Gauss-Legendre nodes, for the integrals of the reference evaluations.
#pragma once

#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace dermis::reference {

struct QuadratureNode {
  double x = 0.0;       ///< in 0..1
  double weight = 0.0;  ///< they sum to 1
};

/// The n nodes of Gauss-Legendre on 0..1: exact for polynomials up to degree 2n − 1 (Newton's method on the Legendre
/// polynomial).
inline std::vector<QuadratureNode> gaussLegendre(std::size_t n) {
  std::vector<QuadratureNode> nodes(n);
  const auto count = static_cast<double>(n);
  for (std::size_t i = 0; i < n; ++i) {
    double x = std::cos(std::numbers::pi * (static_cast<double>(i) + 0.75) / (count + 0.5));
    double slope = 1.0;
    for (int iteration = 0; iteration < 60; ++iteration) {
      double last = 0.0, value = 1.0;
      for (std::size_t j = 0; j < n; ++j) {
        const auto k = static_cast<double>(j);
        const double next = ((2.0 * k + 1.0) * x * value - k * last) / (k + 1.0);
        last = value;
        value = next;
      }
      slope = count * (x * value - last) / (x * x - 1.0);
      const double step = value / slope;
      x -= step;
      if (std::abs(step) < 1e-15) break;
    }
    nodes[i] = {0.5 * (1.0 + x), 1.0 / ((1.0 - x * x) * slope * slope)};
  }
  return nodes;
}

}  // namespace dermis::reference
