// The files embedded in the binary.
#pragma once

#include <string_view>
#include <vector>

namespace dermis {

/// The bytes of an embedded file by its path below `resources/`; empty where there is none of that name.
/// With DERMIS_SHADER_DIR set, `shaders/…` is read by the shader library from disk instead; this never looks there.
[[nodiscard]] std::string_view resource(std::string_view path);

/// Paths of all embedded files that start with `prefix`, sorted.
[[nodiscard]] std::vector<std::string_view> resourcePaths(std::string_view prefix);

}  // namespace dermis
