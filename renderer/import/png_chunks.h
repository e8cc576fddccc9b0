// A PNG file's chunks, checked and thinned before libpng sees them.
//
// libpng as OpenImageIO uses it writes its complaints to standard error, about damage as about harmless colour
// profiles. So damage is found here, by the chunks' own checksums, and what we don't use is left out.
#pragma once

#include <string>
#include <string_view>

#include "core/base/result.h"

namespace dermis::import {

/// The file with header, palette, transparency and pixels, and with its texts where `withTexts` is set.
/// Errors: Input, one sentence: cut off, a checksum that fails, an impossible header.
[[nodiscard]] Result<std::string> checkedPng(std::string_view bytes, const std::string& name, bool withTexts);

}  // namespace dermis::import
