// How our files name other files: relative to their own folder on disk, absolute in memory.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace dermis {

/// "builtin:NAME" and "embedded:N" name no file; they are kept as written everywhere.
[[nodiscard]] bool namesNoFile(std::string_view reference);

/// NAME of "builtin:NAME", content that the program carries; nothing for any other reference.
[[nodiscard]] std::optional<std::string_view> builtinName(std::string_view reference);
[[nodiscard]] std::string builtinReference(std::string_view name);

/// N of "embedded:N", an image inside the model's own file; nothing for any other reference.
[[nodiscard]] std::optional<std::size_t> embeddedIndex(std::string_view reference);
[[nodiscard]] std::string embeddedReference(std::size_t index);

/// A reference read from a file in `folder`, as an absolute path. With an empty folder it stays as written.
[[nodiscard]] std::string absoluteReference(const std::string& reference, const std::filesystem::path& folder);

/// A reference as it is written to a file in `folder`: relative, unless nothing but the root is common to both.
[[nodiscard]] std::string relativeReference(const std::string& reference, const std::filesystem::path& folder);

}  // namespace dermis
