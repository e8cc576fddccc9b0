#include <meshoptimizer.h>

#include <algorithm>

#include "import/mesh_math.h"

namespace dermis::import {
namespace {

/// Collinear to the precision of 32-bit coordinates, or two corners at one point.
bool hasArea(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  const glm::dvec3 u = b - a;
  const glm::dvec3 v = c - a;
  const double uu = glm::dot(u, u);
  const double vv = glm::dot(v, v);
  const glm::dvec3 cross = glm::cross(u, v);
  return glm::dot(cross, cross) > 1e-24 * uu * vv && a != b && b != c && c != a;
}

/// The run's triangles that have area, with indices counted from the run's first vertex.
std::vector<unsigned> solidTriangles(const RawMesh& mesh, const RawMesh::Run& run) {
  std::vector<unsigned> out;
  out.reserve(run.indexCount);
  for (std::uint32_t i = run.firstIndex; i + 2 < run.firstIndex + run.indexCount; i += 3) {
    const std::uint32_t a = mesh.indices[i], b = mesh.indices[i + 1], c = mesh.indices[i + 2];
    if (!hasArea(mesh.positions[a], mesh.positions[b], mesh.positions[c])) continue;
    out.insert(out.end(), {a - run.firstVertex, b - run.firstVertex, c - run.firstVertex});
  }
  return out;
}

/// Only drops vertices that no triangle uses; `remap` numbers the others in the order of first use. Returns their
/// number.
std::size_t compact(const std::vector<unsigned>& triangles, std::vector<unsigned>& remap) {
  unsigned next = 0;
  std::fill(remap.begin(), remap.end(), ~0U);
  for (const unsigned index : triangles)
    if (remap[index] == ~0U) remap[index] = next++;
  return next;
}

template <class T>
void moveStream(const std::vector<T>& from, const RawMesh::Run& run, const std::vector<unsigned>& remap,
                std::size_t unique, std::vector<T>& to) {
  const std::size_t base = to.size();
  to.resize(base + unique);
  meshopt_remapVertexBuffer(to.data() + base, from.data() + run.firstVertex, run.vertexCount, sizeof(T), remap.data());
}

}  // namespace

std::size_t weldInto(RawMesh&& mesh, bool merge, Model& model) {
  std::size_t dropped = 0;
  const bool tangents = !mesh.tangents.empty();
  for (std::uint32_t r = 0; r < mesh.runs.size(); ++r) {
    const RawMesh::Run& run = mesh.runs[r];
    const std::vector<unsigned> triangles = solidTriangles(mesh, run);
    dropped += (run.indexCount - triangles.size()) / 3;

    std::vector<meshopt_Stream> streams = {
        {mesh.positions.data() + run.firstVertex, sizeof(glm::vec3), sizeof(glm::vec3)},
        {mesh.normals.data() + run.firstVertex, sizeof(glm::vec3), sizeof(glm::vec3)},
        {mesh.uvs.data() + run.firstVertex, sizeof(glm::vec2), sizeof(glm::vec2)}};
    if (tangents) streams.push_back({mesh.tangents.data() + run.firstVertex, sizeof(glm::vec4), sizeof(glm::vec4)});
    std::vector<unsigned> remap(run.vertexCount);
    const std::size_t unique = triangles.empty() ? 0
                               : merge
                                   ? meshopt_generateVertexRemapMulti(remap.data(), triangles.data(), triangles.size(),
                                                                      run.vertexCount, streams.data(), streams.size())
                                   : compact(triangles, remap);
    const auto base = static_cast<std::uint32_t>(model.positions.size());
    model.parts.push_back(
        {r, static_cast<std::uint32_t>(model.indices.size()), static_cast<std::uint32_t>(triangles.size())});
    for (const unsigned index : triangles) model.indices.push_back(base + remap[index]);
    if (unique == 0) continue;
    moveStream(mesh.positions, run, remap, unique, model.positions);
    moveStream(mesh.normals, run, remap, unique, model.normals);
    moveStream(mesh.uvs, run, remap, unique, model.uvs);
    if (tangents) moveStream(mesh.tangents, run, remap, unique, model.tangents);
  }
  model.tangents.resize(model.positions.size(), glm::vec4(0.0F));
  return dropped;
}

}  // namespace dermis::import
