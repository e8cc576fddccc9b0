// What the bakes share.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>

#include "app/commands/support.h"
#include "core/image/image.h"

namespace dermis::cli {

/// Writes floats as they are, channels named R, G, B, A.
[[nodiscard]] Outcome<void> writeExr(const std::filesystem::path& path, const Image& image);

/// `bake thickness` and `bake occlusion`.
void addBakeMesh(CLI::App& bake, Action& action);

}  // namespace dermis::cli
