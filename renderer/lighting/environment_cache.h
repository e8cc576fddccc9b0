// Baked environments on disk, so that a known one is there in a tenth of a second.
#pragma once

#include <memory>

#include "lighting/environment_bake.h"

namespace dermis {

/// What the cache folder may hold; the files used longest ago go first.
inline constexpr std::uintmax_t kEnvironmentCacheBytes = std::uintmax_t{1} << 30U;

/// The file of an environment: named by the content's hash, the options and kEnvironmentBakeVersion.
[[nodiscard]] std::filesystem::path environmentCacheFile(const EnvironmentBakeOptions& options,
                                                         const EnvironmentImages& images);

/// Maps the file; null where there is none, or where it is truncated or damaged (its checksum tells).
[[nodiscard]] std::shared_ptr<BakedEnvironment> readEnvironmentCache(const EnvironmentBakeOptions& options,
                                                                     const EnvironmentImages& images);

/// Writes beside the target and renames, then trims the folder. False where it couldn't.
bool writeEnvironmentCache(const EnvironmentBakeOptions& options, const EnvironmentImages& images,
                           const BakedEnvironment& baked);

}  // namespace dermis
