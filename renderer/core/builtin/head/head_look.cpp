#include "core/builtin/head/head_look.h"

#include "core/base/file_reference.h"

namespace dermis {
namespace {

/// Tiles of builtin:skin_detail across the atlas: 40 mm each.
constexpr float kHeadDetailTiling = 15.0F;

/// Less than the ears, more than what a ray measures at the edge of a lid or in the slit between the lips.
constexpr float kThinnestMm = 2.5F;

constexpr std::string_view kPrefix = "head_";

Material faceMaterial() {
  Material material;
  material.name = "Light skin";
  material.model = ShadingModel::Skin;
  // These multiply the maps.
  material.parameters.baseAlbedo = {glm::vec3(1.0F)};
  material.parameters.specularPerceptualRoughness = 1.0F;
  const auto wear = [&](TextureSlot slot, std::string_view map) {
    const std::string_view size = slot == TextureSlot::Albedo ? "?size=2048" : "?size=1024";
    material.texture(slot).path = builtinReference(std::string(kPrefix) + std::string(map) + std::string(size));
  };
  wear(TextureSlot::Albedo, "albedo");
  wear(TextureSlot::Normal, "normal");
  wear(TextureSlot::Roughness, "roughness");
  wear(TextureSlot::Cavity, "cavity");
  wear(TextureSlot::DetailMask, "detail");
  material.texture(TextureSlot::DetailNormal).path = builtinReference("skin_detail");
  material.parameters.surfaceDetailStrength = 1.0F;
  material.parameters.transmissionThicknessMinMm = kThinnestMm;
  material.parameters.surfaceDetailTiling = kHeadDetailTiling;
  return material;
}

Material eyeMaterial() {
  Material material;
  material.name = "Eye";
  material.model = ShadingModel::Eye;
  material.parameters.eyeIrisColor = {{0.075F, 0.13F, 0.15F}};
  material.parameters.eyeScleraColor = {{0.68F, 0.61F, 0.565F}};
  return material;
}

Material corneaMaterial() {
  Material material;
  material.name = "Cornea";
  material.model = ShadingModel::Lens;
  material.parameters.lensOpacity = 0.0F;
  return material;
}

Material hairMaterial() {
  Material material;
  material.name = "Brown hair";
  material.model = ShadingModel::MetallicRoughness;
  material.parameters.baseAlbedo = {{0.050F, 0.030F, 0.019F}};
  material.parameters.baseMetallic = 0.0F;
  material.parameters.specularPerceptualRoughness = 0.7F;
  return material;
}

}  // namespace

std::array<ModelSlot, 4> headSlots() {
  return {{{"face", faceMaterial()}, {"eye", eyeMaterial()}, {"lens", corneaMaterial()}, {"hair", hairMaterial()}}};
}

bool isHeadMap(std::string_view reference) {
  const auto name = builtinName(reference);
  return name && name->starts_with(kPrefix);
}

}  // namespace dermis
