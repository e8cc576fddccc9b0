#include "core/scene/coarse_mesh.h"

#include <meshoptimizer.h>

#include <algorithm>
#include <span>

#include "core/scene/pieces.h"

namespace dermis {
namespace {

constexpr std::size_t kMostLevels = 2;
constexpr std::size_t kShare = 4;  // a side of half the pixels has a quarter of the picture

struct Run {
  std::uint32_t first = 0, count = 0;
};

/// One part simplified: indices counted from `first`, of `count` vertices, are replaced. Returns the error in scene
/// units.
float simplify(const Model& model, const Run& vertices, std::vector<std::uint32_t>& indices, float mostError) {
  const float* positions = &model.positions[vertices.first].x;
  const float extent = meshopt_simplifyScale(positions, vertices.count, sizeof(glm::vec3));
  if (!(extent > 0.0F)) return 0.0F;
  std::vector<std::uint32_t> fewer(indices.size());
  float error = 0.0F;
  fewer.resize(meshopt_simplify(fewer.data(), indices.data(), indices.size(), positions, vertices.count,
                                sizeof(glm::vec3), indices.size() / kShare / 3 * 3, mostError / extent,
                                meshopt_SimplifyLockBorder, &error));
  indices.resize(fewer.size());
  meshopt_optimizeVertexCache(indices.data(), fewer.data(), fewer.size(), vertices.count);
  return error * extent;
}

/// Whether a part is made of pieces that don't hang together, of few triangles each.
bool isManyPieces(const Model& model, const Run& vertices, const std::vector<std::uint32_t>& indices) {
  constexpr std::size_t kFewTriangles = 256;
  const Pieces pieces = piecesOf(std::span(model.positions).subspan(vertices.first, vertices.count), indices);
  std::vector<char> used(pieces.piece.size(), 0);
  for (const std::uint32_t index : indices) used[pieces.piece[pieces.point[index]]] = 1;
  const auto count = static_cast<std::size_t>(std::ranges::count(used, 1));
  return count > 16 && indices.size() / 3 < kFewTriangles * count;
}

Run verticesOf(const std::uint32_t* indices, std::size_t count) {
  if (count == 0) return {};
  const auto [least, most] = std::minmax_element(indices, indices + count);
  return {*least, *most - *least + 1};
}

CoarseMesh next(const Model& model, const CoarseMesh& before, float mostError) {
  CoarseMesh coarse;
  for (const CoarseMesh::Part& part : before.parts) {
    std::vector<std::uint32_t> indices(before.indices.begin() + part.firstIndex,
                                       before.indices.begin() + part.firstIndex + part.indexCount);
    const Run run = verticesOf(indices.data(), indices.size());
    for (std::uint32_t& index : indices) index -= run.first;
    if (run.count > 0 && !isManyPieces(model, run, indices))
      coarse.error = std::max(coarse.error, simplify(model, run, indices, mostError));
    for (std::uint32_t& index : indices) index += run.first;
    CoarseMesh::Part made{static_cast<std::uint32_t>(coarse.indices.size()), static_cast<std::uint32_t>(indices.size()),
                          static_cast<std::uint32_t>(coarse.vertices.size()), 0};
    coarse.indices.insert(coarse.indices.end(), indices.begin(), indices.end());
    std::sort(indices.begin(), indices.end());
    indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
    made.vertexCount = static_cast<std::uint32_t>(indices.size());
    coarse.vertices.insert(coarse.vertices.end(), indices.begin(), indices.end());
    coarse.parts.push_back(made);
  }
  coarse.error += before.error;
  return coarse;
}

}  // namespace

std::vector<CoarseMesh> coarseMeshes(const Model& model, float mostError) {
  CoarseMesh whole;
  whole.indices = model.indices;
  for (const ModelPart& part : model.parts) whole.parts.push_back({part.firstIndex, part.indexCount, 0, 0});
  std::vector<CoarseMesh> levels;
  while (levels.size() < kMostLevels) {
    const CoarseMesh& before = levels.empty() ? whole : levels.back();
    // Errors of levels add up.
    CoarseMesh coarse = next(model, before, mostError * static_cast<float>(levels.size() + 1) - before.error);
    if (coarse.indices.empty() || 2 * coarse.indices.size() > before.indices.size()) break;
    levels.push_back(std::move(coarse));
  }
  return levels;
}

}  // namespace dermis
