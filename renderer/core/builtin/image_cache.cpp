#include "core/builtin/image_cache.h"

#include <fmt/format.h>
#include <xxhash.h>

#include <cstring>
#include <filesystem>
#include <memory>
#include <span>
#include <system_error>
#include <utility>

#include "core/base/file_io.h"
#include "core/base/mapped_file.h"
#include "core/io/disk_cache.h"

namespace dermis {
namespace {

namespace fs = std::filesystem;

constexpr const char* kSuffix = ".dermismap";
constexpr std::uintmax_t kMostBytes = std::uintmax_t{512} << 20U;

/// In front of the pixels, in the machine's own byte order: a cache doesn't travel.
struct Header {
  std::uint64_t source = 0, hash = 0;
  std::int32_t width = 0, height = 0, channels = 0, type = 0;
};

fs::path fileOf(const ImageKey& key) {
  const fs::path folder = userCacheFolder("maps");
  if (folder.empty()) return {};
  return folder / fmt::format("{:016x}-{:016x}{}", key.source, XXH3_64bits(key.what.data(), key.what.size()), kSuffix);
}

}  // namespace

std::optional<Image> readCachedImage(const ImageKey& key, std::string_view name) {
  const fs::path path = cachedFile(fileOf(key));
  auto file = std::make_shared<const MappedFile>(path);
  const std::span<const std::byte> bytes = file->bytes();
  Header header;
  if (bytes.size() < sizeof header) return std::nullopt;
  std::memcpy(&header, bytes.data(), sizeof header);
  Image image;
  image.width = header.width;
  image.height = header.height;
  image.channels = header.channels;
  image.type = static_cast<PixelType>(header.type);
  image.name = name;
  const std::span<const std::byte> pixels = bytes.subspan(sizeof header);
  if (header.source != key.source || image.width < 1 || image.height < 1 || image.channels < 1 || image.channels > 4 ||
      header.type < 0 || header.type > static_cast<int>(PixelType::Float) ||
      pixels.size() != static_cast<std::uintmax_t>(image.height) * image.rowBytes() ||
      header.hash != XXH3_64bits(pixels.data(), pixels.size()))
    return std::nullopt;
  image.pixels = PixelBytes(std::move(file), pixels);
  // The time of last use, for trimDiskCache().
  std::error_code ignored;
  fs::last_write_time(path, fs::file_time_type::clock::now(), ignored);
  return image;
}

void writeCachedImage(const ImageKey& key, const Image& image) {
  const fs::path file = fileOf(key);
  if (file.empty()) return;
  std::error_code error;
  fs::create_directories(file.parent_path(), error);
  if (error) return;
  const Header header = {key.source,     XXH3_64bits(image.pixels.data(), image.pixels.size()),
                         image.width,    image.height,
                         image.channels, static_cast<std::int32_t>(image.type)};
  std::string bytes(sizeof header + image.pixels.size(), '\0');
  std::memcpy(bytes.data(), &header, sizeof header);
  std::memcpy(bytes.data() + sizeof header, image.pixels.data(), image.pixels.size());
  if (writeFileAtomically(file, bytes)) trimDiskCache(file.parent_path(), kSuffix, kMostBytes);
}

}  // namespace dermis
