// Which files of a folder are which maps of a material, by their names.
#pragma once

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
  bool operator==(const TextureMatch&) const = default;
};

struct TextureMatches {
  std::vector<TextureMatch> maps;               ///< in the order of textureSlots(), each map once
  std::vector<std::filesystem::path> leftOver;  ///< no map's name, another slot's file, or a poorer copy
};

/// A name is split where letters meet separators, digits or capitals; resolution, bit depth and colour space are no
/// part of it ("Head_BaseColor_4k.png", "face-normal-gl.tif", "HeadRoughness.exr"). What stands last decides. A file
/// that names another of the model's slots is left over; of several files for one map the one that names `slot`, then
/// the larger, then the deeper format wins.
[[nodiscard]] TextureMatches matchTextures(std::vector<std::filesystem::path> files, const std::string& slot,
                                           const std::vector<std::string>& allSlots);

}  // namespace dermis
