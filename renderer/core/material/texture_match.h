// Which files of a folder are which maps of a material, by their names.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/material/texture_slot.h"

namespace dermis {

struct TextureMatch {
  TextureSlot texture = TextureSlot::Albedo;
  std::filesystem::path path;
  bool flipGreen = false;  ///< the name says DirectX
  bool invert = false;     ///< a gloss map stands for roughness
  TextureChannel channel = TextureChannel::R;
  bool operator==(const TextureMatch&) const = default;
};

/// A file that became no map, and why.
struct TextureLeftOver {
  enum class Why : std::uint8_t {
    NoMapsName,
    OtherSlot,  ///< it names another of the model's slots
    Poorer,     ///< another file is better for what this one could be
    Opacity,    ///< no material has such a map: the albedo map's alpha is opacity
  };
  std::filesystem::path path;
  Why why = Why::NoMapsName;
};

struct TextureMatches {
  std::vector<TextureMatch> maps;         ///< in the order of textureSlots(), each map once
  std::vector<TextureLeftOver> leftOver;  ///< by path
};

/// A name is split where letters meet separators, digits or capitals; resolution, bit depth and colour space are no
/// part of it ("Head_BaseColor_4k.png", "face-normal-gl.tif", "HeadRoughness.exr"). What stands last decides. A file
/// that names another of the model's slots is left over; of several files for one map the one that names `slot`, then
/// the larger, then the deeper format wins.
///
/// Packed maps give several: "_ORM", "_ARM", "_AORM", "_occlusionRoughnessMetallic" (R, G, B), "_RMA", "_MRA", "_MRAO",
/// "_metallicRoughness" (glTF: roughness in G, metal in B), "_MaskMap" (Unity: metal, occlusion, detail mask, gloss in
/// A). A file for one map alone goes before them.
[[nodiscard]] TextureMatches matchTextures(std::vector<std::filesystem::path> files, const std::string& slot,
                                           const std::vector<std::string>& allSlots);

}  // namespace dermis
