#include <meshoptimizer.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <span>
#include <utility>

#include "import/mesh_math.h"

namespace dermis::import {
namespace {

/// Faces at one point that are turned by more against each other meet in an edge that is meant to be seen.
const double kCosineOfCrease = std::cos(80.0 * 3.14159265358979323846 / 180.0);

/// Angle at `at` between the directions to `a` and `b`, radians.
double angleAt(const glm::dvec3& at, const glm::dvec3& a, const glm::dvec3& b) {
  const glm::dvec3 u = a - at;
  const glm::dvec3 v = b - at;
  return std::atan2(glm::length(glm::cross(u, v)), glm::dot(u, v));
}

/// A triangle's corner: its place in RawMesh::indices, its face's unit normal, zero where it has no area, and the angle
/// there.
struct Corner {
  std::uint32_t index = 0;
  glm::vec3 normal{0.0F};
  float angle = 0.0F;
};

/// The corners whose normals are missing and those round them, sorted by the point they lie at; of point i from
/// first[i] to first[i + 1]. Corners at one point lie there together, whatever group, material or UV they have.
struct CornersByPoint {
  std::vector<Corner> corners;
  std::vector<std::uint32_t> first;
};

CornersByPoint cornersByPoint(const RawMesh& mesh, std::span<const std::uint8_t> missing) {
  const std::size_t count = mesh.positions.size();
  std::vector<unsigned> point(count);
  const std::size_t points =
      meshopt_generateVertexRemap(point.data(), nullptr, count, mesh.positions.data(), count, sizeof(glm::vec3));
  const auto needed = [&](std::size_t i) {
    return missing[mesh.indices[i]] != 0 || missing[mesh.indices[i + 1]] != 0 || missing[mesh.indices[i + 2]] != 0;
  };
  CornersByPoint sorted;
  sorted.first.assign(points + 1, 0);
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3)
    for (std::size_t c = 0; needed(i) && c < 3; ++c) ++sorted.first[point[mesh.indices[i + c]] + 1];
  std::partial_sum(sorted.first.begin(), sorted.first.end(), sorted.first.begin());
  sorted.corners.resize(sorted.first.back());
  std::vector<std::uint32_t> next(sorted.first.begin(), sorted.first.end() - 1);
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    if (!needed(i)) continue;
    std::array<glm::dvec3, 3> p;
    for (std::size_t c = 0; c < 3; ++c) p[c] = mesh.positions[mesh.indices[i + c]];
    const glm::dvec3 cross = glm::cross(p[1] - p[0], p[2] - p[0]);
    const double length = glm::length(cross);
    for (std::size_t c = 0; c < 3; ++c) {
      Corner& corner = sorted.corners[next[point[mesh.indices[i + c]]]++];
      corner.index = static_cast<std::uint32_t>(i + c);
      if (!(length > 0.0)) continue;
      corner.normal = cross / length;
      corner.angle = static_cast<float>(angleAt(p[c], p[(c + 1) % 3], p[(c + 2) % 3]));
    }
  }
  return sorted;
}

/// Numbers the smooth parts at one point: corners are of one part where a chain of corners leads from one to the other
/// without a crease.
void numberParts(std::span<const Corner> corners, std::vector<std::uint32_t>& parts) {
  parts.assign(corners.size(), 0);
  // A fan of thousands of triangles has no creases worth a comparison of all with all.
  constexpr std::size_t kMostCompared = 512;
  if (corners.size() > kMostCompared) return;
  std::iota(parts.begin(), parts.end(), 0U);
  for (std::size_t a = 1; a < corners.size(); ++a)
    for (std::size_t b = 0; b < a; ++b) {
      if (parts[a] == parts[b] || glm::dot(corners[a].normal, corners[b].normal) < kCosineOfCrease) continue;
      const std::uint32_t from = std::max(parts[a], parts[b]), to = std::min(parts[a], parts[b]);
      std::replace(parts.begin(), parts.begin() + static_cast<std::ptrdiff_t>(a) + 1, from, to);
    }
}

/// The normal of every corner that was sorted; zeros for the others.
std::vector<glm::vec3> cornerNormals(const RawMesh& mesh, const CornersByPoint& sorted) {
  std::vector<glm::vec3> normals(mesh.indices.size(), glm::vec3(0.0F));
  std::vector<std::uint32_t> parts;
  for (std::size_t i = 0; i + 1 < sorted.first.size(); ++i) {
    const std::span<const Corner> corners(sorted.corners.data() + sorted.first[i],
                                          sorted.first[i + 1] - sorted.first[i]);
    numberParts(corners, parts);
    for (std::size_t a = 0; a < corners.size(); ++a) {
      if (normals[corners[a].index] != glm::vec3(0.0F)) continue;
      glm::vec3 sum(0.0F);
      for (std::size_t b = a; b < corners.size(); ++b)
        if (parts[b] == parts[a]) sum += corners[b].normal * corners[b].angle;
      const float length = glm::length(sum);
      constexpr float kCancelled = 1e-4F;  // two sheets back to back
      glm::vec3 normal = length > kCancelled ? sum / length : corners[a].normal;
      if (normal == glm::vec3(0.0F)) normal = {0.0F, 0.0F, 1.0F};  // only faces without area: dropped later
      for (std::size_t b = a; b < corners.size(); ++b)
        if (parts[b] == parts[a]) normals[corners[b].index] = normal;
    }
  }
  return normals;
}

/// One vertex a corner.
void separateCorners(RawMesh& mesh) {
  const auto separate = [&](auto& stream) {
    std::remove_reference_t<decltype(stream)> spread;
    spread.reserve(mesh.indices.size());
    for (const std::uint32_t i : mesh.indices) spread.push_back(stream[i]);
    stream = std::move(spread);
  };
  separate(mesh.positions);
  separate(mesh.normals);
  separate(mesh.uvs);
  if (!mesh.tangents.empty()) separate(mesh.tangents);
  std::iota(mesh.indices.begin(), mesh.indices.end(), 0U);
  for (RawMesh::Run& run : mesh.runs) {
    run.firstVertex = run.firstIndex;
    run.vertexCount = run.indexCount;
  }
}

}  // namespace

bool completeNormals(RawMesh& mesh) {
  if (!std::exchange(mesh.normalsMissing, false)) return false;
  std::vector<std::uint8_t> missing(mesh.positions.size());
  std::transform(mesh.normals.begin(), mesh.normals.end(), missing.begin(),
                 [](const glm::vec3& n) { return n == glm::vec3(0.0F) ? 1 : 0; });
  const std::vector<glm::vec3> normals = cornerNormals(mesh, cornersByPoint(mesh, missing));

  // A vertex keeps its place where all its corners agree, as they do away from creases.
  bool creased = false;
  for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
    const std::uint32_t vertex = mesh.indices[i];
    if (missing[vertex] == 0) continue;
    glm::vec3& normal = mesh.normals[vertex];
    if (normal == glm::vec3(0.0F)) normal = normals[i];
    creased = creased || normal != normals[i];
  }
  for (glm::vec3& normal : mesh.normals)
    if (normal == glm::vec3(0.0F)) normal = {0.0F, 0.0F, 1.0F};  // of no triangle
  if (!creased) return false;
  std::vector<std::uint8_t> filled(mesh.indices.size());
  for (std::size_t i = 0; i < filled.size(); ++i) filled[i] = missing[mesh.indices[i]];
  separateCorners(mesh);
  for (std::size_t i = 0; i < filled.size(); ++i)
    if (filled[i] != 0) mesh.normals[i] = normals[i];
  return true;
}

}  // namespace dermis::import
