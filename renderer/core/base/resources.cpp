#include "core/base/resources.h"

#include <algorithm>

#include "embedded_table.h"

namespace dermis {

std::string_view resource(std::string_view path) {
  for (const embedded::Row* row = embedded::kRows; row->path != nullptr; ++row)
    if (path == row->path) return {row->begin, static_cast<std::size_t>(row->end - row->begin)};
  return {};
}

std::vector<std::string_view> resourcePaths(std::string_view prefix) {
  std::vector<std::string_view> paths;
  for (const embedded::Row* row = embedded::kRows; row->path != nullptr; ++row)
    if (std::string_view(row->path).starts_with(prefix)) paths.emplace_back(row->path);
  std::sort(paths.begin(), paths.end());
  return paths;
}

}  // namespace dermis
