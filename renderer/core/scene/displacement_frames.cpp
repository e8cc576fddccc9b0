#include "core/scene/displacement_frames.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <unordered_map>

namespace dermis {
namespace {

/// Vertices at one place get one number. Places that differ by rounding, as the two ends of a circle do, are one.
std::vector<std::uint32_t> placesOf(const Model& model) {
  struct Hash {
    std::size_t operator()(const glm::ivec3& cell) const {
      std::uint64_t hash = 0x9e3779b97f4a7c15ULL;
      for (int i = 0; i < 3; ++i) {
        hash = (hash ^ static_cast<std::uint32_t>(cell[i])) * 0xff51afd7ed558ccdULL;
        hash ^= hash >> 32;
      }
      return hash;
    }
  };
  const float cellsPerUnit = 0x1p22F / std::max(model.bounds.radius(), 1e-30F);
  std::unordered_map<glm::ivec3, std::uint32_t, Hash> known;
  known.reserve(model.positions.size());
  std::vector<std::uint32_t> places(model.positions.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    const glm::ivec3 cell(glm::round((model.positions[i] - model.bounds.centre()) * cellsPerUnit));
    places[i] = known.try_emplace(cell, static_cast<std::uint32_t>(i)).first->second;
  }
  return places;
}

/// A vector to each of two edges of a triangle, in its plane: dot(dual[i], edge[j]) is 1 for i = j, else 0.
struct DualEdges {
  glm::vec3 first{0.0F}, second{0.0F};
  float area = 0.0F;  ///< 0: the triangle has none and the duals are zero
};

DualEdges dualOf(const glm::vec3& e1, const glm::vec3& e2) {
  DualEdges dual;
  const glm::vec3 n = glm::cross(e1, e2);
  const float n2 = glm::dot(n, n);
  const float longest2 = std::max(glm::dot(e1, e1), glm::dot(e2, e2));
  if (!(n2 > 1e-12F * longest2 * longest2)) return dual;
  dual.first = glm::cross(e2, n) / n2;
  dual.second = glm::cross(n, e1) / n2;
  dual.area = 0.5F * std::sqrt(n2);
  return dual;
}

glm::vec3 normalizedOr(const glm::vec3& v, const glm::vec3& fallback) {
  const float length = glm::length(v);
  return length > 1e-3F ? v / length : fallback;
}

void findSeams(const Model& model, const std::vector<std::uint32_t>& places, DisplacementFrames& frames) {
  // A place is cut where its vertices have different coordinates; the vertex that names the place lends its own.
  std::vector<bool> isCut(places.size(), false);
  bool any = false;
  for (std::size_t i = 0; i < places.size(); ++i)
    if (model.uvs[i] != model.uvs[places[i]]) any = isCut[places[i]] = true;
  if (!any) return;

  // An edge between two cut places takes the coordinates of the first triangle that has it.
  std::unordered_map<std::uint64_t, std::array<glm::vec2, 2>> edges;
  const auto edgeOf = [&](std::uint32_t a, std::uint32_t b) -> std::array<glm::vec2, 2> {
    const bool swapped = places[a] > places[b];
    if (swapped) std::swap(a, b);
    std::array<glm::vec2, 2> uvs = {model.uvs[a], model.uvs[b]};
    if (isCut[places[a]] || isCut[places[b]]) {
      const std::uint64_t key = static_cast<std::uint64_t>(places[a]) << 32 | places[b];
      uvs = edges.try_emplace(key, uvs).first->second;
    }
    if (swapped) std::swap(uvs[0], uvs[1]);
    return uvs;
  };
  frames.seamOfTriangle.assign(model.indices.size() / 3, 0);
  for (std::size_t t = 0; t < frames.seamOfTriangle.size(); ++t) {
    const std::uint32_t* v = &model.indices[3 * t];
    DisplacementSeam seam;
    bool differs = false;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t a = v[(i + 1) % 3];
      const std::uint32_t b = v[(i + 2) % 3];
      seam.corner[i] = model.uvs[places[v[i]]];
      seam.edge[i] = edgeOf(a, b);
      differs = differs || seam.corner[i] != model.uvs[v[i]] || seam.edge[i][0] != model.uvs[a] ||
                seam.edge[i][1] != model.uvs[b];
    }
    if (!differs) continue;
    frames.seams.push_back(seam);
    frames.seamOfTriangle[t] = static_cast<std::uint32_t>(frames.seams.size());
  }
}

}  // namespace

DisplacementFrames displacementFrames(const Model& model) {
  DisplacementFrames frames;
  const std::size_t count = model.positions.size();
  frames.vertices.resize(count);
  const std::vector<std::uint32_t> places = placesOf(model);

  std::vector<glm::vec3> directions(count, glm::vec3(0.0F));
  for (std::size_t i = 0; i < count; ++i) directions[places[i]] += model.normals[i];
  for (std::size_t i = 0; i < count; ++i)
    if (places[i] == i) directions[i] = normalizedOr(directions[i], model.normals[i]);

  // Sums over the triangles: gradients by vertex, because coordinates are a vertex's; curvature by place.
  std::vector<float> areas(count, 0.0F);
  std::vector<glm::vec2> curvatures(count, glm::vec2(0.0F));  // sum, weight
  for (const ModelPart& part : model.parts) {
    double area = 0.0, uvArea = 0.0, squares = 0.0;
    for (std::uint32_t k = 0; k + 2 < part.indexCount; k += 3) {
      const std::uint32_t* v = &model.indices[part.firstIndex + k];
      const glm::vec3 e1 = model.positions[v[1]] - model.positions[v[0]];
      const glm::vec3 e2 = model.positions[v[2]] - model.positions[v[0]];
      const glm::vec3 e3 = e2 - e1;
      const glm::vec2 d1 = model.uvs[v[1]] - model.uvs[v[0]];
      const glm::vec2 d2 = model.uvs[v[2]] - model.uvs[v[0]];
      const DualEdges dual = dualOf(e1, e2);
      area += static_cast<double>(dual.area);
      uvArea += 0.5 * std::abs(static_cast<double>(d1.x * d2.y - d1.y * d2.x));
      squares += static_cast<double>(glm::dot(e1, e1) + glm::dot(e2, e2) + glm::dot(e3, e3)) / 3.0;
      const glm::vec3 gradientU = d1.x * dual.first + d2.x * dual.second;
      const glm::vec3 gradientV = d1.y * dual.first + d2.y * dual.second;
      const glm::vec3 n0 = directions[places[v[0]]];
      const float divergence =
          glm::dot(directions[places[v[1]]] - n0, dual.first) + glm::dot(directions[places[v[2]]] - n0, dual.second);
      for (int i = 0; i < 3; ++i) {
        frames.vertices[v[i]].gradientU += dual.area * glm::vec4(gradientU, 0.0F);
        frames.vertices[v[i]].gradientV += dual.area * glm::vec4(gradientV, 0.0F);
        areas[v[i]] += dual.area;
        curvatures[places[v[i]]] += dual.area * glm::vec2(0.5F * divergence, 1.0F);
      }
    }
    DisplacementDensity density;
    if (area > 0.0) density.uvPerUnit = static_cast<float>(std::sqrt(uvArea / area));
    const std::uint32_t triangles = part.indexCount / 3;
    if (triangles > 0) density.meanEdge = static_cast<float>(std::sqrt(squares / triangles));
    frames.parts.push_back(density);
  }
  for (std::size_t i = 0; i < count; ++i) {
    DisplacementFrame& frame = frames.vertices[i];
    if (areas[i] > 0.0F) {
      frame.gradientU /= areas[i];
      frame.gradientV /= areas[i];
    }
    const glm::vec2 curvature = curvatures[places[i]];
    frame.directionCurvature = glm::vec4(directions[places[i]], curvature.y > 0.0F ? curvature.x / curvature.y : 0.0F);
  }
  findSeams(model, places, frames);
  return frames;
}

}  // namespace dermis
