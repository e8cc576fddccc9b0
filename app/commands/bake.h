// What the bakes share.
#pragma once

#include <CLI/CLI.hpp>
#include <array>
#include <filesystem>
#include <string_view>

#include "app/commands/support.h"
#include "core/image/image.h"

namespace dermis::cli {

/// What tables and maps are written as.
inline constexpr std::array<std::string_view, 1> kExrOnly = {".exr"};

/// Makes it where its parent exists. Fails with 1.
[[nodiscard]] Outcome<void> makeFolder(const std::filesystem::path& folder);

/// Writes floats as they are, channels named R, G, B, A.
[[nodiscard]] Outcome<void> writeExr(const std::filesystem::path& path, const Image& image);

/// `bake thickness` and `bake occlusion`.
void addBakeMesh(CLI::App& bake, Action& action);

/// `bake look`.
void addBakeLook(CLI::App& bake, Action& action);

}  // namespace dermis::cli
