// Head maps in memory, and on disk by image_cache.h.
#include <fmt/format.h>

#include <map>
#include <mutex>

#include "core/base/number_format.h"
#include "core/builtin/image_cache.h"
#include "core/builtin/skin/head_maps.h"
#include "generated/skin_source_hash.h"

namespace dermis {
namespace {

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
  if (std::optional<Image> cached = readCachedImage({kSkinSourceHash, key}, name)) {
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
    writeCachedImage({kSkinSourceHash, siblingKey}, image);
    // Each keeps the others: whoever asks for one of a look's maps asks for the rest next.
    const std::shared_ptr<const Image> shared(maps, &image);
    remembered[siblingKey] = shared;
    if (sibling.map == request.map) asked = shared;
  }
  return asked;
}

}  // namespace dermis
