// Maps made in code, for presets that the program carries: "builtin:NAME". Deterministic, and they tile.
#pragma once

#include <memory>
#include <optional>
#include <string_view>

#include "core/image/image.h"

namespace dermis {

/// NAME of "builtin:NAME" where there is such a map.
[[nodiscard]] std::optional<std::string_view> builtinMapId(std::string_view reference);

/// Null for an unknown name. `freckles`: sRGB RGB, what melanin in small spots leaves of the albedo, 1 between them;
/// one tile is meant to cover about ten centimetres.
[[nodiscard]] std::shared_ptr<const Image> builtinMap(std::string_view id);

}  // namespace dermis
