// Models in, through Assimp: from a file to flat, checked buffers.
#pragma once

#include <filesystem>
#include <stop_token>

#include "core/base/result.h"
#include "core/scene/model.h"

namespace dermis::import {

/// See Importer::loadModel. Steps: check what can be checked before parsing, parse, flatten the node tree into one mesh
/// a material, make what normals are missing, weld, make tangents, turn materials into slots, find the unit.
[[nodiscard]] Result<Model> loadModel(const std::filesystem::path& path, const std::stop_token& stop);

}  // namespace dermis::import
