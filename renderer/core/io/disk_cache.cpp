#include "core/io/disk_cache.h"

#include <algorithm>
#include <cstdlib>
#include <system_error>
#include <vector>

namespace dermis {

namespace fs = std::filesystem;

void trimDiskCache(const fs::path& folder, std::string_view suffix, std::uintmax_t mostBytes) {
  struct Entry {
    fs::path path;
    std::uintmax_t size;
    fs::file_time_type used;
  };
  std::vector<Entry> entries;
  std::uintmax_t total = 0;
  std::error_code error;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    if (it->path().extension() != suffix) continue;
    std::error_code gone;
    const auto size = it->file_size(gone);
    const auto used = it->last_write_time(gone);
    if (gone) continue;
    entries.push_back({it->path(), size, used});
    total += size;
  }
  std::ranges::sort(entries, {}, &Entry::used);
  for (std::size_t i = 0; total > mostBytes && i + 1 < entries.size(); ++i) {
    if (fs::remove(entries[i].path, error)) total -= entries[i].size;
  }
}

fs::path userCacheFolder() {
  const auto folder = [](const char* variable) {
    const char* value = std::getenv(variable);
    return value != nullptr && fs::path(value).is_absolute() ? fs::path(value) : fs::path();
  };
  if (const fs::path cache = folder("XDG_CACHE_HOME"); !cache.empty()) return cache / "Dermis" / "dermis";
  const fs::path home = folder("HOME");
  return home.empty() ? home : home / ".cache" / "Dermis" / "dermis";
}

}  // namespace dermis
