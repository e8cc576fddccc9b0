#include "core/material/shading_model.h"

#include <array>

namespace dermis {
namespace {

constexpr std::array<ShadingModelRow, 7> kModels = {{
    {ShadingModel::Skin, "skin", "Skin", "Diffusing skin under two specular lobes; what the program is for.", false},
    {ShadingModel::Thesis, "thesis", "Thesis (2024)",
     "The shader of \"Physically Based Skin rendering Using OpenGL\" (2024), as published.", false},
    {ShadingModel::Reflection, "reflection", "Reflection (lab)",
     "A mirror of the environment, encoded in the shader as the lab published it.", true},
    {ShadingModel::MicrofacetLab, "microfacet_lab", "Microfacet (lab)",
     "The lab's microfacet reflection of the environment, encoded in the shader as published.", true},
    {ShadingModel::Eye, "eye", "Eye", "Sclera that scatters, and an iris seen by refraction through the cornea.",
     false},
    {ShadingModel::Lens, "lens", "Lens", "A cornea shell: specular only, blended over what lies behind it.", false},
    {ShadingModel::MetallicRoughness, "metallic_roughness", "Metallic-roughness (glTF)",
     "glTF's material, so that a downloaded model shows as its author meant.", false},
}};

}  // namespace

std::span<const ShadingModelRow> shadingModels() { return kModels; }

const ShadingModelRow& shadingModelRow(ShadingModel model) { return kModels.at(static_cast<std::size_t>(model)); }

std::optional<ShadingModel> shadingModelFromId(std::string_view id) {
  for (const ShadingModelRow& row : kModels)
    if (row.id == id) return row.model;
  return std::nullopt;
}

}  // namespace dermis
