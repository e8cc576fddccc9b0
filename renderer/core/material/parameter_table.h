// The parameter table: one row for each material parameter. Everything else about a parameter follows from its row.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/material/material.h"

namespace dermis {

enum class ParameterType { Float, Vec2, Vec3, Colour, OptionalColour, Enum, Bool, Gaussians };
[[nodiscard]] std::string_view toString(ParameterType type);

/// What must be redone when a parameter changes.
enum class Invalidates { Uniforms, DiffusionKernel, Program, Textures };
[[nodiscard]] std::string_view toString(Invalidates what);

/// The index of an enum parameter's word.
struct EnumValue {
  int index = 0;
  bool operator==(const EnumValue&) const = default;
};

using ParameterValue =
    std::variant<float, glm::vec2, glm::vec3, Colour, OptionalColour, EnumValue, bool, GaussianTable>;

struct ParameterRow {
  std::string_view id;     ///< dotted: "specular.perceptual_roughness"
  std::string_view label;  ///< for people: "Roughness"
  std::string_view group;  ///< for people: "Specular"
  ParameterType type = ParameterType::Float;
  std::string_view unit;                 ///< "mm", "mm²", "×" or empty
  float hardMin = 0.0F, hardMax = 1.0F;  ///< a value outside is clamped with a warning (each component)
  float softMin = 0.0F, softMax = 1.0F;  ///< sizes the slider only
  Invalidates invalidates = Invalidates::Uniforms;
  ShadingModelMask models = 0;
  std::string_view sentence;                ///< what it means
  std::string_view source;                  ///< paper or system a default or range comes from
  std::span<const std::string_view> words;  ///< an enum's words, in order
  std::optional<TextureSlot> map;  ///< the value multiplies this map (and counts as 1 where absent beside a map)

  std::size_t std140Offset = 0;  ///< bytes in MaterialBlock
  std::string glslName;          ///< "specular_perceptual_roughness": member of MaterialBlock

  ParameterValue (*get)(const MaterialParameters&) = nullptr;
  void (*set)(MaterialParameters&, const ParameterValue&) = nullptr;  ///< the alternative must match `type`

  [[nodiscard]] bool usedBy(ShadingModel model) const { return (models & maskOf(model)) != 0; }
  [[nodiscard]] ParameterValue defaultValue() const { return get(MaterialParameters{}); }
};

/// All rows, in table order (the order of files, panels and documentation).
[[nodiscard]] std::span<const ParameterRow> parameterTable();
[[nodiscard]] const ParameterRow* findParameter(std::string_view id);

/// The value brought into the hard range; `clamped` says whether anything changed. A non-finite number becomes the
/// lowest.
[[nodiscard]] ParameterValue clampToHardRange(const ParameterRow& row, const ParameterValue& value,
                                              bool* clamped = nullptr);

/// Writes the value with the coupling the table states: editing specular.ior sets specular.f0 to null.
void setParameter(MaterialParameters& parameters, const ParameterRow& row, const ParameterValue& value);

/// GLSL declaration `layout(std140, binding = 1) uniform MaterialBlock { … } u_material;`, generated from the table.
/// float → float; vec2 → vec2; vec3 and colours → vec4 (w = 1; for an optional colour w = 0 says null);
/// enum and bool → int; Gaussians → vec4[8] (variance, weights) and int NAME_count.
[[nodiscard]] const std::string& materialBlockGlsl();
/// Size of that block in bytes.
[[nodiscard]] std::size_t materialBlockSize();
/// The block's bytes for one material.
[[nodiscard]] std::vector<std::byte> packMaterialBlock(const MaterialParameters& parameters);

}  // namespace dermis
