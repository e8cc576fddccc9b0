// What every vertex of a model knows of the rest of it: which part of the sky is hidden, how thick the material is, and
// what light reaches its far side. Computed on all cores, kept on disk by content.
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <stop_token>
#include <vector>

#include "core/bake/harmonics.h"
#include "core/base/result.h"
#include "core/scene/model.h"

namespace dermis {

struct VertexBake {
  Harmonics<float> hiddenSky{};  ///< see hiddenSky() in point_bake.h; zeros in the open
  /// ∫ V(d) max(n·d, 0)/π Y_i(d) dω at the places where the rays that measured the thickness left the material, n the
  /// normal there: with an environment's coefficients it gives irradiance/π of the far side.
  Harmonics<float> farSky{};
  /// Light that other parts of a white, matt mesh send here: the mean over the cosine-weighted sky of what the hidden
  /// part of it receives, ∫ (1 − V(d)) max(n·d, 0)/π ∫ V(d′) max(n′·d′, 0)/π Y_i(d′) dω′ dω. With an environment's
  /// coefficients it gives irradiance/π after one bounce (Sloan, Kautz & Snyder 2002, section 4.2).
  Harmonics<float> bounce{};
  float thicknessMm = -1.0F;  ///< negative: not known

  bool operator==(const VertexBake&) const = default;
};

/// Immutable once made.
struct MeshBake {
  std::vector<VertexBake> vertices;  ///< parallel to Model::positions
  std::vector<std::uint8_t> solids;  ///< parallel to Model::parts: 1 where a part bounds solids (core/scene/pieces.h)
};

/// Material that no ray left counts as this thick, and nothing counts as thicker: the hard limit of
/// transmission.thickness_max_mm.
inline constexpr float kThickestMm = 500.0F;

struct MeshBakeOptions {
  float millimetresPerUnit = 1000.0F;
  /// By slot: whether it stops light; what doesn't (lenses, blended materials) isn't baked either. Shorter: the rest
  /// does.
  std::vector<bool> castingSlots;
  std::filesystem::path cacheFolder;  ///< empty: no disk cache
  std::stop_token stop;
  std::atomic<float>* progress = nullptr;  ///< 0..1
  int skyRays = 128, thicknessRays = 32;
  /// Beyond so many points (vertices apart in place or normal) some are baked and the others interpolated along edges.
  std::size_t mostPoints = 200'000;
};

/// Changes whenever the same model would give other numbers; part of the cache's key.
inline constexpr std::uint32_t kMeshBakeVersion = 5;

/// Reads the cache or bakes (and writes the cache). The same model gives the same bytes, however many cores there are.
/// Errors: Cancelled; Runtime (Embree).
[[nodiscard]] Result<std::shared_ptr<const MeshBake>> bakeMesh(const Model& model, const MeshBakeOptions& options);

}  // namespace dermis
