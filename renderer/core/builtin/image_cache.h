// Images that the program makes, kept in the user's cache on disk as long as the code that makes them is the same.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/image/image.h"

namespace dermis {

/// Under what an image is kept: the source that makes it (generated/…_source_hash.h), and all that it is made from.
struct ImageKey {
  std::uint64_t source = 0;
  std::string what;
};

/// Nothing where none is kept, or it is damaged. `name` becomes the image's.
[[nodiscard]] std::optional<Image> readCachedImage(const ImageKey& key, std::string_view name);
/// A cache that can't be written is one that isn't there.
void writeCachedImage(const ImageKey& key, const Image& image);

}  // namespace dermis
