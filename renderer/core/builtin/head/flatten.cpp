#include "core/builtin/head/flatten.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <unordered_map>

namespace dermis::sculpt {
namespace {

using Loop = std::vector<std::uint32_t>;
using SparseMatrix = Eigen::SparseMatrix<double>;

/// Boundary loops, each in the direction of its triangles; the longest first.
std::vector<Loop> boundaryLoops(const Patch& patch) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, bool> edges;
  for (const glm::uvec3& t : patch.triangles)
    for (int i = 0; i < 3; ++i) edges[{t[i], t[(i + 1) % 3]}] = true;
  std::map<std::uint32_t, std::uint32_t> next;
  for (const auto& [edge, unused] : edges)
    if (!edges.contains({edge.second, edge.first})) next[edge.first] = edge.second;
  std::vector<Loop> loops;
  while (!next.empty()) {
    Loop loop;
    for (auto at = next.begin(); at != next.end(); at = next.find(loop.back())) {
      if (loop.empty()) loop.push_back(at->first);
      loop.push_back(at->second);
      next.erase(at);
    }
    loop.pop_back();  // the first again
    loops.push_back(std::move(loop));
  }
  const auto length = [&](const Loop& loop) {
    double sum = 0.0;
    for (std::size_t i = 0; i < loop.size(); ++i)
      sum += static_cast<double>(glm::distance(patch.points[loop[i]], patch.points[loop[(i + 1) % loop.size()]]));
    return sum;
  };
  std::stable_sort(loops.begin(), loops.end(), [&](const Loop& a, const Loop& b) { return length(a) > length(b); });
  return loops;
}

/// A triangle at rest: its area as a weight, and the gradients of its corners' hat functions in its plane.
struct Element {
  glm::uvec3 corners{0};
  double weight = 0.0;
  std::array<glm::dvec2, 3> gradients{};
};

Element elementOf(const glm::uvec3& t, const std::vector<glm::dvec3>& points, double weight) {
  // mm: what is smaller, or thinner, is taken as this. Its gradients would drown all others, and single precision must
  // still tell its corners apart in the atlas.
  constexpr double kSmallest = 0.05;
  const glm::dvec3 e1 = points[t.y] - points[t.x], e2 = points[t.z] - points[t.x];
  const double base = std::max(glm::length(e1), kSmallest), along = glm::dot(e1, e2) / base;
  const double area = glm::length(glm::cross(e1, e2));
  const double height = std::max({area / base, 0.02 * std::max(base, glm::length(e2)), kSmallest});
  Element element{t, 0.5 * weight * base * height, {}};
  element.gradients[1] = {1.0 / base, -along / (base * height)};
  element.gradients[2] = {0.0, 1.0 / height};
  element.gradients[0] = -element.gradients[1] - element.gradients[2];
  return element;
}

double cross(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }

class Flattener {
 public:
  Flattener(const Patch& patch, const std::vector<Loop>& loops) {
    std::vector<glm::dvec3> points(patch.points.begin(), patch.points.end());
    for (const glm::uvec3& t : patch.triangles) m_elements.push_back(elementOf(t, points, 1.0));
    constexpr double kHoleWeight = 0.02;  // only keeps the hole open
    for (std::size_t i = 1; i < loops.size(); ++i) {
      glm::dvec3 middle(0.0);
      for (const std::uint32_t v : loops[i]) middle += points[v] / static_cast<double>(loops[i].size());
      const auto centre = static_cast<std::uint32_t>(points.size());
      points.push_back(middle);
      for (std::size_t k = 0; k < loops[i].size(); ++k)
        m_elements.push_back(
            elementOf({centre, loops[i][(k + 1) % loops[i].size()], loops[i][k]}, points, kHoleWeight));
    }
    m_flat.resize(points.size());
    embed(loops.front(), points);
    prepare();
  }
  void improve(int iterations) {
    for (int i = 0; i < iterations; ++i) step();
  }
  [[nodiscard]] const std::vector<glm::dvec2>& flat() const { return m_flat; }

 private:
  /// Tutte: the rim on a circle of the patch's area, each other vertex in the middle of its neighbours.
  void embed(const Loop& rim, const std::vector<glm::dvec3>& points) {
    double area = 0.0, around = 0.0, length = 0.0;
    for (const Element& e : m_elements) area += e.weight;
    const double radius = std::sqrt(area / std::numbers::pi);
    const auto edge = [&](std::size_t i) { return glm::distance(points[rim[i]], points[rim[(i + 1) % rim.size()]]); };
    for (std::size_t i = 0; i < rim.size(); ++i) length += edge(i);
    std::vector<bool> fixed(m_flat.size(), false);
    for (std::size_t i = 0; i < rim.size(); ++i) {
      const double angle = 2.0 * std::numbers::pi * around / length;
      m_flat[rim[i]] = radius * glm::dvec2(std::cos(angle), std::sin(angle));
      fixed[rim[i]] = true;
      around += edge(i);
    }
    // Springs that are slackened where the flat triangles are too small, round by round, let those grow (after
    // Yoshizawa, Belyaev & Seidel 2004, "A Fast and Simple Stretch-Minimizing Mesh Parameterization"); symmetric and
    // positive, they keep Tutte's promise.
    constexpr int kRounds = 10;
    std::vector<double> springs(m_elements.size(), 1.0);
    for (int round = 0; round < kRounds; ++round) {
      settle(fixed, springs);
      for (std::size_t k = 0; k < m_elements.size(); ++k) springs[k] /= std::sqrt(stretch(m_elements[k]));
    }
  }
  /// How much longer lengths are on the skin than laid flat: the root mean square.
  [[nodiscard]] double stretch(const Element& e) const {
    const glm::dmat2 j = jacobian(e, m_flat);
    const double area = std::max(std::abs(glm::determinant(j)), 1e-12);
    return std::sqrt(0.5 * (glm::dot(j[0], j[0]) + glm::dot(j[1], j[1]))) / area;
  }
  /// Vertices off the rim where the springs along the edges are at rest.
  void settle(const std::vector<bool>& fixed, const std::vector<double>& springs) {
    const auto n = static_cast<Eigen::Index>(m_flat.size());
    std::vector<Eigen::Triplet<double>> entries;
    Eigen::MatrixX2d right = Eigen::MatrixX2d::Zero(n, 2);
    for (std::size_t k = 0; k < m_elements.size(); ++k)
      for (int i = 0; i < 3; ++i)
        for (const int other : {(i + 1) % 3, (i + 2) % 3}) {
          const std::uint32_t a = m_elements[k].corners[i], b = m_elements[k].corners[other];
          if (fixed[a]) continue;
          entries.emplace_back(a, a, springs[k]);
          if (fixed[b])
            right.row(a) += springs[k] * Eigen::RowVector2d(m_flat[b].x, m_flat[b].y);
          else
            entries.emplace_back(a, b, -springs[k]);
        }
    for (std::uint32_t v = 0; v < m_flat.size(); ++v)
      if (fixed[v]) {
        entries.emplace_back(v, v, 1.0);
        right.row(v) = Eigen::RowVector2d(m_flat[v].x, m_flat[v].y);
      }
    SparseMatrix matrix(n, n);
    matrix.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SimplicialLLT<SparseMatrix> solver(matrix);
    const Eigen::MatrixX2d solved = solver.solve(right);
    for (Eigen::Index v = 0; v < n; ++v) m_flat[static_cast<std::size_t>(v)] = {solved(v, 0), solved(v, 1)};
  }

  /// The number of a vertex's x (0) or y (1) among the unknowns.
  static Eigen::Index unknown(std::uint32_t vertex, int axis) { return Eigen::Index{2} * vertex + axis; }

  /// The global matrix's pattern, and where in its values each element's blocks go.
  void prepare() {
    const auto n = static_cast<Eigen::Index>(2 * m_flat.size());
    std::vector<Eigen::Triplet<double>> entries;
    for (Eigen::Index i = 0; i < n; ++i) entries.emplace_back(i, i, 0.0);
    const auto eachEntry = [&](const auto& visit) {
      for (const Element& e : m_elements)
        for (int i = 0; i < 3; ++i)
          for (int j = 0; j < 3; ++j)
            for (int r = 0; r < 2; ++r)
              for (int c = 0; c < 2; ++c) {
                const Eigen::Index row = unknown(e.corners[i], r), column = unknown(e.corners[j], c);
                if (row >= column) visit(row, column);
              }
    };
    eachEntry([&](Eigen::Index row, Eigen::Index column) { entries.emplace_back(row, column, 0.0); });
    m_matrix.resize(n, n);
    m_matrix.setFromTriplets(entries.begin(), entries.end());
    eachEntry([&](Eigen::Index row, Eigen::Index column) {
      const int* first = m_matrix.innerIndexPtr() + m_matrix.outerIndexPtr()[column];
      const int* last = m_matrix.innerIndexPtr() + m_matrix.outerIndexPtr()[column + 1];
      m_slots.push_back(
          static_cast<int>(std::lower_bound(first, last, static_cast<int>(row)) - m_matrix.innerIndexPtr()));
    });
    m_solver.analyzePattern(m_matrix);
  }

  /// The Jacobian of the map over an element, by columns.
  [[nodiscard]] glm::dmat2 jacobian(const Element& e, const std::vector<glm::dvec2>& flat) const {
    glm::dmat2 j(0.0);
    for (int i = 0; i < 3; ++i) j += glm::outerProduct(flat[e.corners[i]], e.gradients[static_cast<std::size_t>(i)]);
    return j;
  }
  [[nodiscard]] double energy(const std::vector<glm::dvec2>& flat) const {
    double sum = 0.0;
    for (const Element& e : m_elements) {
      const glm::dmat2 j = jacobian(e, flat);
      const double square = glm::dot(j[0], j[0]) + glm::dot(j[1], j[1]), area = glm::determinant(j);
      if (area <= 0.0) return std::numeric_limits<double>::infinity();
      sum += e.weight * square * (1.0 + 1.0 / (area * area));  // ‖J‖² + ‖J⁻¹‖²
    }
    return sum;
  }

  /// One step of the scheme: each element is drawn to the nearest rotation, with the weights of eq. 8 there.
  void step() {
    const auto n = static_cast<Eigen::Index>(2 * m_flat.size());
    std::fill(m_matrix.valuePtr(), m_matrix.valuePtr() + m_matrix.nonZeros(), 0.0);
    Eigen::VectorXd right = Eigen::VectorXd::Zero(n);
    std::size_t slot = 0;
    for (const Element& e : m_elements) {
      const Proxy proxy = proxyOf(jacobian(e, m_flat));
      for (int i = 0; i < 3; ++i) {
        const glm::dvec2 gi = e.gradients[static_cast<std::size_t>(i)];
        const glm::dvec2 pull = e.weight * (proxy.weight * (proxy.rotation * gi));
        right[unknown(e.corners[i], 0)] += pull.x;
        right[unknown(e.corners[i], 1)] += pull.y;
        for (int j = 0; j < 3; ++j) {
          const double stiffness = e.weight * glm::dot(gi, e.gradients[static_cast<std::size_t>(j)]);
          for (int r = 0; r < 2; ++r)
            for (int c = 0; c < 2; ++c)
              if (unknown(e.corners[i], r) >= unknown(e.corners[j], c))
                m_matrix.valuePtr()[m_slots[slot++]] += stiffness * proxy.weight[c][r];
        }
      }
    }
    // Holds the whole in place, and the matrix positive.
    constexpr double kHold = 1e-5;
    for (Eigen::Index i = 0; i < n; ++i) {
      m_matrix.coeffRef(i, i) += kHold;
      right[i] += kHold * m_flat[static_cast<std::size_t>(i / 2)][static_cast<int>(i % 2)];
    }
    m_solver.factorize(m_matrix);
    const Eigen::VectorXd solved = m_solver.solve(right);
    std::vector<glm::dvec2> towards(m_flat.size());
    for (std::size_t v = 0; v < towards.size(); ++v)
      towards[v] = glm::dvec2(solved[static_cast<Eigen::Index>(2 * v)], solved[static_cast<Eigen::Index>(2 * v + 1)]) -
                   m_flat[v];
    walk(towards);
  }

  struct Proxy {
    glm::dmat2 rotation, weight;  ///< weight: WᵀW
  };
  static Proxy proxyOf(const glm::dmat2& j) {
    // Signed singular values of a 2×2 matrix and the angles of its rotations, in closed form.
    const double e = 0.5 * (j[0][0] + j[1][1]), f = 0.5 * (j[0][0] - j[1][1]);
    const double g = 0.5 * (j[0][1] + j[1][0]), h = 0.5 * (j[0][1] - j[1][0]);
    const double q = std::hypot(e, h), r = std::hypot(f, g);
    const double left = 0.5 * (std::atan2(g, f) + std::atan2(h, e)), turn = std::atan2(h, e);
    const auto weight = [](double s) {
      const double positive = std::max(s, 1e-8), off = positive - 1.0;
      return std::abs(off) < 1e-6 ? 4.0 : (positive - 1.0 / (positive * positive * positive)) / off;
    };
    const glm::dmat2 u(std::cos(left), std::sin(left), -std::sin(left), std::cos(left));
    const glm::dmat2 diagonal(weight(q + r), 0.0, 0.0, weight(q - r));
    return {glm::dmat2(std::cos(turn), std::sin(turn), -std::sin(turn), std::cos(turn)),
            u * diagonal * glm::transpose(u)};
  }

  /// As far along as no triangle turns over and the energy falls.
  void walk(const std::vector<glm::dvec2>& towards) {
    double length = 1.0;
    for (const Element& e : m_elements) length = std::min(length, 0.8 * lengthBeforeTurning(e, towards));
    const double before = energy(m_flat);
    for (int attempt = 0; attempt < 30; ++attempt, length *= 0.5) {
      std::vector<glm::dvec2> moved(m_flat.size());
      for (std::size_t v = 0; v < moved.size(); ++v) moved[v] = m_flat[v] + length * towards[v];
      if (energy(moved) < before) {
        m_flat = std::move(moved);
        return;
      }
    }
  }
  [[nodiscard]] double lengthBeforeTurning(const Element& e, const std::vector<glm::dvec2>& towards) const {
    // The area is a quadratic of the length: its first positive root.
    const glm::dvec2 a = m_flat[e.corners.y] - m_flat[e.corners.x], b = m_flat[e.corners.z] - m_flat[e.corners.x];
    const glm::dvec2 da = towards[e.corners.y] - towards[e.corners.x], db = towards[e.corners.z] - towards[e.corners.x];
    const double c2 = cross(da, db), c1 = cross(a, db) + cross(da, b), c0 = cross(a, b);
    constexpr double kNever = 1e9;
    if (std::abs(c2) < 1e-14) return c1 < 0.0 ? -c0 / c1 : kNever;
    const double discriminant = c1 * c1 - 4.0 * c2 * c0;
    if (discriminant < 0.0) return kNever;
    const double q = -0.5 * (c1 + std::copysign(std::sqrt(discriminant), c1));
    double first = kNever;
    for (const double root : {q / c2, q != 0.0 ? c0 / q : kNever})
      if (root > 0.0) first = std::min(first, root);
    return first;
  }

  std::vector<Element> m_elements;
  std::vector<glm::dvec2> m_flat;
  SparseMatrix m_matrix;
  std::vector<int> m_slots;
  Eigen::SimplicialLLT<SparseMatrix> m_solver;
};

bool isDisc(const Patch& patch, const std::vector<Loop>& loops) {
  std::size_t edges = patch.triangles.size() * 3;  // inner edges twice, boundary edges once
  for (const Loop& loop : loops) edges += loop.size();
  const auto euler = static_cast<long>(patch.points.size() + patch.triangles.size()) - static_cast<long>(edges / 2);
  return !loops.empty() && euler + static_cast<long>(loops.size()) == 2;
}

}  // namespace

std::vector<glm::dvec2> flatten(const Patch& patch, int iterations) {
  const std::vector<Loop> loops = boundaryLoops(patch);
  if (!isDisc(patch, loops)) return {};
  Flattener flattener(patch, loops);
  flattener.improve(iterations);
  std::vector<glm::dvec2> flat = flattener.flat();
  flat.resize(patch.points.size());
  return flat;
}

}  // namespace dermis::sculpt
