#include <meshoptimizer.h>

#include <array>
#include <cmath>

#include "import/mesh_math.h"

namespace dermis::import {
namespace {

/// Angle at `at` between the directions to `a` and `b`, radians.
double angleAt(const glm::dvec3& at, const glm::dvec3& a, const glm::dvec3& b) {
  const glm::dvec3 u = a - at;
  const glm::dvec3 v = b - at;
  return std::atan2(glm::length(glm::cross(u, v)), glm::dot(u, v));
}

}  // namespace

void completeNormals(RawMesh& mesh) {
  if (!mesh.normalsMissing) return;
  const std::size_t count = mesh.positions.size();

  // Corners at one point are one corner, whatever group, material or UV they have.
  std::vector<unsigned> point(count);
  const std::size_t points =
      meshopt_generateVertexRemap(point.data(), nullptr, count, mesh.positions.data(), count, sizeof(glm::vec3));
  const auto missing = [&](std::uint32_t i) { return mesh.normals[i] == glm::vec3(0.0F); };

  // Sum the normals of the faces round each point, weighted by their angle there.
  std::vector<glm::vec3> sums(points, glm::vec3(0.0F));
  std::vector<glm::vec3> own(points, glm::vec3(0.0F));  // of one of the faces, where the sum comes to nothing
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    const std::array<std::uint32_t, 3> corner = {mesh.indices[i], mesh.indices[i + 1], mesh.indices[i + 2]};
    if (!missing(corner[0]) && !missing(corner[1]) && !missing(corner[2])) continue;
    const std::array<glm::dvec3, 3> p = {mesh.positions[corner[0]], mesh.positions[corner[1]],
                                         mesh.positions[corner[2]]};
    const glm::dvec3 cross = glm::cross(p[1] - p[0], p[2] - p[0]);
    const double length = glm::length(cross);
    if (!(length > 0.0)) continue;
    const glm::dvec3 normal = cross / length;
    for (std::size_t c = 0; c < 3; ++c) {
      const double angle = angleAt(p[c], p[(c + 1) % 3], p[(c + 2) % 3]);
      sums[point[corner[c]]] += glm::vec3(normal * angle);
      own[point[corner[c]]] = glm::vec3(normal);
    }
  }
  for (std::size_t i = 0; i < points; ++i) {
    const float length = glm::length(sums[i]);
    constexpr float kCancelled = 1e-4F;  // two sheets back to back
    sums[i] = length > kCancelled ? sums[i] / length : own[i];
    if (sums[i] == glm::vec3(0.0F)) sums[i] = {0.0F, 0.0F, 1.0F};  // only faces without area: dropped later
  }
  for (std::size_t i = 0; i < count; ++i)
    if (missing(static_cast<std::uint32_t>(i))) mesh.normals[i] = sums[point[i]];
  mesh.normalsMissing = false;
}

}  // namespace dermis::import
