// Unsaved work on disk: a scene file with one key more, so that it also opens by hand.
#pragma once

#include <cstdint>
#include <filesystem>

#include "core/base/result.h"
#include "core/scene/scene.h"

namespace dermis {

struct Recovery {
  Scene scene;
  std::filesystem::path scenePath;       ///< the file it was opened from; empty: untitled
  std::int64_t savedAtMilliseconds = 0;  ///< since 1970, UTC
};

/// Materials are written inline, also those that are a preset file's: the file may be gone by the time it matters.
/// Errors: Runtime, as writeFileAtomically.
[[nodiscard]] Result<void> saveRecovery(const std::filesystem::path& path, const Recovery& recovery);
/// Errors: Input, as loadScene, and a scene that is no recovery.
[[nodiscard]] Result<Recovery> loadRecovery(const std::filesystem::path& path, Warnings& warnings);

}  // namespace dermis
