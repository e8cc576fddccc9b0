// Maps that the program makes, kept in the user's cache on disk as long as the code that makes them is the same.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/image/image.h"

namespace dermis::skin {

/// The map kept under `key`, all that it was made from; nothing where none is, or it is damaged.
[[nodiscard]] std::optional<Image> readCachedMap(const std::string& key, std::string_view name);
/// A cache that can't be written is one that isn't there.
void writeCachedMap(const std::string& key, const Image& image);

}  // namespace dermis::skin
