// A light rig as a file (NAME.json, format "dermis.rig").
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/base/json_fields.h"
#include "core/base/result.h"
#include "core/light_rig/light_rig.h"

namespace dermis {

inline constexpr std::string_view kRigFormat = "dermis.rig";
inline constexpr int kRigVersion = 1;

/// Unknown keys are kept and reported, values out of range are clamped with a warning. Errors: Input with the JSON
/// pointer of the place: not JSON, wrong types, two keys that say the same thing, versions from the future.
[[nodiscard]] Result<LightRig> readRig(std::string_view text, const std::string& name, Warnings& warnings);
[[nodiscard]] Result<LightRig> loadRig(const std::filesystem::path& path, Warnings& warnings);

/// Whether the file says that it is a rig, so that it can be told from a preset, which ends in .json too.
[[nodiscard]] bool isRigFile(const std::filesystem::path& path);

/// The same of a rig inside of another file, at `pointer`; its errors and warnings go to the report.
[[nodiscard]] LightRig readRig(const Json& json, const std::string& pointer, JsonReport& report);

[[nodiscard]] Json rigToJson(const LightRig& rig);
[[nodiscard]] std::string writeRig(const LightRig& rig);
/// Writes beside the target and renames. Errors: Runtime, as writeFileAtomically.
[[nodiscard]] Result<void> saveRig(const std::filesystem::path& path, const LightRig& rig);

}  // namespace dermis
