// What a rig's elements may say, declared once: from these rows follow the reader, the writer, the JSON Schema and the
// tables of docs/rigs.md.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <variant>

#include "core/base/json_fields.h"
#include "core/light_rig/light_rig.h"

namespace dermis {

using RigMember = std::variant<float RigElement::*, bool RigElement::*, glm::vec2 RigElement::*,
                               glm::vec3 RigElement::*, std::optional<float> RigElement::*,
                               std::optional<glm::vec2> RigElement::*, std::optional<glm::vec3> RigElement::*>;

/// At most one key of a group may stand in an element.
enum class RigGroup : std::uint8_t { None, Size, Amount, Colour };

struct RigField {
  std::string_view key;
  RigMember member;
  Range range;
  std::uint32_t types;  ///< bit 1 << type for each type that uses it
  RigGroup group;
  std::string_view sentence;

  [[nodiscard]] bool usedBy(RigElementType type) const { return (types >> static_cast<unsigned>(type) & 1U) != 0U; }
};
[[nodiscard]] std::span<const RigField> rigFields();

struct RigTypeRow {
  std::string_view id;
  std::string_view sentence;
};
/// In the order of RigElementType.
[[nodiscard]] std::span<const RigTypeRow> rigTypes();

/// The JSON Schema of rig files, as resources/schema/dermis.rig.schema.json holds it.
[[nodiscard]] std::string rigsAsJsonSchema();
/// The tables of docs/rigs.md: types, and keys with their range and default.
[[nodiscard]] std::string rigsAsMarkdown();

}  // namespace dermis
