// What a material is: its shading model, its parameters with their defaults, its maps.
//
// A parameter is declared once: the member here with its default, and its row in parameter_table.cpp. Panel, JSON,
// std140 block, GLSL text, --set and docs/parameters.md follow from the row.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "core/material/shading_model.h"
#include "core/material/texture_slot.h"

namespace dermis {

/// Linear Rec.709, each channel 0..1 for reflectances.
struct Colour {
  glm::vec3 rgb{0.0F};
  bool operator==(const Colour&) const = default;
};
using OptionalColour = std::optional<Colour>;

/// One Gaussian of a diffusion profile: variance in mm² and its share per channel.
struct GaussianTerm {
  float variance = 0.0F;
  glm::vec3 weight{0.0F};
  bool operator==(const GaussianTerm&) const = default;
};
inline constexpr std::size_t kMaxGaussians = 8;
/// Up to eight terms; those past `count` are zero.
struct GaussianTable {
  std::array<GaussianTerm, kMaxGaussians> terms{};
  int count = 0;
  bool operator==(const GaussianTable&) const = default;
};

enum class RadiusReading { DiffuseMeanFreePath, MeanFreePath, BurleyD };
enum class DiffusionFamily { Burley, Gaussians };
enum class ThicknessSource { Map, Mesh, Shadow };
enum class LabGeometry { One, Smith, CookTorrance };
enum class AlphaMode { Opaque, Mask, Blend };

struct MaterialParameters {
  Colour baseAlbedo{{0.80F, 0.60F, 0.50F}};
  float baseMetallic = 0.0F;

  float specularIor = 1.40F;
  OptionalColour specularF0 = std::nullopt;
  float specularPerceptualRoughness = 0.45F;
  glm::vec2 specularLobeScale{0.75F, 1.30F};
  float specularLobeMix = 0.85F;
  float specularIntensity = 1.0F;
  float specularCavity = 1.0F;

  float subsurfaceWeight = 1.0F;
  Colour subsurfaceColor{{1.0F, 1.0F, 1.0F}};
  float subsurfaceScale = 1.0F;
  glm::vec3 subsurfaceRadiusMm{3.67F, 1.37F, 0.68F};
  RadiusReading subsurfaceRadiusReading = RadiusReading::DiffuseMeanFreePath;
  DiffusionFamily subsurfaceProfile = DiffusionFamily::Burley;
  float subsurfaceAlbedoMix = 0.5F;
  Colour subsurfaceBoundaryColor{{1.0F, 1.0F, 1.0F}};
  GaussianTable subsurfaceGaussians{{{{0.0064F, {0.233F, 0.455F, 0.649F}},
                                      {0.0484F, {0.100F, 0.336F, 0.344F}},
                                      {0.187F, {0.118F, 0.198F, 0.0F}},
                                      {0.567F, {0.113F, 0.007F, 0.007F}},
                                      {1.99F, {0.358F, 0.004F, 0.0F}},
                                      {7.41F, {0.078F, 0.0F, 0.0F}}}},
                                    6};

  float transmissionWeight = 1.0F;
  Colour transmissionTint{{1.0F, 1.0F, 1.0F}};
  ThicknessSource transmissionThicknessSource = ThicknessSource::Mesh;
  float transmissionThicknessMinMm = 0.0F;
  float transmissionThicknessMaxMm = 20.0F;
  float transmissionNormalScale = 0.08F;

  float surfaceNormalStrength = 1.0F;
  float surfaceDetailStrength = 0.0F;
  float surfaceDetailTiling = 20.0F;
  float surfaceDisplacementMm = 0.0F;
  float surfaceDisplacementMidlevel = 0.5F;

  float occlusionStrength = 1.0F;

  Colour thesisSssColor{{0.9F, 0.5F, 0.2F}};
  float thesisSssScale = 0.6F;
  float thesisThickness = 0.1F;

  LabGeometry microfacetLabGeometry = LabGeometry::Smith;

  float eyeIrisRadiusMm = 5.9F;
  float eyeIrisDepthMm = 2.5F;
  float eyeCorneaIor = 1.376F;
  float eyeCorneaPerceptualRoughness = 0.03F;
  float eyePupilRadiusMm = 1.8F;
  float eyeIrisVariation = 0.5F;
  float eyeLimbusWidthMm = 0.6F;
  float eyeLimbusDarkness = 0.5F;
  Colour eyeScleraColor{{0.80F, 0.76F, 0.72F}};
  Colour eyeIrisColor{{0.18F, 0.10F, 0.05F}};

  float lensOpacity = 0.1F;
  bool lensSeedBlending = false;

  Colour metallicRoughnessEmissive{{0.0F, 0.0F, 0.0F}};
  float metallicRoughnessEmissiveStrength = 1.0F;
  float metallicRoughnessOpacity = 1.0F;
  AlphaMode metallicRoughnessAlphaMode = AlphaMode::Opaque;
  float metallicRoughnessAlphaCutoff = 0.5F;
  bool metallicRoughnessDoubleSided = false;

  bool operator==(const MaterialParameters&) const = default;
};

/// A preset's content. Parameters of other shading models keep their values, so that switching model and back loses
/// nothing; only those of `model` are written.
struct Material {
  std::string name;
  ShadingModel model = ShadingModel::Skin;
  MaterialParameters parameters;
  TextureBindings textures;
  nlohmann::ordered_json metadata = nlohmann::ordered_json::object();  ///< "author", "notes", … as read
  nlohmann::ordered_json unknown = nlohmann::ordered_json::object();   ///< top-level keys that we don't know, kept
  nlohmann::ordered_json unknownParameters = nlohmann::ordered_json::object();  ///< the same inside "parameters"
  /// The same inside "textures": unknown slots whole, unknown keys of a known slot under its id.
  nlohmann::ordered_json unknownTextures = nlohmann::ordered_json::object();

  [[nodiscard]] const TextureBinding& texture(TextureSlot slot) const {
    return textures.at(static_cast<std::size_t>(slot));
  }
  [[nodiscard]] TextureBinding& texture(TextureSlot slot) { return textures.at(static_cast<std::size_t>(slot)); }
  bool operator==(const Material&) const = default;
};

}  // namespace dermis
