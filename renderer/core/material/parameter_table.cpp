#include "core/material/parameter_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

namespace dermis {
namespace {

template <class T>
struct TypeOf;
template <>
struct TypeOf<float> {
  static constexpr auto kType = ParameterType::Float;
};
template <>
struct TypeOf<glm::vec2> {
  static constexpr auto kType = ParameterType::Vec2;
};
template <>
struct TypeOf<glm::vec3> {
  static constexpr auto kType = ParameterType::Vec3;
};
template <>
struct TypeOf<Colour> {
  static constexpr auto kType = ParameterType::Colour;
};
template <>
struct TypeOf<OptionalColour> {
  static constexpr auto kType = ParameterType::OptionalColour;
};
template <>
struct TypeOf<bool> {
  static constexpr auto kType = ParameterType::Bool;
};
template <>
struct TypeOf<GaussianTable> {
  static constexpr auto kType = ParameterType::Gaussians;
};
template <class T>
requires std::is_enum_v<T>
struct TypeOf<T> {
  static constexpr auto kType = ParameterType::Enum;
};

/// A row about to be written: the member gives type and accessors, the chained calls the rest.
struct Builder {
  ParameterRow row;

  Builder&& hard(float lowest, float highest) && {
    row.hardMin = row.softMin = lowest;
    row.hardMax = row.softMax = highest;
    return std::move(*this);
  }
  Builder&& soft(float lowest, float highest) && {
    row.softMin = lowest;
    row.softMax = highest;
    return std::move(*this);
  }
  Builder&& unit(std::string_view text) && {
    row.unit = text;
    return std::move(*this);
  }
  Builder&& kernel() && {
    row.invalidates = Invalidates::DiffusionKernel;
    return std::move(*this);
  }
  Builder&& map(TextureSlot slot) && {
    row.map = slot;
    return std::move(*this);
  }
  Builder&& words(std::span<const std::string_view> list) && {
    row.words = list;
    return std::move(*this);
  }
  Builder&& says(std::string_view text) && {
    row.sentence = text;
    return std::move(*this);
  }
  Builder&& from(std::string_view text) && {
    row.source = text;
    return std::move(*this);
  }
};

template <auto Member>
Builder row(std::string_view id, std::string_view label, std::string_view group, ShadingModelMask models) {
  using T = std::remove_cvref_t<decltype(std::declval<MaterialParameters>().*Member)>;
  Builder b;
  b.row.id = id;
  b.row.label = label;
  b.row.group = group;
  b.row.models = models;
  b.row.type = TypeOf<T>::kType;
  b.row.glslName = std::string(id);
  std::replace(b.row.glslName.begin(), b.row.glslName.end(), '.', '_');
  if constexpr (std::is_enum_v<T>) {
    b.row.get = [](const MaterialParameters& p) { return ParameterValue(EnumValue{static_cast<int>(p.*Member)}); };
    b.row.set = [](MaterialParameters& p, const ParameterValue& v) {
      p.*Member = static_cast<T>(std::get<EnumValue>(v).index);
    };
  } else {
    b.row.get = [](const MaterialParameters& p) { return ParameterValue(std::in_place_type<T>, p.*Member); };
    b.row.set = [](MaterialParameters& p, const ParameterValue& v) { p.*Member = std::get<T>(v); };
  }
  return b;
}

constexpr ShadingModelMask kSkin = maskOf(ShadingModel::Skin);
constexpr ShadingModelMask kThesis = maskOf(ShadingModel::Thesis);
constexpr ShadingModelMask kLab = maskOf(ShadingModel::MicrofacetLab);
constexpr ShadingModelMask kEye = maskOf(ShadingModel::Eye);
constexpr ShadingModelMask kLens = maskOf(ShadingModel::Lens);
constexpr ShadingModelMask kGltf = maskOf(ShadingModel::MetallicRoughness);

constexpr std::array<std::string_view, 3> kReadingWords = {"diffuse_mean_free_path", "mean_free_path", "burley_d"};
constexpr std::array<std::string_view, 2> kFamilyWords = {"burley", "gaussians"};
constexpr std::array<std::string_view, 3> kThicknessWords = {"map", "mesh", "shadow"};
constexpr std::array<std::string_view, 3> kGeometryWords = {"one", "smith", "cook_torrance"};
constexpr std::array<std::string_view, 3> kAlphaWords = {"opaque", "mask", "blend"};

constexpr std::string_view kThesisSource = "Physically Based Skin rendering Using OpenGL (2024)";

std::vector<ParameterRow> buildRows() {
  using P = MaterialParameters;
  std::vector<Builder> b;
  // clang-format off
  b.push_back(row<&P::baseAlbedo>("base.albedo", "Albedo", "Base", kSkin | kThesis | kGltf).hard(0, 1).map(TextureSlot::Albedo).kernel()
    .says("Share of the light entering the surface that leaves it again, per channel; metals use it as F0.")
    .from("Mid skin; close to the light-skin albedos of Donner & Jensen 2006"));
  b.push_back(row<&P::baseMetallic>("base.metallic", "Metallic", "Base", kSkin | kThesis | kGltf).hard(0, 1).map(TextureSlot::Metallic)
    .says("0 is a dielectric; 1 is a metal that reflects with the albedo and has no diffuse light.").from("Seed; glTF 2.0"));

  b.push_back(row<&P::specularIor>("specular.ior", "IOR", "Specular", kSkin | kLab | kEye).hard(1, 3).soft(1.3F, 1.6F)
    .says("Index of refraction of the surface; F0 = ((n − 1)/(n + 1))². Editing it makes F0 follow it again.")
    .from("1.40 (F0 0.028): Donner & Jensen 2006; HDRP's mean of skin"));
  b.push_back(row<&P::specularF0>("specular.f0", "Fresnel F0", "Specular", kSkin | kLab | kEye).hard(0, 1).soft(0.02F, 0.08F)
    .says("Reflectance at normal incidence. Null follows the IOR; any value wins over it.")
    .from("Lab: gold (1.00, 0.71, 0.29), silver (0.95, 0.93, 0.88)"));
  b.push_back(row<&P::specularPerceptualRoughness>("specular.perceptual_roughness", "Roughness", "Specular", kSkin | kThesis | kLab | kEye | kGltf)
    .hard(0.02F, 1).soft(0.2F, 0.7F).map(TextureSlot::Roughness)
    .says("Perceptual roughness a; the width of the microfacet distribution is alpha = a².").from("Burley 2012; skin lies in 0.3 to 0.6"));
  b.push_back(row<&P::specularLobeScale>("specular.lobe_scale", "Lobe scale", "Specular", kSkin | kEye).hard(0.05F, 3).soft(0.5F, 1.5F).unit("×")
    .says("Roughness of the first and second specular lobe as multiples of the roughness, each clamped to 0.02..1.").from("Unreal Engine subsurface profile"));
  b.push_back(row<&P::specularLobeMix>("specular.lobe_mix", "Lobe mix", "Specular", kSkin | kEye).hard(0, 1)
    .says("Share of the second lobe: (1 − m)·lobe 0 + m·lobe 1.").from("Unreal Engine subsurface profile"));
  b.push_back(row<&P::specularIntensity>("specular.intensity", "Intensity", "Specular", kSkin | kThesis | kEye).hard(0, 2).map(TextureSlot::Specular).unit("×")
    .says("Multiplies what the specular lobes reflect; in `thesis` it is the published specular value.").from("Seed"));
  b.push_back(row<&P::specularCavity>("specular.cavity", "Cavity", "Specular", kSkin | kEye).hard(0, 1).map(TextureSlot::Cavity)
    .says("How much of the specular reflection survives in pores and creases; multiplies the cavity map.").from("Jimenez & von der Pahlen 2013, Next-Generation Character Rendering"));

  b.push_back(row<&P::subsurfaceWeight>("subsurface.weight", "Weight", "Subsurface", kSkin).hard(0, 1).map(TextureSlot::Subsurface)
    .says("How much of the diffuse light spreads below the surface; the rest leaves where it entered (Lambert).").from("OpenPBR Surface"));
  b.push_back(row<&P::subsurfaceColor>("subsurface.color", "Colour", "Subsurface", kSkin).hard(0, 1).kernel()
    .says("Multiplies the diffusion radius per channel.").from("Seed (\"SSS colour\")"));
  b.push_back(row<&P::subsurfaceScale>("subsurface.scale", "Scale", "Subsurface", kSkin).hard(0, 100).soft(0, 4).unit("×").kernel()
    .says("Multiplies every length of the diffusion profile.").from("Seed (\"SSS scale\")"));
  b.push_back(row<&P::subsurfaceRadiusMm>("subsurface.radius_mm", "Radius", "Subsurface", kSkin).hard(0, 200).soft(0, 10).unit("mm").kernel()
    .says("Diffusion length per channel; what it measures is said by the radius reading.").from("1/σ_tr of \"skin1\", Jensen et al. 2001"));
  b.push_back(row<&P::subsurfaceRadiusReading>("subsurface.radius_reading", "Radius reading", "Subsurface", kSkin).words(kReadingWords).kernel()
    .says("What the radius is: 1/σ_tr, the reduced mean free path 1/σ_t′, or Burley's d itself.").from("Christensen & Burley 2015"));
  b.push_back(row<&P::subsurfaceProfile>("subsurface.profile", "Profile", "Subsurface", kSkin).words(kFamilyWords).kernel()
    .says("Family of the diffusion profile: Burley's normalised diffusion or a sum of Gaussians.").from("Christensen & Burley 2015; d'Eon & Luebke 2007"));
  b.push_back(row<&P::subsurfaceAlbedoMix>("subsurface.albedo_mix", "Albedo mix", "Subsurface", kSkin).hard(0, 1)
    .says("Share m of the albedo applied before diffusion (albedo^m), the rest after it; 0 keeps texture detail sharp.").from("d'Eon & Luebke 2007, GPU Gems 3 ch. 14"));
  b.push_back(row<&P::subsurfaceBoundaryColor>("subsurface.boundary_color", "Boundary colour", "Subsurface", kSkin).hard(0, 1).kernel()
    .says("Tint of light that would have come from beyond the boundary of this material.").from("Unreal Engine subsurface profile"));
  b.push_back(row<&P::subsurfaceGaussians>("subsurface.gaussians", "Gaussians", "Subsurface", kSkin).hard(0, 400).unit("mm²").kernel()
    .says("Rows of variance (mm²) and red, green, blue weights of the sum of Gaussians; up to eight.").from("d'Eon & Luebke 2007, GPU Gems 3 ch. 14, fig. 14-13"));

  b.push_back(row<&P::transmissionWeight>("transmission.weight", "Weight", "Transmission", kSkin).hard(0, 1)
    .says("How much of the light on the far side shows through thin parts.").from("Jimenez et al. 2010"));
  b.push_back(row<&P::transmissionTint>("transmission.tint", "Tint", "Transmission", kSkin).hard(0, 1)
    .says("Multiplies the transmitted light.").from("Unreal Engine subsurface profile"));
  b.push_back(row<&P::transmissionThicknessSource>("transmission.thickness_source", "Thickness source", "Transmission", kSkin).words(kThicknessWords)
    .says("Where thickness is read: a map, the mesh by ray casting, or the light's shadow map.").from("HDRP; Jimenez et al. 2010"));
  b.push_back(row<&P::transmissionThicknessMinMm>("transmission.thickness_min_mm", "Thickness min", "Transmission", kSkin).hard(0, 500).soft(0, 50).unit("mm")
    .says("Thickness where the map is 0.").from("HDRP thickness remap"));
  b.push_back(row<&P::transmissionThicknessMaxMm>("transmission.thickness_max_mm", "Thickness max", "Transmission", kSkin).hard(0, 500).soft(0, 50).unit("mm").map(TextureSlot::Thickness)
    .says("Thickness where the map is 1; the thickness everywhere where there is no map.").from("Seed (\"thickness\")"));
  b.push_back(row<&P::transmissionNormalScale>("transmission.normal_scale", "Normal scale", "Transmission", kSkin).hard(0, 5).soft(0, 1).unit("mm")
    .says("How far the point is moved inwards along its normal before it looks up the thickness.").from("Unreal Engine; Jimenez et al. 2010"));

  b.push_back(row<&P::surfaceNormalStrength>("surface.normal_strength", "Normal strength", "Surface", kSkin | kEye | kGltf).hard(0, 10).soft(0, 2).unit("×")
    .says("Multiplies the slope of the normal map.").from("glTF 2.0 normalTexture.scale"));
  b.push_back(row<&P::surfaceDetailStrength>("surface.detail_strength", "Detail strength", "Surface", kSkin).hard(0, 10).soft(0, 2).unit("×")
    .says("Multiplies the slope of the tiling detail normal.").from("HDRP detail map"));
  b.push_back(row<&P::surfaceDetailTiling>("surface.detail_tiling", "Detail tiling", "Surface", kSkin).hard(0, 1000).soft(1, 60).unit("×")
    .says("How often the detail normal repeats over the UV square.").from("HumanShaders tiles pores 25 to 60 times"));
  b.push_back(row<&P::surfaceDisplacementMm>("surface.displacement_mm", "Displacement", "Surface", kSkin).hard(-20, 20).soft(-2, 2).unit("mm").map(TextureSlot::Displacement)
    .says("Height along the normal between the map's 0 and 1.").from("Seed"));
  b.push_back(row<&P::surfaceDisplacementMidlevel>("surface.displacement_midlevel", "Displacement midlevel", "Surface", kSkin).hard(0, 1)
    .says("Value of the displacement map that leaves the surface where it is.").from("Seed"));

  b.push_back(row<&P::occlusionStrength>("occlusion.strength", "Occlusion", "Occlusion", kSkin | kThesis | kEye | kGltf).hard(0, 1).map(TextureSlot::Occlusion)
    .says("How much the occlusion map darkens image light.").from("Seed; glTF 2.0 occlusionTexture.strength"));

  b.push_back(row<&P::thesisSssColor>("thesis.sss_color", "SSS colour", "Subsurface (thesis)", kThesis).hard(0, 1)
    .says("Colour of the published wrap term.").from(kThesisSource));
  b.push_back(row<&P::thesisSssScale>("thesis.sss_scale", "SSS scale", "Subsurface (thesis)", kThesis).hard(0, 50).soft(0, 10).unit("×")
    .says("Scale in 1 − exp(−thickness · scale · N·L).").from(kThesisSource));
  b.push_back(row<&P::thesisThickness>("thesis.thickness", "Thickness", "Subsurface (thesis)", kThesis).hard(0, 10).soft(0, 2)
    .says("Thickness in 1 − exp(−thickness · scale · N·L); it has no unit as published.").from(kThesisSource));

  b.push_back(row<&P::microfacetLabGeometry>("microfacet_lab.geometry", "Geometry term", "Microfacet", kLab).words(kGeometryWords)
    .says("Geometry factor G: none, Smith with k = α²/2 and α = 0.3, or Cook-Torrance.").from("Lab; Cook & Torrance 1982; Schlick 1994"));

  b.push_back(row<&P::eyeScleraColor>("eye.sclera_color", "Sclera colour", "Eye", kEye).hard(0, 1).map(TextureSlot::Albedo)
    .says("Albedo outside the iris; with an albedo map it tints the map there.").from("Look: a warm white"));
  b.push_back(row<&P::eyeIrisColor>("eye.iris_color", "Iris colour", "Eye", kEye).hard(0, 1).map(TextureSlot::Albedo)
    .says("Albedo of the iris; with an albedo map it tints the map there.").from("Look: a brown iris"));
  b.push_back(row<&P::eyeIrisRadiusMm>("eye.iris_radius_mm", "Iris radius", "Eye", kEye).hard(0, 30).soft(4, 8).unit("mm")
    .says("Radius of the visible iris, on an eyeball 24 mm across; a larger eyeball is taken for an enlarged one, and so for all lengths of an eye.").from("Human mean 5.9 mm (diameter 11.8 mm)"));
  b.push_back(row<&P::eyeIrisDepthMm>("eye.iris_depth_mm", "Iris depth", "Eye", kEye).hard(0, 30).soft(0, 5).unit("mm")
    .says("Distance of the iris plane behind the top of the cornea.").from("Human anterior chamber, about 2.5 to 3 mm"));
  b.push_back(row<&P::eyeCorneaIor>("eye.cornea_ior", "Cornea IOR", "Eye", kEye).hard(1, 3).soft(1.3F, 1.5F)
    .says("Index of refraction of the cornea.").from("1.376, Gullstrand's schematic eye"));
  b.push_back(row<&P::eyeCorneaPerceptualRoughness>("eye.cornea_perceptual_roughness", "Cornea roughness", "Eye", kEye).hard(0.02F, 1).soft(0.02F, 0.2F)
    .says("Perceptual roughness of the tear film over the iris; the sclera has the specular one.").from("Look: nearly a mirror"));
  b.push_back(row<&P::eyePupilRadiusMm>("eye.pupil_radius_mm", "Pupil radius", "Eye", kEye).hard(0, 30).soft(0.8F, 4).unit("mm")
    .says("Radius of the pupil where there is no albedo map; a map has its own.").from("Watson & Yellott 2012: 2 to 8 mm across; 3.6 mm indoors"));
  b.push_back(row<&P::eyeIrisVariation>("eye.iris_variation", "Iris variation", "Eye", kEye).hard(0, 1)
    .says("How much fibres and collarette vary the iris's colour where there is no albedo map.").from("Look"));
  b.push_back(row<&P::eyeLimbusWidthMm>("eye.limbus_width_mm", "Limbus width", "Eye", kEye).hard(0, 10).soft(0, 2).unit("mm")
    .says("Width of the dark ring between iris and sclera.").from("Human mean 0.5 to 1 mm"));
  b.push_back(row<&P::eyeLimbusDarkness>("eye.limbus_darkness", "Limbus darkness", "Eye", kEye).hard(0, 1)
    .says("How dark that ring is: 0 leaves it as it is, 1 is black.").from("Look"));

  b.push_back(row<&P::lensOpacity>("lens.opacity", "Opacity", "Lens", kLens).hard(0, 1)
    .says("How much of what lies behind the lens its own black covers; its reflection is added whole.").from("Seed"));
  b.push_back(row<&P::lensSeedBlending>("lens.seed_blending", "Seed blending", "Lens", kLens)
    .says("Draws the lens the published way: depth test off, source-alpha blending.").from(kThesisSource));

  b.push_back(row<&P::metallicRoughnessEmissive>("metallic_roughness.emissive", "Emissive", "Emission", kGltf).hard(0, 1).map(TextureSlot::Emissive)
    .says("Colour of the light the surface gives off.").from("glTF 2.0"));
  b.push_back(row<&P::metallicRoughnessEmissiveStrength>("metallic_roughness.emissive_strength", "Emissive strength", "Emission", kGltf).hard(0, 100000).soft(0, 10).unit("×")
    .says("Multiplies the emissive colour into a radiance.").from("glTF KHR_materials_emissive_strength"));
  b.push_back(row<&P::metallicRoughnessOpacity>("metallic_roughness.opacity", "Opacity", "Alpha", kGltf).hard(0, 1)
    .says("Alpha of the base colour; used by the alpha modes mask and blend.").from("glTF 2.0 baseColorFactor"));
  b.push_back(row<&P::metallicRoughnessAlphaMode>("metallic_roughness.alpha_mode", "Alpha mode", "Alpha", kGltf).words(kAlphaWords)
    .says("Opaque, cut out where alpha is below the cutoff, or blended.").from("glTF 2.0"));
  b.push_back(row<&P::metallicRoughnessAlphaCutoff>("metallic_roughness.alpha_cutoff", "Alpha cutoff", "Alpha", kGltf).hard(0, 1)
    .says("Alpha below which the mask mode cuts out.").from("glTF 2.0"));
  b.push_back(row<&P::metallicRoughnessDoubleSided>("metallic_roughness.double_sided", "Double sided", "Alpha", kGltf)
    .says("Back faces are drawn, with their normal turned to the viewer.").from("glTF 2.0"));
  // clang-format on

  std::vector<ParameterRow> rows;
  rows.reserve(b.size());
  for (Builder& builder : b) rows.push_back(std::move(builder.row));
  return rows;
}

/// Alignment and size of a row's members in std140.
struct Std140 {
  std::size_t alignment, size;
};
Std140 std140Of(ParameterType type) {
  switch (type) {
    case ParameterType::Float:
    case ParameterType::Enum:
    case ParameterType::Bool:
      return {4, 4};
    case ParameterType::Vec2:
      return {8, 8};
    case ParameterType::Vec3:
    case ParameterType::Colour:
    case ParameterType::OptionalColour:
      return {16, 16};
    case ParameterType::Gaussians:
      return {16, 16 * kMaxGaussians + 4};  // the terms, then the count
  }
  return {16, 16};
}

struct Table {
  std::vector<ParameterRow> rows = buildRows();
  std::string glsl;
  std::size_t size = 0;

  Table() {
    glsl = "layout(std140, binding = 1) uniform MaterialBlock {\n";
    std::size_t offset = 0;
    for (ParameterRow& row : rows) {
      const Std140 layout = std140Of(row.type);
      offset = (offset + layout.alignment - 1) / layout.alignment * layout.alignment;
      row.std140Offset = offset;
      offset += layout.size;
      glsl += "  " + declaration(row) + "\n";
    }
    glsl += "} u_material;\n";
    size = (offset + 15) / 16 * 16;
  }

  static std::string declaration(const ParameterRow& row) {
    switch (row.type) {
      case ParameterType::Float:
        return "float " + row.glslName + ";";
      case ParameterType::Enum:
      case ParameterType::Bool:
        return "int " + row.glslName + ";";
      case ParameterType::Vec2:
        return "vec2 " + row.glslName + ";";
      case ParameterType::Gaussians:
        return "vec4 " + row.glslName + "[" + std::to_string(kMaxGaussians) + "];\n  int " + row.glslName + "_count;";
      default:
        return "vec4 " + row.glslName + ";";
    }
  }
};

const Table& table() {
  static const Table kTable;
  return kTable;
}

template <class T>
void put(std::vector<std::byte>& block, std::size_t offset, const T& value) {
  std::memcpy(block.data() + offset, &value, sizeof(T));
}

}  // namespace

std::string_view toString(ParameterType type) {
  static constexpr std::array<std::string_view, 8> kNames = {"float",          "vec2", "vec3", "colour",
                                                             "colour or null", "enum", "bool", "table"};
  return kNames.at(static_cast<std::size_t>(type));
}

std::string_view toString(Invalidates what) {
  static constexpr std::array<std::string_view, 4> kNames = {"Uniforms", "DiffusionKernel", "Program", "Textures"};
  return kNames.at(static_cast<std::size_t>(what));
}

std::span<const ParameterRow> parameterTable() { return table().rows; }

const ParameterRow* findParameter(std::string_view id) {
  for (const ParameterRow& row : table().rows)
    if (row.id == id) return &row;
  return nullptr;
}

ParameterValue clampToHardRange(const ParameterRow& row, const ParameterValue& value, bool* clamped) {
  ParameterValue result = value;
  const auto limit = [&](float& v, float lowest, float highest) {
    if (!std::isfinite(v)) v = lowest;
    v = std::clamp(v, lowest, highest);
  };
  const auto limitRow = [&](float& v) { limit(v, row.hardMin, row.hardMax); };
  const auto limitColour = [&](Colour& c) {
    for (int i = 0; i < 3; ++i) limitRow(c.rgb[i]);
  };
  switch (row.type) {
    case ParameterType::Float:
      limitRow(std::get<float>(result));
      break;
    case ParameterType::Vec2:
      for (int i = 0; i < 2; ++i) limitRow(std::get<glm::vec2>(result)[i]);
      break;
    case ParameterType::Vec3:
      for (int i = 0; i < 3; ++i) limitRow(std::get<glm::vec3>(result)[i]);
      break;
    case ParameterType::Colour:
      limitColour(std::get<Colour>(result));
      break;
    case ParameterType::OptionalColour:
      if (auto& colour = std::get<OptionalColour>(result)) limitColour(*colour);
      break;
    case ParameterType::Gaussians:
      // The hard range is the variance's; weights are shares.
      for (GaussianTerm& term : std::get<GaussianTable>(result).terms) {
        limitRow(term.variance);
        for (int i = 0; i < 3; ++i) limit(term.weight[i], 0.0F, 1.0F);
      }
      break;
    case ParameterType::Enum:
    case ParameterType::Bool:
      break;
  }
  if (clamped != nullptr) *clamped = !(result == value);
  return result;
}

void setParameter(MaterialParameters& parameters, const ParameterRow& row, const ParameterValue& value) {
  row.set(parameters, value);
  if (row.id == "specular.ior") parameters.specularF0 = std::nullopt;
}

const std::string& materialBlockGlsl() { return table().glsl; }
std::size_t materialBlockSize() { return table().size; }

std::vector<std::byte> packMaterialBlock(const MaterialParameters& parameters) {
  std::vector<std::byte> block(table().size);
  for (const ParameterRow& row : table().rows) {
    const ParameterValue value = row.get(parameters);
    const std::size_t at = row.std140Offset;
    switch (row.type) {
      case ParameterType::Float:
        put(block, at, std::get<float>(value));
        break;
      case ParameterType::Vec2:
        put(block, at, std::get<glm::vec2>(value));
        break;
      case ParameterType::Vec3:
        put(block, at, glm::vec4(std::get<glm::vec3>(value), 1.0F));
        break;
      case ParameterType::Colour:
        put(block, at, glm::vec4(std::get<Colour>(value).rgb, 1.0F));
        break;
      case ParameterType::OptionalColour: {
        const auto& colour = std::get<OptionalColour>(value);
        put(block, at, colour ? glm::vec4(colour->rgb, 1.0F) : glm::vec4(0.0F));
        break;
      }
      case ParameterType::Enum:
        put(block, at, std::get<EnumValue>(value).index);
        break;
      case ParameterType::Bool:
        put(block, at, std::get<bool>(value) ? 1 : 0);
        break;
      case ParameterType::Gaussians: {
        const auto& gaussians = std::get<GaussianTable>(value);
        for (std::size_t i = 0; i < kMaxGaussians; ++i)
          put(block, at + 16 * i, glm::vec4(gaussians.terms.at(i).variance, gaussians.terms.at(i).weight));
        put(block, at + 16 * kMaxGaussians, gaussians.count);
        break;
      }
    }
  }
  return block;
}

}  // namespace dermis
