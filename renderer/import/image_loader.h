// Images in, through OpenImageIO: from bytes to flat, checked pixels.
#pragma once

#include <filesystem>
#include <span>
#include <stop_token>
#include <string>

#include "core/io/importer.h"

namespace dermis::import {

/// See Importer::loadImage. Only the first sub-image and the full-size level are read. Alpha stays as the format has
/// it: not multiplied in PNG and the like, multiplied in EXR. An EXR's data window is placed in its display window.
[[nodiscard]] Result<Image> loadImage(const std::filesystem::path& path, const ImageReadOptions& options,
                                      Warnings& warnings, const std::stop_token& stop);
[[nodiscard]] Result<Image> loadImage(std::span<const std::byte> bytes, const std::string& name,
                                      const ImageReadOptions& options, Warnings& warnings);
[[nodiscard]] Result<ImageInfo> inspectImage(const std::filesystem::path& path);

}  // namespace dermis::import
