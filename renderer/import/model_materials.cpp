#include "import/model_materials.h"

#include <assimp/GltfMaterial.h>
#include <assimp/material.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "core/base/lower_case.h"
#include "core/material/parameter_table.h"
#include "import/material_textures.h"
#include "import/text.h"

namespace dermis::import {
namespace {

/// A finite number of the material, if it has the key.
template <class... Key>
std::optional<float> number(const aiMaterial& source, Key... key) {
  float value = 0.0F;
  if (source.Get(key..., value) != aiReturn_SUCCESS || !std::isfinite(value)) return std::nullopt;
  return value;
}

template <class... Key>
std::optional<glm::vec3> colour(const aiMaterial& source, Key... key) {
  aiColor4D value;
  if (source.Get(key..., value) != aiReturn_SUCCESS) return std::nullopt;
  const glm::vec3 rgb(value.r, value.g, value.b);
  if (!std::isfinite(rgb.x) || !std::isfinite(rgb.y) || !std::isfinite(rgb.z)) return std::nullopt;
  return rgb;
}

/// Perceptual roughness of a Blinn-Phong exponent n: α² = 2/(n + 2) (Walter et al. 2007, "Microfacet Models for
/// Refraction", §5.2), and roughness = √α.
float roughnessOfExponent(float exponent) { return std::pow(2.0F / (std::max(exponent, 0.0F) + 2.0F), 0.25F); }

bool looksLikeNormalMap(const aiMaterial& source, aiTextureType type) {
  aiString path;
  if (source.GetTexture(type, 0, &path) != aiReturn_SUCCESS) return false;
  const std::string name = lowerCase(std::filesystem::path(path.C_Str()).stem().string());
  for (const char* word : {"normal", "nrm", "_nor", "-nor", "nmap", "tangent"})
    if (name.find(word) != std::string::npos) return true;
  return false;
}

void readColours(const aiMaterial& source, Material& material) {
  MaterialParameters& p = material.parameters;
  p.baseAlbedo.rgb =
      colour(source, AI_MATKEY_BASE_COLOR).value_or(colour(source, AI_MATKEY_COLOR_DIFFUSE).value_or(glm::vec3(0.8F)));
  p.baseMetallic = number(source, AI_MATKEY_METALLIC_FACTOR).value_or(0.0F);
  if (const auto roughness = number(source, AI_MATKEY_ROUGHNESS_FACTOR))
    p.specularPerceptualRoughness = *roughness;
  else if (const auto glossiness = number(source, AI_MATKEY_GLOSSINESS_FACTOR))
    p.specularPerceptualRoughness = 1.0F - *glossiness;
  else {
    // An exponent of 0 is what readers put where the file says nothing.
    constexpr float kUnsaid = 0.5F;
    const float exponent = number(source, AI_MATKEY_SHININESS).value_or(0.0F);
    p.specularPerceptualRoughness = exponent > 0.0F ? roughnessOfExponent(exponent) : kUnsaid;
  }

  // Emission brighter than 1 is a colour and a strength.
  glm::vec3 emissive = colour(source, AI_MATKEY_COLOR_EMISSIVE).value_or(glm::vec3(0.0F));
  float strength = number(source, AI_MATKEY_EMISSIVE_INTENSITY).value_or(1.0F);
  if (const float peak = std::max({emissive.x, emissive.y, emissive.z}); peak > 1.0F) {
    emissive /= peak;
    strength *= peak;
  }
  p.metallicRoughnessEmissive.rgb = emissive;
  p.metallicRoughnessEmissiveStrength = strength;
}

void readAlpha(const aiMaterial& source, const TextureContext& context, Material& material, Warnings& warnings) {
  MaterialParameters& p = material.parameters;
  p.metallicRoughnessOpacity = number(source, AI_MATKEY_OPACITY).value_or(1.0F);
  p.metallicRoughnessAlphaCutoff = number(source, AI_MATKEY_GLTF_ALPHACUTOFF).value_or(0.5F);
  int twoSided = 0;
  p.metallicRoughnessDoubleSided = source.Get(AI_MATKEY_TWOSIDED, twoSided) == aiReturn_SUCCESS && twoSided != 0;

  aiString mode;
  if (source.Get(AI_MATKEY_GLTF_ALPHAMODE, mode) == aiReturn_SUCCESS) {
    const std::string word = mode.C_Str();
    p.metallicRoughnessAlphaMode = word == "BLEND"  ? AlphaMode::Blend
                                   : word == "MASK" ? AlphaMode::Mask
                                                    : AlphaMode::Opaque;
  } else if (p.metallicRoughnessOpacity < 1.0F) {
    p.metallicRoughnessAlphaMode = AlphaMode::Blend;
  }
  // Light that passes through isn't traced here: the surface is blended instead, or an eye behind its cornea is lost.
  if (const auto transmission = number(source, AI_MATKEY_TRANSMISSION_FACTOR);
      transmission && *transmission > 0.0F && p.metallicRoughnessAlphaMode == AlphaMode::Opaque) {
    constexpr float kGlassOpacity = 0.1F;
    p.metallicRoughnessAlphaMode = AlphaMode::Blend;
    p.metallicRoughnessOpacity = std::max(kGlassOpacity, 1.0F - *transmission);
    warnings.push_back(fmt::format(
        "{}: material \"{}\" lets light through, which is shown as blending; for a cornea choose the lens model",
        context.fileName, material.name));
  }
}

void readTextures(const aiMaterial& source, const TextureContext& context, TextureFinder& finder, Material& material) {
  MaterialParameters& p = material.parameters;
  finder.bind(source, {aiTextureType_BASE_COLOR, aiTextureType_DIFFUSE}, material, TextureSlot::Albedo);
  finder.bind(source, {aiTextureType_EMISSIVE, aiTextureType_EMISSION_COLOR}, material, TextureSlot::Emissive);

  // glTF packs metallic into blue and roughness into green (glTF 2.0, §5.22.5), occlusion into red (§5.19).
  const TextureChannel metallic = context.gltf ? TextureChannel::B : TextureChannel::R;
  const TextureChannel roughness = context.gltf ? TextureChannel::G : TextureChannel::R;
  if (context.gltf) {
    finder.bind(source, {aiTextureType_METALNESS, aiTextureType_UNKNOWN}, material, TextureSlot::Metallic, metallic);
    finder.bind(source, {aiTextureType_DIFFUSE_ROUGHNESS, aiTextureType_UNKNOWN}, material, TextureSlot::Roughness,
                roughness);
  } else {
    finder.bind(source, {aiTextureType_METALNESS}, material, TextureSlot::Metallic, metallic);
    finder.bind(source, {aiTextureType_DIFFUSE_ROUGHNESS}, material, TextureSlot::Roughness, roughness);
    // Made for other shading models, kept for whoever switches.
    finder.bind(source, {aiTextureType_SPECULAR}, material, TextureSlot::Specular);
  }
  finder.bind(source, {aiTextureType_AMBIENT_OCCLUSION, aiTextureType_LIGHTMAP}, material, TextureSlot::Occlusion);
  if (const auto strength = number(source, AI_MATKEY_GLTF_TEXTURE_STRENGTH(aiTextureType_LIGHTMAP, 0)))
    p.occlusionStrength = *strength;

  // MTL's "bump" often names a normal map.
  const bool bumpIsNormal = looksLikeNormalMap(source, aiTextureType_HEIGHT);
  if (!finder.bind(source, {aiTextureType_NORMALS, aiTextureType_NORMAL_CAMERA}, material, TextureSlot::Normal) &&
      bumpIsNormal)
    finder.bind(source, {aiTextureType_HEIGHT}, material, TextureSlot::Normal);
  if (const auto scale = number(source, AI_MATKEY_GLTF_TEXTURE_SCALE(aiTextureType_NORMALS, 0)))
    p.surfaceNormalStrength = *scale;
  finder.bind(source, {aiTextureType_DISPLACEMENT}, material, TextureSlot::Displacement);
  if (!material.texture(TextureSlot::Displacement).present() && !bumpIsNormal)
    finder.bind(source, {aiTextureType_HEIGHT}, material, TextureSlot::Displacement);
}

void keepInRange(MaterialParameters& parameters) {
  for (const ParameterRow& row : parameterTable()) {
    if (!row.usedBy(ShadingModel::MetallicRoughness)) continue;
    bool clamped = false;
    const ParameterValue value = clampToHardRange(row, row.get(parameters), &clamped);
    if (clamped) row.set(parameters, value);
  }
}

/// The name for people: cleaned; what Assimp calls a missing material is "default".
std::string slotName(const aiMaterial& source) {
  aiString given;
  if (source.Get(AI_MATKEY_NAME, given) != aiReturn_SUCCESS) return "default";
  const std::string name = phrase(given.C_Str(), 120);
  return name.empty() || name == AI_DEFAULT_MATERIAL_NAME ? "default" : name;
}

}  // namespace

void addSlots(Model& model, const aiScene& scene, const std::vector<unsigned>& materials,
              const TextureContext& context) {
  TextureFinder finder(model, scene, context);
  std::set<std::string> taken;
  for (const unsigned index : materials) {
    static const aiMaterial kNone;
    const bool known = index < scene.mNumMaterials && scene.mMaterials[index] != nullptr;
    const aiMaterial& source = known ? *scene.mMaterials[index] : kNone;

    ModelSlot slot;
    const std::string name = slotName(source);
    slot.name = name;
    for (int n = 2; !taken.insert(slot.name).second; ++n) slot.name = fmt::format("{}.{}", name, n);

    slot.imported.name = slot.name;
    slot.imported.model = ShadingModel::MetallicRoughness;
    readColours(source, slot.imported);
    readAlpha(source, context, slot.imported, model.warnings);
    readTextures(source, context, finder, slot.imported);
    keepInRange(slot.imported.parameters);
    model.slots.push_back(std::move(slot));
  }
}

}  // namespace dermis::import
