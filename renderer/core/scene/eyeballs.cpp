#include "core/scene/eyeballs.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <tuple>

namespace dermis {
namespace {

/// Disjoint sets of vertices.
class Pieces {
 public:
  explicit Pieces(std::size_t count) : m_parent(count) { std::iota(m_parent.begin(), m_parent.end(), 0U); }
  std::uint32_t find(std::uint32_t i) {
    while (m_parent[i] != i) i = m_parent[i] = m_parent[m_parent[i]];
    return i;
  }
  void join(std::uint32_t a, std::uint32_t b) { m_parent[find(a)] = find(b); }

 private:
  std::vector<std::uint32_t> m_parent;
};

struct Piece {
  std::vector<glm::dvec3> points;
  std::vector<glm::dvec2> uvs;
  glm::dvec3 facing{0.0};  ///< sum of the triangles' areas as vectors: zero for a closed surface
  double area = 0.0;
};

struct Sphere {
  glm::dvec3 centre{0.0};
  double radius = 0.0;
};

/// Least squares on |p|² = 2 c·p + (r² − |c|²), about the points' mean.
Sphere fitSphere(const std::vector<glm::dvec3>& points, const std::vector<double>& weights) {
  glm::dvec3 mean(0.0);
  double total = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    mean += weights[i] * points[i];
    total += weights[i];
  }
  mean /= total;
  glm::dmat3 normal(0.0);
  glm::dvec3 right(0.0);
  double meanSquare = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const glm::dvec3 p = points[i] - mean;
    normal += weights[i] * glm::outerProduct(p, p);
    right += 0.5 * weights[i] * glm::dot(p, p) * p;
    meanSquare += weights[i] * glm::dot(p, p);
  }
  const double trace = normal[0][0] + normal[1][1] + normal[2][2];
  Sphere sphere{mean, std::sqrt(meanSquare / total)};
  if (std::abs(glm::determinant(normal)) < 1e-9 * trace * trace * trace) return sphere;  // flat: no sphere
  const glm::dvec3 centre = glm::inverse(normal) * right;
  sphere.centre = mean + centre;
  sphere.radius = std::sqrt(meanSquare / total + glm::dot(centre, centre));
  return sphere;
}

/// The same without what departs from the sphere: iris and cornea.
Sphere fitRobustly(const std::vector<glm::dvec3>& points) {
  std::vector<double> weights(points.size(), 1.0);
  Sphere sphere = fitSphere(points, weights);
  // The tolerance tightens from a tenth to a hundredth of the radius: a tight one from the start can hold on to the
  // ring where a wrong sphere cuts the right one.
  for (int round = 0; round < 16; ++round) {
    const double tolerance = std::max(0.1 * std::pow(0.75, round), 0.01) * sphere.radius;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double off = (glm::length(points[i] - sphere.centre) - sphere.radius) / tolerance;
      weights[i] = 1.0 / ((1.0 + off * off) * (1.0 + off * off));
    }
    sphere = fitSphere(points, weights);
  }
  return sphere;
}

glm::dvec3 lookingAlong(const Piece& piece, const Sphere& sphere) {
  glm::dvec3 departure(0.0);
  double amount = 0.0;
  for (const glm::dvec3& p : piece.points) {
    const glm::dvec3 d = p - sphere.centre;
    const double length = glm::length(d);
    if (length <= 0.0) continue;
    const double off = std::abs(length - sphere.radius) / sphere.radius;
    if (off < 0.03) continue;
    departure += off * d / length;
    amount += off;
  }
  // A tenth of a percent of the vertices, three percent off, all to one side.
  if (amount > 3e-5 * static_cast<double>(piece.points.size()) && glm::length(departure) > 0.5 * amount)
    return glm::normalize(departure);
  // What an open surface lacks it faces away from; a fiftieth of its area is more than rounding.
  if (glm::length(piece.facing) > 0.02 * piece.area) return glm::normalize(piece.facing);
  return {0.0, 0.0, 1.0};
}

/// uv = a + G (x, y) over the front of the eye, in radii. Zero where that leaves more than a tenth unexplained.
glm::vec4 uvGradientOf(const Piece& piece, const Sphere& sphere, const Eyeball& eye) {
  constexpr double kFront = 0.45;  // of the radius: the iris
  const glm::dvec3 x(eye.x()), y(eye.y()), axis(eye.axis);
  std::vector<glm::dvec2> places, uvs;
  glm::dvec2 placeMean(0.0), uvMean(0.0);
  for (std::size_t i = 0; i < piece.points.size(); ++i) {
    const glm::dvec3 d = (piece.points[i] - sphere.centre) / sphere.radius;
    const glm::dvec2 place(glm::dot(d, x), glm::dot(d, y));
    if (glm::dot(d, axis) <= 0.0 || glm::length(place) > kFront) continue;
    places.push_back(place);
    uvs.push_back(piece.uvs[i]);
    placeMean += place;
    uvMean += piece.uvs[i];
  }
  if (places.size() < 4) return glm::vec4(0.0F);
  placeMean /= static_cast<double>(places.size());
  uvMean /= static_cast<double>(places.size());
  glm::dmat2 moments(0.0);
  glm::dvec2 u(0.0), v(0.0);
  double spread = 0.0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const glm::dvec2 p = places[i] - placeMean, t = uvs[i] - uvMean;
    moments += glm::outerProduct(p, p);
    u += t.x * p;
    v += t.y * p;
    spread += glm::dot(t, t);
  }
  if (glm::determinant(moments) <= 1e-12) return glm::vec4(0.0F);
  const glm::dmat2 inverse = glm::inverse(moments);
  u = inverse * u;
  v = inverse * v;
  double left = 0.0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const glm::dvec2 p = places[i] - placeMean, t = uvs[i] - uvMean;
    const glm::dvec2 off = t - glm::dvec2(glm::dot(u, p), glm::dot(v, p));
    left += glm::dot(off, off);
  }
  return left <= 0.1 * spread ? glm::vec4(glm::vec2(u), glm::vec2(v)) : glm::vec4(0.0F);
}

std::vector<Piece> piecesOf(const Model& model, const ModelPart& part) {
  // Vertices at one place are one, whatever their normals and coordinates.
  std::map<std::tuple<float, float, float>, std::uint32_t> places;
  std::map<std::uint32_t, std::uint32_t> placeOf;
  std::vector<std::uint32_t> vertices;
  for (std::uint32_t k = 0; k < part.indexCount; ++k) {
    const std::uint32_t v = model.indices[part.firstIndex + k];
    if (placeOf.contains(v)) continue;
    const glm::vec3& p = model.positions[v];
    const auto [at, isNew] = places.try_emplace({p.x, p.y, p.z}, static_cast<std::uint32_t>(vertices.size()));
    if (isNew) vertices.push_back(v);
    placeOf.emplace(v, at->second);
  }
  Pieces sets(vertices.size());
  for (std::uint32_t k = 0; k + 2 < part.indexCount; k += 3) {
    std::uint32_t corner[3];
    for (std::uint32_t i = 0; i < 3; ++i) corner[i] = placeOf.at(model.indices[part.firstIndex + k + i]);
    sets.join(corner[0], corner[1]);
    sets.join(corner[0], corner[2]);
  }
  std::map<std::uint32_t, Piece> found;
  for (std::uint32_t i = 0; i < vertices.size(); ++i) {
    Piece& piece = found[sets.find(i)];
    piece.points.emplace_back(model.positions[vertices[i]]);
    piece.uvs.emplace_back(model.uvs[vertices[i]]);
  }
  for (std::uint32_t k = 0; k + 2 < part.indexCount; k += 3) {
    const std::uint32_t* v = &model.indices[part.firstIndex + k];
    const glm::dvec3 from(model.positions[v[0]]);
    const glm::dvec3 area =
        0.5 * glm::cross(glm::dvec3(model.positions[v[1]]) - from, glm::dvec3(model.positions[v[2]]) - from);
    Piece& piece = found.at(sets.find(placeOf.at(v[0])));
    piece.facing += area;
    piece.area += glm::length(area);
  }
  std::vector<Piece> pieces;
  pieces.reserve(found.size());
  for (auto& [root, piece] : found) pieces.push_back(std::move(piece));
  return pieces;
}

}  // namespace

glm::vec3 Eyeball::x() const {
  const glm::vec3 up = std::abs(axis.y) > 0.99F ? glm::vec3(0.0F, 0.0F, -1.0F) : glm::vec3(0.0F, 1.0F, 0.0F);
  return glm::normalize(glm::cross(up, axis));
}

std::vector<Eyeball> findEyeballs(const Model& model, const ModelPart& part) {
  struct Found {
    Piece piece;
    Sphere sphere;
  };
  std::vector<Found> found;
  for (Piece& piece : piecesOf(model, part)) {
    if (piece.points.size() < 12) continue;
    const Sphere sphere = fitRobustly(piece.points);
    if (!(sphere.radius > 0.0) || !std::isfinite(sphere.radius)) continue;
    found.push_back({std::move(piece), sphere});
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const Found& a, const Found& b) { return a.piece.points.size() > b.piece.points.size(); });
  // Pieces of one eye, an iris of its own or a pupil, lie within it.
  std::vector<Found> eyes;
  for (Found& candidate : found) {
    glm::dvec3 mean(0.0);
    for (const glm::dvec3& p : candidate.piece.points) mean += p;
    mean /= static_cast<double>(candidate.piece.points.size());
    const auto around = std::find_if(eyes.begin(), eyes.end(), [&](const Found& eye) {
      return glm::length(mean - eye.sphere.centre) < 1.2 * eye.sphere.radius;
    });
    if (around == eyes.end()) {
      eyes.push_back(std::move(candidate));
      continue;
    }
    around->piece.facing += candidate.piece.facing;
    around->piece.area += candidate.piece.area;
    around->piece.points.insert(around->piece.points.end(), candidate.piece.points.begin(),
                                candidate.piece.points.end());
    around->piece.uvs.insert(around->piece.uvs.end(), candidate.piece.uvs.begin(), candidate.piece.uvs.end());
  }
  if (eyes.size() > kMostEyeballs) eyes.erase(eyes.begin() + kMostEyeballs, eyes.end());
  std::vector<Eyeball> result;
  for (const Found& eye : eyes) {
    Eyeball ball;
    ball.centre = glm::vec3(eye.sphere.centre);
    ball.radius = static_cast<float>(eye.sphere.radius);
    ball.axis = glm::vec3(lookingAlong(eye.piece, eye.sphere));
    ball.uvGradient = uvGradientOf(eye.piece, eye.sphere, ball);
    result.push_back(ball);
  }
  return result;
}

}  // namespace dermis
