#include "core/io/disk_cache.h"

#include <algorithm>
#include <cstdlib>
#include <system_error>
#include <vector>

#include "core/io/program_folder.h"

namespace dermis {

namespace fs = std::filesystem;

namespace {

fs::path& ownFolder() {
  static fs::path folder;
  return folder;
}

}  // namespace

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
    std::error_code gone;
    if (!suffix.empty() && it->path().extension() != suffix) continue;
    if (!it->is_regular_file(gone)) continue;
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
  if (!ownFolder().empty()) return ownFolder();
  const auto folder = [](const char* variable) {
    const char* value = std::getenv(variable);
    return value != nullptr && fs::path(value).is_absolute() ? fs::path(value) : fs::path();
  };
  if (const fs::path cache = folder("XDG_CACHE_HOME"); !cache.empty()) return cache / "Dermis" / "dermis";
  const fs::path home = folder("HOME");
  return home.empty() ? home : home / ".cache" / "Dermis" / "dermis";
}

fs::path userCacheFolder(std::string_view kind) {
  const fs::path folder = userCacheFolder();
  return folder.empty() ? folder : folder / kind;
}

fs::path cachedFile(const fs::path& file) {
  std::error_code error;
  if (file.empty() || !ownFolder().empty() || fs::exists(file, error)) return file;
  const fs::path shipped = programFolder() / "../share/dermis/cache" / file.parent_path().filename() / file.filename();
  return fs::exists(shipped, error) ? shipped : file;
}

void keepCacheIn(const fs::path& folder) { ownFolder() = folder; }

}  // namespace dermis
