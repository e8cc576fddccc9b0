// glTF 2.0 made safe for a parser that trusts its input: checked against the bytes it refers to, and rebuilt with only
// what a look needs (no animations, cameras, lights, morph targets or unknown extensions).
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace dermis::import {

/// The file rewritten as a GLB with one plain buffer. Errors: Input, one sentence that names the place by a JSON
/// pointer.
[[nodiscard]] Result<std::string> checkedGltf(std::string_view bytes, const std::filesystem::path& path);

}  // namespace dermis::import
