// Models on their way out, for other programs.
#pragma once

#include <filesystem>

#include "core/base/result.h"
#include "core/scene/model.h"

namespace dermis::import {

/// Writes .glb (in metres, as glTF demands), .obj with its .mtl, .ply or .stl (in millimetres) by the extension, each
/// atomically: positions, normals, UVs and the slots as materials by name; PLY and STL know no materials. Looks and
/// maps stay out: our presets say more than these formats can. Errors: Runtime.
[[nodiscard]] Result<void> writeModel(const std::filesystem::path& path, const Model& model);

}  // namespace dermis::import
