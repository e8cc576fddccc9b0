// The marker segments of a JPEG file: is it whole, and which texts did we put in it?
//
// libjpeg fills what is missing at the end with grey and calls that a warning, so we look for the end mark ourselves.
// Metadata travels in COM segments ("dermis-metadata", NUL, part of a JSON object): one segment ends at 65,533 bytes.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace dermis::import {

/// Whether the scan is followed by an end mark (EOI).
[[nodiscard]] bool jpegIsWhole(std::span<const std::byte> bytes);
[[nodiscard]] bool jpegIsWhole(const std::filesystem::path& path);

/// The text put in by withJpegText, joined; empty where there is none.
[[nodiscard]] std::string jpegText(const std::filesystem::path& path);

/// The file with `text` in COM segments after its first segment.
[[nodiscard]] std::string withJpegText(std::string_view jpeg, std::string_view text);

}  // namespace dermis::import
