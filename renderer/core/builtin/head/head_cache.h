// Heads on disk, named by level and by the source they were made by.
#pragma once

#include <filesystem>
#include <optional>

#include "core/builtin/head/head.h"

namespace dermis {

/// The slots and the unit of every head's model.
void describeHead(Model& model);

/// Empty where the user has no cache folder.
[[nodiscard]] std::filesystem::path headCacheFile(HeadLevel level);
/// Empty where there is none, or it isn't whole.
[[nodiscard]] std::optional<Head> readHead(const std::filesystem::path& file);
/// False where it can't be written: then nothing is cached.
bool writeHead(const std::filesystem::path& file, const Head& head);

}  // namespace dermis
