// What the folders of cached bakes have in common.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>

namespace dermis {

/// Removes files that end in `suffix` (all where it is empty), those used longest ago first, until together they keep
/// to `mostBytes`; the one used last stays. Use is the time of last modification: readers touch what they read.
void trimDiskCache(const std::filesystem::path& folder, std::string_view suffix, std::uintmax_t mostBytes);

/// Where this user's programs keep what they can make again, for Dermis: below $XDG_CACHE_HOME, else ~/.cache. Empty
/// without either.
[[nodiscard]] std::filesystem::path userCacheFolder();

/// The folder of one kind in it: "heads", "maps", "bakes" (of environments and models). Empty without the cache.
[[nodiscard]] std::filesystem::path userCacheFolder(std::string_view kind);

/// Where to read a file of such a folder from: itself where it is there, else the same of what the program came with,
/// ../share/dermis/cache beside its own folder. Names hold hashes of what a file was made from, so neither is ever
/// stale. Only for reading.
[[nodiscard]] std::filesystem::path cachedFile(const std::filesystem::path& file);

/// From now on this process keeps everything there and looks nowhere else: what a program comes with is made so.
/// Before other threads start.
void keepCacheIn(const std::filesystem::path& folder);

}  // namespace dermis
