#include "core/builtin/skin/map_cache.h"

#include <fmt/format.h>
#include <xxhash.h>

#include <cstring>
#include <filesystem>
#include <system_error>

#include "core/base/file_io.h"
#include "core/io/disk_cache.h"
#include "generated/skin_source_hash.h"

namespace dermis::skin {
namespace {

namespace fs = std::filesystem;

constexpr const char* kSuffix = ".dermismap";
constexpr std::uintmax_t kMostBytes = std::uintmax_t{512} << 20U;

/// In front of the pixels, in the machine's own byte order: a cache doesn't travel.
struct Header {
  std::uint64_t source = 0, hash = 0;
  std::int32_t width = 0, height = 0, channels = 0, type = 0;
};

fs::path fileOf(const std::string& key) {
  const fs::path folder = userCacheFolder();
  if (folder.empty()) return {};
  return folder / "maps" /
         fmt::format("{:016x}-{:016x}{}", kSkinSourceHash, XXH3_64bits(key.data(), key.size()), kSuffix);
}

}  // namespace

std::optional<Image> readCachedMap(const std::string& key, std::string_view name) {
  const fs::path file = fileOf(key);
  const Result<std::string> bytes = readFile(file, kMostBytes);
  Header header;
  if (!bytes || bytes->size() < sizeof header) return std::nullopt;
  std::memcpy(&header, bytes->data(), sizeof header);
  const std::string_view pixels = std::string_view(*bytes).substr(sizeof header);
  if (header.source != kSkinSourceHash || header.hash != XXH3_64bits(pixels.data(), pixels.size())) return std::nullopt;
  Image image;
  image.width = header.width;
  image.height = header.height;
  image.channels = header.channels;
  image.type = static_cast<PixelType>(header.type);
  image.name = name;
  if (pixels.size() != static_cast<std::size_t>(image.height) * image.rowBytes()) return std::nullopt;
  image.pixels.resize(pixels.size());
  std::memcpy(image.pixels.data(), pixels.data(), pixels.size());
  // The time of last use, for trimDiskCache().
  std::error_code ignored;
  fs::last_write_time(file, fs::file_time_type::clock::now(), ignored);
  return image;
}

void writeCachedMap(const std::string& key, const Image& image) {
  const fs::path file = fileOf(key);
  if (file.empty()) return;
  std::error_code error;
  fs::create_directories(file.parent_path(), error);
  if (error) return;
  const Header header = {kSkinSourceHash, XXH3_64bits(image.pixels.data(), image.pixels.size()),
                         image.width,     image.height,
                         image.channels,  static_cast<std::int32_t>(image.type)};
  std::string bytes(sizeof header + image.pixels.size(), '\0');
  std::memcpy(bytes.data(), &header, sizeof header);
  std::memcpy(bytes.data() + sizeof header, image.pixels.data(), image.pixels.size());
  if (writeFileAtomically(file, bytes)) trimDiskCache(file.parent_path(), kSuffix, kMostBytes);
}

}  // namespace dermis::skin
