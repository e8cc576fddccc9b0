// Images out, through OpenImageIO: PNG, JPEG, TIFF and OpenEXR.
#pragma once

#include <filesystem>
#include <vector>

#include "core/io/importer.h"

namespace dermis::import {

/// See Importer::writeImage. 8- and 16-bit layers are display-referred with alpha not multiplied; half and float ones
/// are scene-linear Rec.709 with alpha multiplied, written to PNG and TIFF in 16 bits and to JPEG in 8 (clamped).
/// Metadata: PNG texts and EXR attributes of the keys' names, one JSON object in TIFF's ImageDescription and in JPEG
/// comments.
[[nodiscard]] Result<void> writeImage(const std::filesystem::path& path, const std::vector<ImageLayer>& layers,
                                      const ImageWriteOptions& options);

}  // namespace dermis::import
