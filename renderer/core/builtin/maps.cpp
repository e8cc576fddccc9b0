#include "core/builtin/maps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "core/base/file_reference.h"
#include "core/base/random.h"
#include "core/builtin/image_cache.h"
#include "core/builtin/skin/head_maps.h"
#include "core/builtin/skin/skin_detail.h"
#include "generated/skin_source_hash.h"

namespace dermis {

namespace {

std::byte srgbCode(float linear) {
  const float v = linear <= 0.0031308F ? 12.92F * linear : 1.055F * std::pow(linear, 1.0F / 2.4F) - 0.055F;
  return static_cast<std::byte>(std::lround(255.0F * std::clamp(v, 0.0F, 1.0F)));
}

constexpr std::string_view kFreckles = "freckles", kSkinDetail = "skin_detail";
constexpr int kEdge = 512;

/// Optical depth of melanin in spots of soft, uneven outline: most of them small and pale, few large and dark; in some
/// places of the tile they are darker than in others.
std::vector<float> freckleDepth() {
  constexpr int kFreckles = 1300;
  constexpr float kTurn = 6.2831853F;
  std::vector<float> depth(static_cast<std::size_t>(kEdge) * kEdge, 0.0F);
  Random random(2024);
  for (int i = 0; i < kFreckles; ++i) {
    const float x = random.next() * kEdge;
    const float y = random.next() * kEdge;
    const float size = random.next();
    const float radius = 1.2F + 3.4F * size * size * size;  // texels of a fifth of a millimetre
    const float crowd = 0.5F + 0.5F * std::sin(2.0F * kTurn * x / kEdge + 1.3F) * std::sin(kTurn * (y - x) / kEdge);
    const float dark = (0.15F + 0.65F * random.next()) * (0.55F + 0.45F * size) * (0.4F + 0.6F * crowd);
    const float stretch = 0.75F + 0.5F * random.next();
    const float turn = kTurn * random.next();
    const float lobes = 2.0F + std::floor(3.0F * random.next());
    const float phase = kTurn * random.next();
    const int reach = static_cast<int>(std::ceil(2.4F * radius));
    for (int v = -reach; v <= reach; ++v)
      for (int u = -reach; u <= reach; ++u) {
        const int tx = static_cast<int>(std::floor(x)) + u;
        const int ty = static_cast<int>(std::floor(y)) + v;
        const float dx = static_cast<float>(tx) + 0.5F - x;
        const float dy = static_cast<float>(ty) + 0.5F - y;
        const float along = std::cos(turn) * dx + std::sin(turn) * dy;
        const float across = std::cos(turn) * dy - std::sin(turn) * dx;
        const float angle = std::atan2(across, along);
        const float outline = radius * (1.0F + 0.18F * std::sin(lobes * angle + phase));
        const float distance = std::hypot(along * stretch, across / stretch) / outline;
        const auto wrap = [](int t) { return static_cast<std::size_t>((t % kEdge + kEdge) % kEdge); };
        depth[wrap(ty) * kEdge + wrap(tx)] += dark / (1.0F + std::exp(6.0F * (distance - 1.0F)));
      }
  }
  return depth;
}

std::shared_ptr<const Image> freckles() {
  // Melanin takes most of the blue and least of the red; how much more is chosen by eye, as size and number are.
  constexpr std::array<float, 3> kPerDepth = {0.48F, 0.78F, 1.0F};
  constexpr float kDarkest = 0.95F;
  const std::vector<float> depth = freckleDepth();
  auto image = std::make_shared<Image>();
  image->width = kEdge;
  image->height = kEdge;
  image->channels = 3;
  image->name = "builtin:freckles";
  image->pixels.reserve(depth.size() * 3);
  for (const float d : depth)
    for (const float k : kPerDepth) image->pixels.push_back(srgbCode(std::exp(-k * std::min(d, kDarkest))));
  return image;
}

/// A fifth of a second's work, wanted at every start.
std::shared_ptr<const Image> skinDetail() {
  const std::string key(kSkinDetail);
  if (auto cached = readCachedImage({kSkinSourceHash, key}, builtinReference(kSkinDetail)))
    return std::make_shared<const Image>(std::move(*cached));
  auto made = std::make_shared<const Image>(skin::makeSkinDetail());
  writeCachedImage({kSkinSourceHash, key}, *made);
  return made;
}

}  // namespace

Result<std::string_view> builtinMapId(std::string_view reference) {
  const auto name = builtinName(reference);
  if (!name) return inputError("is not a map that this program carries");
  if (name == kFreckles || name == kSkinDetail) return *name;
  if (const auto request = parseHeadMap(*name); !request) return tl::unexpected(request.error());
  return *name;
}

std::string builtinMapNames() {
  std::string names = builtinReference(kFreckles) + ", " + builtinReference(kSkinDetail);
  for (const std::string_view name : headMapNames()) names += ", " + builtinReference(name);
  return names;
}

std::shared_ptr<const Image> builtinMap(std::string_view id) {
  if (id == kFreckles) return freckles();
  if (id == kSkinDetail) return skinDetail();
  const auto request = parseHeadMap(id);
  return request ? headMap(*request) : nullptr;
}

}  // namespace dermis
