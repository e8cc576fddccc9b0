// What the folders of cached bakes have in common.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>

namespace dermis {

/// Removes files that end in `suffix`, those used longest ago first, until together they keep to `mostBytes`; the one
/// used last stays. Use is the time of last modification: readers touch what they read.
void trimDiskCache(const std::filesystem::path& folder, std::string_view suffix, std::uintmax_t mostBytes);

/// Where this user's programs keep what they can make again, for Dermis: below $XDG_CACHE_HOME, else ~/.cache. Empty
/// without either.
[[nodiscard]] std::filesystem::path userCacheFolder();

}  // namespace dermis
