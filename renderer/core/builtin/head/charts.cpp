#include "core/builtin/head/charts.h"

#include <array>
#include <cmath>
#include <map>
#include <numeric>

#include "core/bake/parallel.h"
#include "core/builtin/head/chart_labels.h"
#include "core/builtin/head/flatten.h"
#include "core/builtin/head/pack.h"

namespace dermis::sculpt {
namespace {

/// Corners (triangle · 3 + i) that are one vertex.
class Corners {
 public:
  explicit Corners(std::size_t count) : m_parent(count) { std::iota(m_parent.begin(), m_parent.end(), 0U); }
  std::uint32_t find(std::uint32_t i) {
    while (m_parent[i] != i) i = m_parent[i] = m_parent[m_parent[i]];
    return i;
  }
  void join(std::uint32_t a, std::uint32_t b) {
    const std::uint32_t ra = find(a), rb = find(b);
    m_parent[std::max(ra, rb)] = std::min(ra, rb);
  }

 private:
  std::vector<std::uint32_t> m_parent;
};

/// Vertices are corners that inner edges join; at chart borders and the seam each side has its own.
void cut(const Surface& surface, const std::vector<Chart>& charts, const EdgeSet& seam, AtlasMesh& mesh) {
  Corners corners(surface.triangles.size() * 3);
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> open;  // directed edge to its first corner
  for (std::uint32_t t = 0; t < surface.triangles.size(); ++t)
    for (std::uint32_t i = 0; i < 3; ++i) {
      const std::uint32_t a = surface.triangles[t][static_cast<int>(i)];
      const std::uint32_t b = surface.triangles[t][static_cast<int>((i + 1) % 3)];
      const std::uint32_t first = 3 * t + i, second = 3 * t + (i + 1) % 3;
      const auto other = open.find({b, a});
      if (other == open.end()) {
        open[{a, b}] = first;
        continue;
      }
      const std::uint32_t theirs = other->second, theirTriangle = theirs / 3;
      if (charts[theirTriangle] != charts[t] || seam.contains(std::minmax(a, b))) continue;
      corners.join(second, theirs);
      corners.join(first, 3 * theirTriangle + (theirs + 1) % 3);
    }
  std::vector<std::uint32_t> number(surface.triangles.size() * 3, 0);
  for (std::uint32_t t = 0; t < surface.triangles.size(); ++t) {
    glm::uvec3 triangle(0);
    for (std::uint32_t i = 0; i < 3; ++i) {
      const std::uint32_t corner = 3 * t + i, root = corners.find(corner);
      if (root == corner) {
        number[corner] = static_cast<std::uint32_t>(mesh.pointOf.size());
        mesh.pointOf.push_back(surface.triangles[t][static_cast<int>(i)]);
      }
      triangle[static_cast<int>(i)] = number[root];
    }
    mesh.triangles.push_back(triangle);
  }
}

struct Piece {
  Patch patch;
  std::vector<std::uint32_t> vertices;  ///< of the mesh, of each of the patch
  std::vector<glm::dvec2> flat;
};

std::array<Piece, kChartCount> piecesOf(const AtlasMesh& mesh) {
  std::array<Piece, kChartCount> pieces;
  std::vector<std::uint32_t> local(mesh.pointOf.size(), 0xFFFFFFFFU);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    Piece& piece = pieces[static_cast<std::size_t>(mesh.charts[t])];
    glm::uvec3 triangle(0);
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t v = mesh.triangles[t][i];
      if (local[v] == 0xFFFFFFFFU) {
        local[v] = static_cast<std::uint32_t>(piece.vertices.size());
        piece.vertices.push_back(v);
        piece.patch.points.push_back(mesh.points[mesh.pointOf[v]]);
      }
      triangle[i] = local[v];
    }
    piece.patch.triangles.push_back(triangle);
  }
  return pieces;
}

/// Turns a flat piece so that up (y) on the skin is up in it, as well as one turn can.
void turnUpright(Piece& piece) {
  glm::dvec2 up(0.0);
  for (const glm::uvec3& t : piece.patch.triangles) {
    const glm::dvec2 a = piece.flat[t.y] - piece.flat[t.x], b = piece.flat[t.z] - piece.flat[t.x];
    const auto ya = static_cast<double>(piece.patch.points[t.y].y - piece.patch.points[t.x].y);
    const auto yb = static_cast<double>(piece.patch.points[t.z].y - piece.patch.points[t.x].y);
    // The gradient of y over the flat triangle, times twice its area.
    up += glm::dvec2(ya * b.y - yb * a.y, yb * a.x - ya * b.x);
  }
  const double length = glm::length(up);
  if (length < 1e-9) return;
  up /= length;
  for (glm::dvec2& p : piece.flat) p = {p.x * up.y - p.y * up.x, p.x * up.x + p.y * up.y};
}

/// What is left when a piece can't be flattened: seen along its mean normal. Parts that face away lie on top of others:
/// maps repeat there, but there is a head.
std::vector<glm::dvec2> projected(const Patch& patch) {
  glm::vec3 normal(0.0F);
  for (const glm::uvec3& t : patch.triangles)
    normal += glm::cross(patch.points[t.y] - patch.points[t.x], patch.points[t.z] - patch.points[t.x]);
  normal = glm::length(normal) > 0.0F ? glm::normalize(normal) : glm::vec3(0, 0, 1);
  const glm::vec3 across =
      glm::normalize(glm::cross(std::abs(normal.y) < 0.9F ? glm::vec3(0, 1, 0) : glm::vec3(0, 0, 1), normal));
  const glm::vec3 up = glm::cross(normal, across);
  std::vector<glm::dvec2> flat;
  for (const glm::vec3& p : patch.points) flat.emplace_back(glm::dot(p, across), glm::dot(p, up));
  return flat;
}

}  // namespace

float chartScale(Chart chart) {
  switch (chart) {
    case Chart::Base:
      return 0.35F;
    case Chart::SocketFrontL:
    case Chart::SocketFrontR:
    case Chart::SocketBackL:
    case Chart::SocketBackR:
      return 0.4F;
    default:
      return 1.0F;
  }
}

AtlasMesh unwrap(const Surface& surface, const Sculpt& sculpt) {
  AtlasMesh mesh;
  mesh.points = surface.points;
  mesh.charts = labelCharts(surface, sculpt);
  cut(surface, mesh.charts, backSeam(surface, mesh.charts), mesh);
  std::array<Piece, kChartCount> pieces = piecesOf(mesh);
  constexpr int kIterations = 20;
  forPieces(
      pieces.size(), 1, {}, [&](std::size_t i, std::size_t) { pieces[i].flat = flatten(pieces[i].patch, kIterations); },
      [](float) {});
  std::vector<FlatPiece> flats;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    Piece& piece = pieces[i];
    if (piece.flat.empty()) piece.flat = projected(piece.patch);
    turnUpright(piece);
    const float scale = chartScale(static_cast<Chart>(i));
    FlatPiece flat{{}, piece.patch.triangles};
    for (const glm::dvec2& p : piece.flat) flat.points.push_back(scale * glm::vec2(p));
    flats.push_back(std::move(flat));
  }
  const Packing packing = pack(flats);
  mesh.millimetresPerUv = 1.0F / packing.uvPerMillimetre;
  mesh.uvs.resize(mesh.pointOf.size());
  for (std::size_t i = 0; i < pieces.size(); ++i)
    for (std::size_t v = 0; v < pieces[i].vertices.size(); ++v)
      mesh.uvs[pieces[i].vertices[v]] = flats[i].points[v] * packing.uvPerMillimetre + packing.offsets[i];
  return mesh;
}

}  // namespace dermis::sculpt
