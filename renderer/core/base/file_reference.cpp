#include "core/base/file_reference.h"

#include <charconv>

namespace dermis {

namespace fs = std::filesystem;

namespace {
constexpr std::string_view kBuiltin = "builtin:";
constexpr std::string_view kEmbedded = "embedded:";
}  // namespace

bool namesNoFile(std::string_view reference) {
  return reference.starts_with(kBuiltin) || reference.starts_with(kEmbedded);
}

std::optional<std::string_view> builtinName(std::string_view reference) {
  if (!reference.starts_with(kBuiltin)) return std::nullopt;
  reference.remove_prefix(kBuiltin.size());
  return reference;
}

std::string builtinReference(std::string_view name) { return std::string(kBuiltin) + std::string(name); }

std::optional<std::size_t> embeddedIndex(std::string_view reference) {
  if (!reference.starts_with(kEmbedded)) return std::nullopt;
  reference.remove_prefix(kEmbedded.size());
  std::size_t index = 0;
  const char* const last = reference.data() + reference.size();
  const auto [end, error] = std::from_chars(reference.data(), last, index);
  if (error != std::errc() || end != last) return std::nullopt;
  return index;
}

std::string embeddedReference(std::size_t index) { return std::string(kEmbedded) + std::to_string(index); }

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
