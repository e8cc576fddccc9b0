// A TIFF file's ImageDescription, whole: OpenImageIO cuts it at 64 KiB.
#pragma once

#include <filesystem>
#include <string>

namespace dermis::import {

/// The first directory's ImageDescription without its closing NUL; empty where there is none or the file is damaged.
[[nodiscard]] std::string tiffDescription(const std::filesystem::path& path);

}  // namespace dermis::import
