// A material's texture slots: which map, and how it is read.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace dermis {

enum class TextureSlot {
  Albedo,
  Normal,
  DetailNormal,
  DetailMask,
  Metallic,
  Roughness,
  Specular,
  Cavity,
  Occlusion,
  Displacement,
  Thickness,
  Subsurface,
  Emissive
};
inline constexpr std::size_t kTextureSlotCount = 13;

struct TextureSlotRow {
  TextureSlot slot;
  std::string_view id;        ///< as in files: "detail_normal"
  std::string_view label;     ///< for people
  bool isColour;              ///< 8-bit files are sRGB unless the slot says otherwise; data maps are linear
  bool isScalar;              ///< read through `channel`
  std::string_view suffixes;  ///< space-separated file name endings by which a folder is matched: "_albedo _col …"
};

[[nodiscard]] const std::array<TextureSlotRow, kTextureSlotCount>& textureSlots();
[[nodiscard]] const TextureSlotRow& textureSlotRow(TextureSlot slot);
[[nodiscard]] std::optional<TextureSlot> textureSlotFromId(std::string_view id);

enum class TextureChannel { R, G, B, A, Luminance };
[[nodiscard]] std::string_view toString(TextureChannel channel);
[[nodiscard]] std::optional<TextureChannel> textureChannelFromId(std::string_view id);

/// One map of a material. Absent where `path` is empty.
struct TextureBinding {
  std::string path;  ///< as written in the file; absolute once resolved, or `embedded:N`
  std::optional<std::string>
      colorSpace;  ///< "srgb", "linear", "raw" or an OCIO name; unset: by the slot and pixel type
  TextureChannel channel = TextureChannel::R;
  bool invert = false;     ///< 1 − value
  bool flipGreen = false;  ///< for normal maps that are −Y (DirectX)
  float scale = 1.0F;      ///< multiplies the value read
  std::array<float, 2> uvScale = {1.0F, 1.0F};

  [[nodiscard]] bool present() const { return !path.empty(); }
  bool operator==(const TextureBinding&) const = default;
};

using TextureBindings = std::array<TextureBinding, kTextureSlotCount>;

}  // namespace dermis
