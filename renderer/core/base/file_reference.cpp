#include "core/base/file_reference.h"

#include <iterator>

namespace dermis {

namespace fs = std::filesystem;

bool namesNoFile(std::string_view reference) {
  return reference.starts_with("builtin:") || reference.starts_with("embedded:");
}

std::string absoluteReference(const std::string& reference, const fs::path& folder) {
  if (reference.empty() || folder.empty() || namesNoFile(reference)) return reference;
  return (fs::absolute(folder) / reference).lexically_normal().string();
}

std::string relativeReference(const std::string& reference, const fs::path& folder) {
  const fs::path path = fs::path(reference).lexically_normal();
  if (folder.empty() || namesNoFile(reference) || !path.is_absolute()) return reference;
  const fs::path base = fs::absolute(folder).lexically_normal();
  const auto firstFolder = [](const fs::path& p) {
    const fs::path inside = p.relative_path();
    return inside.empty() ? fs::path() : *inside.begin();
  };
  if (path.root_path() != base.root_path() || firstFolder(path) != firstFolder(base)) return path.string();
  return path.lexically_relative(base).string();
}

}  // namespace dermis
