// PLY's header and body against each other, before a parser that loops on a broken header gets to see them.
#pragma once

#include <string>
#include <string_view>

#include "core/base/result.h"

namespace dermis::import {

/// Errors: Input, one sentence that names the header's line or the element that is cut off.
[[nodiscard]] Result<void> checkPly(std::string_view bytes, const std::string& name);

}  // namespace dermis::import
