// A material as a preset file (NAME.json, format "dermis.material").
//
// In memory texture paths are absolute (or "embedded:N"); in the file they are relative to its folder where they can
// be.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/base/json_fields.h"
#include "core/base/json_text.h"
#include "core/base/result.h"
#include "core/material/material.h"

namespace dermis {

inline constexpr std::string_view kPresetFormat = "dermis.material";
inline constexpr int kPresetVersion = 1;

/// Reads a preset. `name` is the file's name for messages; `folder` is what texture paths are relative to (empty: they
/// stay as written). Unknown keys are kept and reported; missing parameters take their default and are reported; values
/// outside the hard range are clamped with a warning. Errors: Input with the JSON pointer of the place: not JSON, wrong
/// types, versions from the future.
[[nodiscard]] Result<Material> readPreset(std::string_view text, const std::string& name,
                                          const std::filesystem::path& folder, Warnings& warnings);

/// The same from disk; "builtin:NAME" loads a preset that the program carries.
[[nodiscard]] Result<Material> loadPreset(const std::filesystem::path& path, Warnings& warnings);

/// The file's text: every parameter of the material's shading model in table order.
[[nodiscard]] std::string writePreset(const Material& material, const std::filesystem::path& presetFolder);

/// Writes beside the target and renames. Errors: Runtime, as writeFileAtomically.
[[nodiscard]] Result<void> savePreset(const std::filesystem::path& path, const Material& material);

/// A preset on its own must be complete; one inside a scene may leave out what it likes.
enum class PresetPlace { File, Inline };
/// A preset that is part of a larger document, at `pointer`.
[[nodiscard]] Material readMaterial(const Json& json, const std::string& pointer, PresetPlace place,
                                    const std::filesystem::path& folder, JsonReport& report);
[[nodiscard]] Json materialToJson(const Material& material, const std::filesystem::path& folder);

}  // namespace dermis
