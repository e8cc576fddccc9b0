#include "core/builtin/head/refine.h"

#include <algorithm>
#include <unordered_map>

#include "core/bake/parallel.h"

namespace dermis::sculpt {
namespace {

std::uint64_t edgeKey(std::uint32_t a, std::uint32_t b) {
  const auto [low, high] = std::minmax(a, b);
  return static_cast<std::uint64_t>(low) << 32U | high;
}

glm::vec3 unit(const glm::vec3& v) {
  const float length = glm::length(v);
  return length > 1e-6F ? v / length : glm::vec3(0.0F, 1.0F, 0.0F);
}

glm::vec3 areaNormal(const AtlasMesh& mesh, const glm::uvec3& t) {
  const glm::vec3 &a = mesh.points[mesh.pointOf[t.x]], &b = mesh.points[mesh.pointOf[t.y]],
                  &c = mesh.points[mesh.pointOf[t.z]];
  return glm::cross(b - a, c - a);
}

template <class Work>
void forEach(std::size_t begin, std::size_t end, const Work& work) {
  forPieces(
      end - begin, 512, {},
      [&](std::size_t a, std::size_t b) {
        for (std::size_t i = begin + a; i < begin + b; ++i) work(i);
      },
      [](float) {});
}

}  // namespace

AtlasMesh refined(const AtlasMesh& mesh, const Sculpt& sculpt) {
  AtlasMesh fine = mesh;
  fine.triangles.clear();
  fine.charts.clear();
  std::unordered_map<std::uint64_t, std::uint32_t> pointOn, vertexOn;
  std::vector<float> lengths;  // of the edges that new points halve
  const auto vertexBetween = [&](std::uint32_t a, std::uint32_t b) {
    const auto [at, isNew] = vertexOn.try_emplace(edgeKey(a, b), static_cast<std::uint32_t>(fine.pointOf.size()));
    if (!isNew) return at->second;
    const std::uint32_t pa = mesh.pointOf[a], pb = mesh.pointOf[b];
    const auto [point, newPoint] = pointOn.try_emplace(edgeKey(pa, pb), static_cast<std::uint32_t>(fine.points.size()));
    if (newPoint) {
      fine.points.push_back(0.5F * (mesh.points[pa] + mesh.points[pb]));
      lengths.push_back(glm::distance(mesh.points[pa], mesh.points[pb]));
    }
    fine.pointOf.push_back(point->second);
    fine.uvs.push_back(0.5F * (mesh.uvs[a] + mesh.uvs[b]));
    return at->second;
  };
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const glm::uvec3 v = mesh.triangles[t];
    const std::uint32_t xy = vertexBetween(v.x, v.y), yz = vertexBetween(v.y, v.z), zx = vertexBetween(v.z, v.x);
    fine.triangles.insert(fine.triangles.end(), {{v.x, xy, zx}, {xy, v.y, yz}, {zx, yz, v.z}, {xy, yz, zx}});
    fine.charts.insert(fine.charts.end(), 4, mesh.charts[t]);
  }
  const std::size_t first = mesh.points.size();
  const std::vector<glm::vec3> middles(fine.points.begin() + static_cast<std::ptrdiff_t>(first), fine.points.end());
  forEach(first, fine.points.size(), [&](std::size_t i) {
    const float length = lengths[i - first];
    constexpr float kOfEdge = 0.15F, kFinest = 0.05F;
    fine.points[i] =
        sculpt.slope(fine.points[i], std::max(kOfEdge * length, kFinest)).onSkin(fine.points[i], 0.4F * length);
  });
  // Where a new point would turn one of the four over, or leave it without area, it stays halfway along the edge.
  constexpr float kLeastFacing = 0.2F, kLeastArea = 0.02F;  // area of the old triangle's
  for (int round = 0; round < 2; ++round)
    for (std::size_t t = 0; t < fine.triangles.size(); ++t) {
      const glm::vec3 was = areaNormal(mesh, mesh.triangles[t / 4]), is = areaNormal(fine, fine.triangles[t]);
      const float old = glm::length(was), now = glm::length(is);
      if (glm::dot(was, is) > kLeastFacing * old * now && now > kLeastArea * old) continue;
      for (int i = 0; i < 3; ++i)
        if (const std::size_t p = fine.pointOf[fine.triangles[t][i]]; p >= first) fine.points[p] = middles[p - first];
    }
  return fine;
}

std::vector<glm::vec3> settled(AtlasMesh& mesh, const Sculpt& sculpt) {
  // Slopes are taken over what the triangles round a point can show: finer would be noise.
  std::vector<float> lengths(mesh.points.size(), 0.0F), counts(mesh.points.size(), 0.0F);
  for (const glm::uvec3& t : mesh.triangles)
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t a = mesh.pointOf[t[i]], b = mesh.pointOf[t[(i + 1) % 3]];
      const float length = glm::distance(mesh.points[a], mesh.points[b]);
      for (const std::uint32_t p : {a, b}) {
        lengths[p] += length;
        counts[p] += 1.0F;
      }
    }
  std::vector<glm::vec3> normals(mesh.points.size());
  const std::vector<glm::vec3> before = mesh.points;
  forEach(0, mesh.points.size(), [&](std::size_t i) {
    constexpr float kMost = 0.2F, kOfEdge = 0.4F, kFinest = 0.12F, kCoarsest = 1.2F;
    const Sculpt::Slope slope =
        sculpt.slope(before[i], glm::clamp(kOfEdge * lengths[i] / counts[i], kFinest, kCoarsest));
    mesh.points[i] = slope.onSkin(before[i], kMost);
    normals[i] = unit(slope.gradient);
  });
  for (int round = 0; round < 3; ++round)
    for (const glm::uvec3& t : mesh.triangles) {
      const std::uint32_t a = mesh.pointOf[t.x], b = mesh.pointOf[t.y], c = mesh.pointOf[t.z];
      const glm::vec3 is = areaNormal(mesh, t), was = glm::cross(before[b] - before[a], before[c] - before[a]);
      constexpr float kLeastArea = 0.2F;  // of the one before
      if (glm::dot(is, was) > kLeastArea * glm::dot(was, was)) continue;
      for (const std::uint32_t p : {a, b, c}) mesh.points[p] = before[p];
    }
  return normals;
}

}  // namespace dermis::sculpt
