// Mesh bakes on disk, named by what they are of.
#pragma once

#include <filesystem>
#include <optional>

#include "core/bake/mesh_bake.h"

namespace dermis {

/// Where the bake of this model is kept: positions, normals, triangles, what stops light, the unit, ray counts and
/// kMeshBakeVersion name it.
[[nodiscard]] std::filesystem::path meshBakeFile(const Model& model, const MeshBakeOptions& options);
/// Empty where there is none, or it isn't whole, or not of as many vertices and parts as the model.
[[nodiscard]] std::optional<MeshBake> readMeshBake(const std::filesystem::path& file, const Model& model);
/// False where it can't be written: then nothing is cached.
bool writeMeshBake(const std::filesystem::path& file, const MeshBake& bake);

/// The folder's mesh bakes together keep to this; those used longest ago go first.
inline constexpr std::uintmax_t kMeshBakeCacheBytes = std::uintmax_t{512} << 20U;

}  // namespace dermis
