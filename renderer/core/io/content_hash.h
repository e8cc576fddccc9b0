// What a file's bytes are, as a number: names disk caches and goes into the metadata of pictures.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

#include "core/base/result.h"

namespace dermis {

/// XXH64 (seed 0) of the bytes.
[[nodiscard]] std::uint64_t contentHash(std::span<const std::byte> bytes, std::uint64_t seed = 0);
/// XXH64 of a file's bytes, read in pieces. Errors: Input, a missing or unreadable file.
[[nodiscard]] Result<std::uint64_t> contentHashOfFile(const std::filesystem::path& path);
/// Sixteen hexadecimal digits.
[[nodiscard]] std::string hexadecimal(std::uint64_t hash);

}  // namespace dermis
