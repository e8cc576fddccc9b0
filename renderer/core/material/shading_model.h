// The shading models: one row each.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace dermis {

enum class ShadingModel : std::uint8_t { Skin, Thesis, Reflection, MicrofacetLab, Eye, Lens, MetallicRoughness };

struct ShadingModelRow {
  ShadingModel model;
  std::string_view id;        ///< as in files: "metallic_roughness"
  std::string_view label;     ///< for people: "Metallic-roughness (glTF)"
  std::string_view sentence;  ///< what it is for
  bool displayReferred;       ///< writes encoded values itself: its natural view is Raw
};

[[nodiscard]] std::span<const ShadingModelRow> shadingModels();
[[nodiscard]] const ShadingModelRow& shadingModelRow(ShadingModel model);
[[nodiscard]] std::optional<ShadingModel> shadingModelFromId(std::string_view id);

/// A set of shading models, as a bit mask.
using ShadingModelMask = std::uint32_t;
[[nodiscard]] constexpr ShadingModelMask maskOf(ShadingModel model) { return 1U << static_cast<unsigned>(model); }

}  // namespace dermis
