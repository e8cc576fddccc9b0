#include "core/builtin/head/head_look.h"

#include "core/base/file_reference.h"

namespace dermis {
namespace {

constexpr std::string_view kPrefix = "head_";

Material faceMaterial() {
  Material material;
  material.name = "Light skin";
  material.model = ShadingModel::Skin;
  // These multiply the maps.
  material.parameters.baseAlbedo = {glm::vec3(1.0F)};
  material.parameters.specularPerceptualRoughness = 1.0F;
  const auto wear = [&](TextureSlot slot, std::string_view map) {
    material.texture(slot).path = builtinReference(std::string(kPrefix) + std::string(map) + "?size=1024");
  };
  wear(TextureSlot::Albedo, "albedo");
  wear(TextureSlot::Normal, "normal");
  wear(TextureSlot::Roughness, "roughness");
  wear(TextureSlot::Cavity, "cavity");
  return material;
}

Material eyeMaterial() {
  Material material;
  material.name = "Eye";
  material.model = ShadingModel::Eye;
  material.parameters.eyeIrisColor = {{0.07F, 0.14F, 0.17F}};
  return material;
}

Material corneaMaterial() {
  Material material;
  material.name = "Cornea";
  material.model = ShadingModel::Lens;
  material.parameters.lensOpacity = 0.0F;
  return material;
}

}  // namespace

std::array<ModelSlot, 3> headSlots() {
  return {{{"face", faceMaterial()}, {"eye", eyeMaterial()}, {"lens", corneaMaterial()}}};
}

bool isHeadMap(std::string_view reference) {
  const auto name = builtinName(reference);
  return name && name->starts_with(kPrefix);
}

}  // namespace dermis
