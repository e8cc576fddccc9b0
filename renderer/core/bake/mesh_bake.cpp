#include "core/bake/mesh_bake.h"

#include <algorithm>
#include <array>
#include <optional>
#include <span>

#include "core/bake/bake_cache.h"
#include "core/bake/bake_points.h"
#include "core/bake/parallel.h"
#include "core/bake/point_bake.h"
#include "core/bake/ray_scene.h"
#include "core/scene/pieces.h"

namespace dermis {
namespace {

/// A far side's sky and the thickness in front of it.
using FarRow = std::array<float, 10>;

/// What light reaches a place on a triangle, as harmonics: what its corners see, interpolated.
Harmonics<float> receivedAt(const RayScene& scene, const Model& model, const BakePoints& points,
                            const std::vector<Harmonics<float>>& hidden, const RayScene::Hit& hit) {
  const glm::uvec3& corners = scene.corners(hit.triangle);
  const glm::vec3 weights(1.0F - hit.weights.x - hit.weights.y, hit.weights.x, hit.weights.y);
  glm::vec3 normal(0.0F);
  for (int c = 0; c < 3; ++c) normal += weights[c] * model.normals[corners[c]];
  Harmonics<float> received = harmonicsAt(glm::normalize(normal));
  for (std::size_t k = 0; k < received.size(); ++k) {
    received[k] *= kCosineLobe<float>[k];
    for (int c = 0; c < 3; ++c) received[k] -= weights[c] * hidden[points.ofVertex[corners[c]]][k];
  }
  return received;
}

Harmonics<float> bounceAt(const RayScene& scene, const Model& model, const BakePoints& points,
                          const std::vector<Harmonics<float>>& hidden, std::size_t point, const RaySet& rays) {
  Harmonics<float> sum{};
  if (hidden[point] == Harmonics<float>{}) return sum;  // sees nothing but sky
  std::vector<glm::vec3> directions(rays.size());
  std::vector<std::optional<RayScene::Hit>> hits(rays.size());
  rays.around(points.normals[point], directions);
  scene.firstHits(points.positions[point] + points.normals[point] * scene.bias(), directions, hits);
  for (std::size_t i = 0; i < hits.size(); ++i) {
    // The inside of an open mesh is as dark as it is when it's closed.
    if (!hits[i] || !scene.meetsOutside(*hits[i], directions[i])) continue;
    const Harmonics<float> received = receivedAt(scene, model, points, hidden, *hits[i]);
    for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += received[k] / static_cast<float>(rays.size());
  }
  return sum;
}

FarRow farRow(const RayScene& scene, const Model& model, const BakePoints& points,
              const std::vector<Harmonics<float>>& hidden, std::size_t point, const RaySet& rays,
              float millimetresPerUnit) {
  const Thickness thickness =
      thicknessAt(scene, points.positions[point], points.normals[point], rays, kContactMm / millimetresPerUnit);
  FarRow row{};
  for (const RayScene::Hit& exit : thickness.exits) {
    const Harmonics<float> received = receivedAt(scene, model, points, hidden, exit);
    for (std::size_t k = 0; k < received.size(); ++k)
      row[k] += received[k] / static_cast<float>(thickness.exits.size());
  }
  row[9] = std::min(thickness.length * millimetresPerUnit, kThickestMm);
  return row;
}

std::optional<MeshBake> bake(const Model& model, const RayScene& scene, const MeshBakeOptions& options) {
  const BakePoints points = bakePoints(model, options.castingSlots);
  const std::vector<std::uint32_t> chosen = representatives(points, options.mostPoints);
  constexpr std::size_t kPiece = 64;
  const auto report = [&](float from, float to) {
    return [&options, from, to](float share) {
      if (options.progress != nullptr) *options.progress = from + (to - from) * share;
    };
  };

  const RaySet skyRays(options.skyRays, 90.0F);
  std::vector<Harmonics<float>> hidden(points.positions.size());
  const auto skies = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      hidden[chosen[i]] = hiddenSky(scene, points.positions[chosen[i]], points.normals[chosen[i]], skyRays);
  };
  if (!forPieces(chosen.size(), kPiece, options.stop, skies, report(0.0F, 0.5F))) return std::nullopt;
  spread(points, chosen, hidden);

  // By the same rays: what is hidden is what sends light.
  std::vector<Harmonics<float>> bounce(points.positions.size());
  const auto bounces = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      bounce[chosen[i]] = bounceAt(scene, model, points, hidden, chosen[i], skyRays);
  };
  if (!forPieces(chosen.size(), kPiece, options.stop, bounces, report(0.5F, 0.7F))) return std::nullopt;
  spread(points, chosen, bounce);

  const RaySet inwardRays(options.thicknessRays, kThicknessConeDegrees);
  std::vector<FarRow> far(points.positions.size());
  const auto depths = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      far[chosen[i]] = farRow(scene, model, points, hidden, chosen[i], inwardRays, options.millimetresPerUnit);
  };
  if (!forPieces(chosen.size(), kPiece, options.stop, depths, report(0.7F, 1.0F))) return std::nullopt;
  spread(points, chosen, far);

  MeshBake made;
  made.vertices.resize(model.positions.size());
  for (std::size_t v = 0; v < made.vertices.size(); ++v) {
    const std::uint32_t point = points.ofVertex[v];
    if (point == BakePoints::kNone) continue;
    made.vertices[v].hiddenSky = hidden[point];
    made.vertices[v].bounce = bounce[point];
    std::copy_n(far[point].begin(), 9, made.vertices[v].farSky.begin());
    made.vertices[v].thicknessMm = far[point][9];
  }
  for (const ModelPart& part : model.parts)
    made.solids.push_back(
        boundsSolids(model.positions, std::span(model.indices).subspan(part.firstIndex, part.indexCount)) ? 1 : 0);
  return made;
}

}  // namespace

Result<std::shared_ptr<const MeshBake>> bakeMesh(const Model& model, const MeshBakeOptions& options) {
  const bool cached = !options.cacheFolder.empty();
  const std::filesystem::path file = cached ? meshBakeFile(model, options) : std::filesystem::path();
  if (cached)
    if (auto known = readMeshBake(file, model)) return std::make_shared<const MeshBake>(std::move(*known));

  const Result<RayScene> scene = RayScene::create(model, options.castingSlots);
  if (!scene) return tl::unexpected(scene.error());
  std::optional<MeshBake> made = bake(model, *scene, options);
  if (!made) return cancelledError();
  if (cached) writeMeshBake(file, *made);
  return std::make_shared<const MeshBake>(std::move(*made));
}

}  // namespace dermis
