// Maps made in code: "builtin:NAME". Deterministic.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/image/image.h"

namespace dermis {

/// NAME of "builtin:NAME" where that names a map. Errors: Input, a phrase that follows the reference.
[[nodiscard]] Result<std::string_view> builtinMapId(std::string_view reference);
/// "builtin:freckles, builtin:head_albedo, …", for messages.
[[nodiscard]] std::string builtinMapNames();

/// Null for a name that builtinMapId() refuses. `freckles`: sRGB RGB, what melanin in small spots leaves of the albedo,
/// 1 between them; it tiles, and one tile is meant to cover about ten centimetres. `head_…`: skin/head_maps.h.
[[nodiscard]] std::shared_ptr<const Image> builtinMap(std::string_view id);

}  // namespace dermis
