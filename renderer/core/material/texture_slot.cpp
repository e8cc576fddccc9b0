#include "core/material/texture_slot.h"

namespace dermis {

const std::array<TextureSlotRow, kTextureSlotCount>& textureSlots() {
  static constexpr std::array<TextureSlotRow, kTextureSlotCount> kRows = {{
      {TextureSlot::Albedo, "albedo", "Albedo", true, false,
       "_albedo _basecolor _base_color _diffuse _diff _color _colour _col -col"},
      {TextureSlot::Normal, "normal", "Normal", false, false, "_normal _nrm _nor _normalgl _nmap _tangent"},
      {TextureSlot::DetailNormal, "detail_normal", "Detail normal", false, false,
       "_detail_normal _detailnormal _micronormal _micro_nrm"},
      {TextureSlot::DetailMask, "detail_mask", "Detail mask", false, true, "_detail_mask _detailmask"},
      {TextureSlot::Metallic, "metallic", "Metallic", false, true, "_metallic _metalness _metal"},
      {TextureSlot::Roughness, "roughness", "Roughness", false, true, "_roughness _rough"},
      {TextureSlot::Specular, "specular", "Specular", false, true, "_specular _spec -spec"},
      {TextureSlot::Cavity, "cavity", "Cavity", false, true, "_cavity _cav"},
      {TextureSlot::Occlusion, "occlusion", "Occlusion", false, true, "_occlusion _ao _ambientocclusion"},
      {TextureSlot::Displacement, "displacement", "Displacement", false, true, "_displacement _disp _height"},
      {TextureSlot::Thickness, "thickness", "Thickness", false, true, "_thickness _thick"},
      {TextureSlot::Subsurface, "subsurface", "Subsurface", false, true, "_subsurface _sss _scatter _scattering"},
      {TextureSlot::Emissive, "emissive", "Emissive", true, false, "_emissive _emission _emit"},
  }};
  return kRows;
}

const TextureSlotRow& textureSlotRow(TextureSlot slot) { return textureSlots().at(static_cast<std::size_t>(slot)); }

std::optional<TextureSlot> textureSlotFromId(std::string_view id) {
  for (const TextureSlotRow& row : textureSlots())
    if (row.id == id) return row.slot;
  return std::nullopt;
}

namespace {
constexpr std::array<std::string_view, 5> kChannels = {"r", "g", "b", "a", "luminance"};
}

std::string_view toString(TextureChannel channel) { return kChannels.at(static_cast<std::size_t>(channel)); }

std::optional<TextureChannel> textureChannelFromId(std::string_view id) {
  for (std::size_t i = 0; i < kChannels.size(); ++i)
    if (kChannels.at(i) == id) return static_cast<TextureChannel>(i);
  return std::nullopt;
}

}  // namespace dermis
