// Head maps in memory and on disk.
#include <fmt/format.h>
#include <xxhash.h>

#include <cstring>
#include <map>
#include <mutex>
#include <system_error>

#include "core/base/file_io.h"
#include "core/base/number_format.h"
#include "core/builtin/skin/head_maps.h"
#include "core/io/disk_cache.h"
#include "generated/skin_source_hash.h"

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

/// What the map depends on.
std::string keyOf(const HeadMapRequest& request) {
  const skin::Look& look = request.look;
  const std::string_view name = headMapNames().at(static_cast<std::size_t>(request.map));
  if (request.map == HeadMap::Region)
    return fmt::format("{}|{}|{}", name, request.size, headRegionName(request.region));
  if (request.map == HeadMap::Occlusion || request.map == HeadMap::Thickness)
    return fmt::format("{}|{}", name, request.size);
  std::string key = fmt::format("{}|{}|{}|{}", name, request.size, shortestDecimal(look.age), look.seed);
  if (request.map == HeadMap::Albedo) {
    for (const float value : {look.tone, look.melanin, look.haemoglobin, look.freckles, look.flush, look.stubble})
      key += "|" + shortestDecimal(value);
    if (request.relative) key += "|relative";
  }
  return key;
}

fs::path fileOf(const std::string& key) {
  const fs::path folder = userCacheFolder();
  if (folder.empty()) return {};
  return folder / "maps" /
         fmt::format("{:016x}-{:016x}{}", kSkinSourceHash, XXH3_64bits(key.data(), key.size()), kSuffix);
}

std::optional<Image> readMap(const fs::path& file, std::string_view name) {
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

void writeMap(const fs::path& file, const Image& image) {
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
  // A cache that can't be written is one that isn't there.
  if (writeFileAtomically(file, bytes)) trimDiskCache(file.parent_path(), kSuffix, kMostBytes);
}

HeadMaps made(const HeadMapRequest& request) {
  const std::shared_ptr<const Head> head = builtinHead(HeadLevel::Medium);
  HeadMaps maps;
  Image& asked = maps.images.at(static_cast<std::size_t>(request.map));
  switch (request.map) {
    case HeadMap::Albedo:
      asked = makeHeadAlbedo(rasteriseHead(*head, request.size), request.look, request.relative);
      break;
    case HeadMap::Occlusion:
    case HeadMap::Thickness:
      asked = makeHeadBaked(*head, request.map, request.size);
      break;
    case HeadMap::Region:
      asked = makeHeadRegion(rasteriseHead(*head, request.size), request.region);
      break;
    default:
      maps = makeHeadRelief(rasteriseHead(*head, request.size), request.look);
  }
  return maps;
}

}  // namespace

std::shared_ptr<const Image> headMap(const HeadMapRequest& request) {
  static std::mutex mutex;
  static std::map<std::string, std::weak_ptr<const Image>> remembered;
  const std::string key = keyOf(request);
  const std::string name(headMapNames().at(static_cast<std::size_t>(request.map)));
  const std::lock_guard lock(mutex);
  std::erase_if(remembered, [](const auto& entry) { return entry.second.expired(); });
  if (const auto found = remembered.find(key); found != remembered.end())
    if (auto image = found->second.lock()) return image;
  if (std::optional<Image> cached = readMap(fileOf(key), name)) {
    auto image = std::make_shared<const Image>(std::move(*cached));
    remembered[key] = image;
    return image;
  }
  const auto maps = std::make_shared<HeadMaps>(made(request));
  std::shared_ptr<const Image> asked;
  for (std::size_t i = 0; i < kHeadMapCount; ++i) {
    Image& image = maps->images.at(i);
    if (image.pixels.empty()) continue;
    HeadMapRequest sibling = request;
    sibling.map = static_cast<HeadMap>(i);
    const std::string siblingKey = keyOf(sibling);
    writeMap(fileOf(siblingKey), image);
    // Each keeps the others: whoever asks for one of a look's maps asks for the rest next.
    const std::shared_ptr<const Image> shared(maps, &image);
    remembered[siblingKey] = shared;
    if (sibling.map == request.map) asked = shared;
  }
  return asked;
}

}  // namespace dermis
