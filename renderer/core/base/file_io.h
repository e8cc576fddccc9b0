// Files in one piece: read with a limit, written so that a reader sees the old content or the new, never a half.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace dermis {

/// The bytes of a file. Errors: Input, with a sentence: missing, a folder, not readable, larger than `maxBytes`.
[[nodiscard]] Result<std::string> readFile(const std::filesystem::path& path, std::size_t maxBytes);

/// Writes a temporary file beside the target, flushes it to the disk and renames it. Keeps the permissions of a file
/// that is replaced and writes through symbolic links; a device or pipe is written directly. Removes the temporary
/// file when anything fails. Errors: Runtime, with a sentence: folder missing, read-only, disk full.
[[nodiscard]] Result<void> writeFileAtomically(const std::filesystem::path& path, std::string_view bytes);

/// The same for a library that wants to write a file itself: `produce` is given the temporary file's path (beside the
/// target, with the target's extension; empty and with the right permissions).
[[nodiscard]] Result<void> replaceFileAtomically(
    const std::filesystem::path& path,
    const std::function<Result<void>(const std::filesystem::path& temporary)>& produce);

}  // namespace dermis
