// The presets that the program carries (resources/presets).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/material/material.h"

namespace dermis {

/// `id` is the NAME of "builtin:NAME"; `name` is for people.
struct BuiltinPreset {
  std::string id;
  std::string name;
};

/// In the order in which people look through them: skins first.
[[nodiscard]] const std::vector<BuiltinPreset>& builtinPresets();

/// Errors: Input, where there is none of that name.
[[nodiscard]] Result<Material> loadBuiltinPreset(std::string_view id, Warnings& warnings);

}  // namespace dermis
