// Maps of the built-in head's skin, made in code: "builtin:head_albedo?tone=4&age=60".
#pragma once

#include <array>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/builtin/head/head.h"
#include "core/builtin/skin/skin_layers.h"
#include "core/image/image.h"

namespace dermis {

enum class HeadMap : std::uint8_t {
  Albedo,        ///< sRGB, 8 bit
  Normal,        ///< tangent space, +Y, 16 bit
  Displacement,  ///< 16 bit, 0.5 is the skin itself
  Roughness,     ///< perceptual, 8 bit
  Cavity,        ///< 8 bit, 1 where nothing is hollow
  Detail,        ///< 8 bit: how strong the finest relief is, the mask of builtin:skin_detail
  Occlusion,     ///< 8 bit, 1 in the open
  Thickness,     ///< 16 bit, 1 is kHeadThickestMm
  Region         ///< 8 bit: the weight of one region
};
inline constexpr std::size_t kHeadMapCount = 9;
/// What 1 stands for in the thickness map: the default of transmission.thickness_max_mm.
inline constexpr float kHeadThickestMm = 20.0F;
/// Between the displacement map's 0 and 1: what surface.displacement_mm must be.
inline constexpr float kHeadReliefMm = 2.0F;
inline constexpr int kHeadMapSize = 2048;
/// What 1 stands for in a relative albedo map: the "scale" of its binding.
inline constexpr float kMostRelative = 1.25F;

struct HeadMapRequest {
  HeadMap map = HeadMap::Albedo;
  skin::Look look;
  int size = kHeadMapSize;
  bool relative = false;  ///< the albedo as a factor on the tone's, over kMostRelative
  HeadRegion region = HeadRegion::Lips;
};
/// "head_albedo", "head_normal", …, each with settings as a query may follow: tone, melanin, haemoglobin, age,
/// freckles, flush, stubble, seed, size, relative (0 or 1), region. Errors: Input, a phrase that follows the reference:
/// "has no setting …".
[[nodiscard]] Result<HeadMapRequest> parseHeadMap(std::string_view name);
/// The names without settings.
[[nodiscard]] std::array<std::string_view, kHeadMapCount> headMapNames();

/// Made by `makeHeadMaps`, or taken from memory or the user's cache on disk. Thread-safe; who comes second waits.
[[nodiscard]] std::shared_ptr<const Image> headMap(const HeadMapRequest& request);

/// What is made together.
struct HeadMaps {
  std::array<Image, kHeadMapCount> images;
};
/// The albedo alone.
[[nodiscard]] Image makeHeadAlbedo(const HeadAtlas& atlas, const skin::Look& look, bool relative = false);
/// What the mesh bake knows of each vertex of the head, spread over the atlas: Occlusion or Thickness. Seconds, unless
/// the head has been drawn before. Empty where no rays can be cast.
[[nodiscard]] Image makeHeadBaked(const Head& head, HeadMap map, int size);
[[nodiscard]] Image makeHeadRegion(const HeadAtlas& atlas, HeadRegion region);
/// All that depend on age and seed; the others stay empty.
[[nodiscard]] HeadMaps makeHeadRelief(const HeadAtlas& atlas, const skin::Look& look);

}  // namespace dermis
