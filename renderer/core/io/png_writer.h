// PNG out, on libpng alone: the commonest picture without loading the import module, whose 261 libraries cost more
// than drawing it.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "core/base/result.h"
#include "core/image/image.h"

namespace dermis {

/// U8 or U16, one to four channels, sRGB; each text becomes an iTXt chunk. Beside the target, then renamed.
/// Errors: Runtime.
[[nodiscard]] Result<void> writePng(const std::filesystem::path& path, const Image& image,
                                    const std::map<std::string, std::string>& texts);

}  // namespace dermis
