// The rig format for validators and readers, from the same rows that read it.
#include "core/base/number_format.h"
#include "core/light_rig/rig_fields.h"
#include "core/light_rig/rig_io.h"

namespace dermis {
namespace {

Json bounded(const Range& range) {
  Json json = {{"type", "number"}};
  if (range.lowest != Range{}.lowest) json["minimum"] = jsonNumber(range.lowest);
  if (range.highest != Range{}.highest) json["maximum"] = jsonNumber(range.highest);
  return json;
}

Json numbers(const Range& range, int count) {
  return {{"type", "array"}, {"items", bounded(range)}, {"minItems", count}, {"maxItems", count}};
}

template <class Member>
using MemberValue = std::remove_cvref_t<decltype(std::declval<RigElement&>().*std::declval<Member>())>;

Json valueSchema(const RigField& field) {
  return std::visit(
      [&](auto member) -> Json {
        using Value = MemberValue<decltype(member)>;
        if constexpr (std::is_same_v<Value, bool>) return {{"type", "boolean"}};
        if constexpr (std::is_same_v<Value, float> || std::is_same_v<Value, std::optional<float>>)
          return bounded(field.range);
        if constexpr (std::is_same_v<Value, glm::vec2> || std::is_same_v<Value, std::optional<glm::vec2>>)
          return numbers(field.range, 2);
        return {{"anyOf", Json::array({numbers(field.range, 3), bounded(field.range)})}};
      },
      field.member);
}

std::string shown(bool value) { return value ? "true" : "false"; }
std::string shown(float value) { return shortestDecimal(value); }
template <glm::length_t N>
std::string shown(const glm::vec<N, float>& value) {
  std::string text;
  for (glm::length_t i = 0; i < N; ++i) text += (i == 0 ? "[" : ", ") + shortestDecimal(value[i]);
  return text + "]";
}

std::string shownDefault(const RigField& field) {
  const RigElement element;
  return std::visit(
      [&](auto member) -> std::string {
        const auto& value = element.*member;
        if constexpr (requires { value.has_value(); })
          return "";
        else
          return shown(value);
      },
      field.member);
}

std::string shownRange(const Range& range) {
  const bool low = range.lowest != Range{}.lowest, high = range.highest != Range{}.highest;
  if (!low && !high) return "";
  if (!high) return "≥ " + shortestDecimal(range.lowest);
  return shortestDecimal(range.lowest) + "..." + shortestDecimal(range.highest);
}

/// One of an element type, with the keys that it uses.
Json elementSchema(std::size_t type) {
  Json properties = {
      {"type", {{"const", rigTypes()[type].id}}}, {"name", {{"type", "string"}}}, {"enabled", {{"type", "boolean"}}}};
  for (const RigField& field : rigFields()) {
    if (!field.usedBy(static_cast<RigElementType>(type))) continue;
    Json value = valueSchema(field);
    value["description"] = field.sentence;
    properties[std::string(field.key)] = std::move(value);
  }
  return {{"type", "object"}, {"required", {"type"}}, {"properties", std::move(properties)}};
}

}  // namespace

std::string rigsAsJsonSchema() {
  Json types = Json::array();
  for (std::size_t i = 0; i < rigTypes().size(); ++i) types.push_back(elementSchema(i));
  const Json schema = {
      {"$schema", "https://json-schema.org/draft/2020-12/schema"},
      {"title", "Dermis light rig, version 1"},
      {"type", "object"},
      {"required", {"format", "version", "elements"}},
      {"properties",
       {{"format", {{"const", kRigFormat}}},
        {"version", {{"const", kRigVersion}}},
        {"name", {{"type", "string"}}},
        {"description", {{"type", "string"}}},
        {"white_luminance_cd_m2", {{"type", "number"}, {"exclusiveMinimum", 0}}},
        {"width", {{"type", "integer"}, {"minimum", 64}, {"maximum", 4096}}},
        {"elements", {{"type", "array"}, {"maxItems", kMaxRigElements}, {"items", {{"oneOf", std::move(types)}}}}},
        {"metadata", {{"type", "object"}}}}}};
  return writeJson(schema);
}

std::string rigsAsMarkdown() {
  std::string text = "| type | what it is |\n|---|---|\n";
  for (const RigTypeRow& row : rigTypes())
    text += "| `" + std::string(row.id) + "` | " + std::string(row.sentence) + " |\n";
  text += "\n| key | of | range | default | meaning |\n|---|---|---|---|---|\n";
  for (const RigField& field : rigFields()) {
    std::string types;
    for (std::size_t i = 0; i < rigTypes().size(); ++i)
      if (field.usedBy(static_cast<RigElementType>(i)))
        types += (types.empty() ? "" : " ") + std::string(rigTypes()[i].id);
    text += "| `" + std::string(field.key) + "` | " + types + " | " + shownRange(field.range) + " | " +
            shownDefault(field) + " | " + std::string(field.sentence) + " |\n";
  }
  return text;
}

}  // namespace dermis
