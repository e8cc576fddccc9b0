// Strangers' words made fit for one sentence.
#pragma once

#include <string>
#include <string_view>

namespace dermis::import {

/// A library's message or a name out of a file as part of one sentence: one line, no control characters or broken
/// UTF-8, no closing full stop, at most `limit` bytes.
[[nodiscard]] std::string phrase(std::string_view text, std::size_t limit = 160);

}  // namespace dermis::import
