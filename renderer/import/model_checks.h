// What can be seen to be wrong in a model's file before a parser is let loose on it.
#pragma once

#include <assimp/scene.h>

#include <filesystem>
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace dermis::import {

/// By the extension: nesting so deep that a recursive parser would run out of stack, element counts that the file
/// cannot hold (glTF: see gltf_check.h). Errors: Input, one sentence.
[[nodiscard]] Result<void> checkModelBytes(std::string_view bytes, const std::filesystem::path& path);

/// Indices of a parsed scene, before Assimp's own steps work on them.
[[nodiscard]] Result<void> checkScene(const aiScene& scene, const std::string& name);

}  // namespace dermis::import
