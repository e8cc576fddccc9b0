#include "core/material/parameter_docs.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "core/base/json_text.h"
#include "core/material/parameter_table.h"
#include "core/material/preset_io.h"
#include "core/material/value_json.h"

namespace dermis {
namespace {

bool hasRange(const ParameterRow& row) { return row.type != ParameterType::Enum && row.type != ParameterType::Bool; }

std::string range(float lowest, float highest) { return fmt::format("{}..{}", lowest, highest); }

std::string defaultText(const ParameterRow& row) { return parameterToText(row, row.defaultValue()); }

std::vector<std::string_view> modelIds(const ParameterRow& row) {
  std::vector<std::string_view> ids;
  for (const ShadingModelRow& model : shadingModels())
    if (row.usedBy(model.model)) ids.push_back(model.id);
  return ids;
}

template <class Words>
std::string joined(const Words& words, std::string_view separator) {
  std::string text;
  for (const auto& word : words) {
    if (!text.empty()) text += separator;
    text += word;
  }
  return text;
}

template <class Words>
Json wordArray(const Words& words) {
  Json array = Json::array();
  for (const auto& word : words) array.push_back(std::string(word));
  return array;
}

/// Groups in the order in which the table names them first.
std::vector<std::string_view> groups() {
  std::vector<std::string_view> names;
  for (const ParameterRow& row : parameterTable())
    if (std::find(names.begin(), names.end(), row.group) == names.end()) names.push_back(row.group);
  return names;
}

/// What a value of the row looks like, for JSON Schema.
Json valueSchema(const ParameterRow& row) {
  const auto number = [](float lowest, float highest) {
    return Json{{"type", "number"}, {"minimum", jsonNumber(lowest)}, {"maximum", jsonNumber(highest)}};
  };
  const auto array = [](const Json& items, int count) {
    return Json{{"type", "array"}, {"items", items}, {"minItems", count}, {"maxItems", count}};
  };
  Json component = number(row.hardMin, row.hardMax);
  switch (row.type) {
    case ParameterType::Float:
      return component;
    case ParameterType::Vec2:
      return array(component, 2);
    case ParameterType::Vec3:
      return array(component, 3);
    case ParameterType::Colour:
      return {{"anyOf", Json::array({array(component, 3), component})}};
    case ParameterType::OptionalColour:
      return {{"anyOf", Json::array({array(component, 3), component, Json{{"type", "null"}}})}};
    case ParameterType::Enum:
      return {{"enum", wordArray(row.words)}};
    case ParameterType::Bool:
      return {{"type", "boolean"}};
    case ParameterType::Gaussians: {
      const Json share = number(0.0F, 1.0F);
      return {{"type", "array"},
              {"maxItems", kMaxGaussians},
              {"items",
               {{"type", "array"},
                {"prefixItems", Json::array({component, share, share, share})},
                {"minItems", 4},
                {"maxItems", 4}}}};
    }
  }
  return Json::object();
}

Json textureSchema() {
  Json channels = Json::array();
  for (int i = 0; i <= static_cast<int>(TextureChannel::Luminance); ++i)
    channels.push_back(std::string(toString(static_cast<TextureChannel>(i))));
  const Json number = {{"type", "number"}};
  const Json flag = {{"type", "boolean"}};
  return {{"type", "object"},
          {"required", Json::array({"path"})},
          {"properties",
           {{"path", {{"type", "string"}, {"minLength", 1}}},
            {"color_space", {{"type", "string"}}},
            {"channel", {{"enum", channels}}},
            {"invert", flag},
            {"flip_green", flag},
            {"scale", number},
            {"uv_scale", {{"type", "array"}, {"items", number}, {"minItems", 2}, {"maxItems", 2}}}}}};
}

}  // namespace

std::string parametersAsText() {
  std::string text;
  for (const std::string_view group : groups()) {
    text += std::string(group) + "\n";
    for (const ParameterRow& row : parameterTable()) {
      if (row.group != group) continue;
      text += "  " + std::string(row.id) + "  " + std::string(toString(row.type)) + "  default " + defaultText(row);
      if (hasRange(row)) text += "  range " + range(row.hardMin, row.hardMax);
      if (!row.unit.empty()) text += " " + std::string(row.unit);
      if (!row.words.empty()) text += "  one of " + joined(row.words, ", ");
      if (row.map) text += "  × " + std::string(textureSlotRow(*row.map).id) + " map";
      text += "  [" + joined(modelIds(row), ", ") + "]\n      " + std::string(row.sentence) + "\n";
    }
  }
  return text;
}

std::string parametersAsJson() {
  Json rows = Json::array();
  const auto limits = [](const ParameterRow& row, float lowest, float highest) {
    return hasRange(row) ? Json::array({jsonNumber(lowest), jsonNumber(highest)}) : Json(nullptr);
  };
  for (const ParameterRow& row : parameterTable()) {
    rows.push_back({{"id", std::string(row.id)},
                    {"label", std::string(row.label)},
                    {"group", std::string(row.group)},
                    {"type", std::string(toString(row.type))},
                    {"unit", std::string(row.unit)},
                    {"hard", limits(row, row.hardMin, row.hardMax)},
                    {"soft", limits(row, row.softMin, row.softMax)},
                    {"default", parameterToJson(row, row.defaultValue())},
                    {"invalidates", std::string(toString(row.invalidates))},
                    {"models", wordArray(modelIds(row))},
                    {"sentence", std::string(row.sentence)},
                    {"source", std::string(row.source)},
                    {"words", wordArray(row.words)},
                    {"map", row.map ? Json(std::string(textureSlotRow(*row.map).id)) : Json(nullptr)}});
  }
  return writeJson(rows);
}

std::string parametersAsMarkdown() {
  std::string text =
      "# Material parameters\n\n"
      "Written by the program from its parameter table; a test keeps this page equal to it. Lengths are millimetres,\n"
      "colours linear Rec.709. A value outside its range is clamped with a warning; the slider's range only sizes the\n"
      "slider. \"× map\" means that the value multiplies that texture map, and counts as 1 where a file gives the map\n"
      "but no value.\n";
  for (const std::string_view group : groups()) {
    text += "\n## " + std::string(group) +
            "\n\n| id | type | unit | range | slider | default | × map | models | changes | meaning | source |\n"
            "|---|---|---|---|---|---|---|---|---|---|---|\n";
    for (const ParameterRow& row : parameterTable()) {
      if (row.group != group) continue;
      const std::string_view map = row.map ? textureSlotRow(*row.map).id : std::string_view();
      text += "| `" + std::string(row.id) + "` | " + std::string(toString(row.type)) + " | " + std::string(row.unit) +
              " | " + (hasRange(row) ? range(row.hardMin, row.hardMax) : joined(row.words, ", ")) + " | " +
              (hasRange(row) ? range(row.softMin, row.softMax) : std::string()) + " | " + defaultText(row) + " | " +
              std::string(map) + " | " + joined(modelIds(row), ", ") + " | " + std::string(toString(row.invalidates)) +
              " | " + std::string(row.sentence) + " | " + std::string(row.source) + " |\n";
    }
  }
  return text;
}

std::string parametersAsJsonSchema() {
  Json parameters = Json::object();
  for (const ParameterRow& row : parameterTable()) {
    Json schema = valueSchema(row);
    schema["title"] = std::string(row.label);
    schema["description"] = std::string(row.sentence) + (row.unit.empty() ? "" : " Unit: " + std::string(row.unit));
    schema["default"] = parameterToJson(row, row.defaultValue());
    parameters[std::string(row.id)] = std::move(schema);
  }
  Json textures = Json::object();
  for (const TextureSlotRow& row : textureSlots()) textures[std::string(row.id)] = {{"$ref", "#/$defs/texture"}};
  Json models = Json::array();
  for (const ShadingModelRow& model : shadingModels()) models.push_back(std::string(model.id));

  const Json text = {{"type", "string"}};
  const Json schema = {{"$schema", "https://json-schema.org/draft/2020-12/schema"},
                       {"title", "Dermis material preset, version " + std::to_string(kPresetVersion)},
                       {"type", "object"},
                       {"required", Json::array({"format", "version", "model", "parameters"})},
                       {"properties",
                        {{"format", {{"const", std::string(kPresetFormat)}}},
                         {"version", {{"const", kPresetVersion}}},
                         {"name", text},
                         {"model", {{"enum", models}}},
                         {"parameters", {{"type", "object"}, {"properties", parameters}}},
                         {"textures", {{"type", "object"}, {"properties", textures}}},
                         {"metadata",
                          {{"type", "object"},
                           {"properties",
                            {{"author", text},
                             {"notes", text},
                             {"created_with", text},
                             {"tags", {{"type", "array"}, {"items", text}}}}}}}}},
                       {"$defs", {{"texture", textureSchema()}}}};
  return writeJson(schema);
}

std::string choiceLabel(std::string_view word) {
  std::string label(word);
  std::ranges::replace(label, '_', ' ');
  if (!label.empty() && label[0] >= 'a' && label[0] <= 'z') label[0] = static_cast<char>(label[0] - 'a' + 'A');
  return label;
}

std::vector<std::string> tableWords() {
  std::vector<std::string> words;
  const auto add = [&](std::string_view word) {
    if (!word.empty() && std::ranges::find(words, word) == words.end()) words.emplace_back(word);
  };
  for (const ParameterRow& row : parameterTable()) {
    for (const std::string_view word : {row.label, row.group, row.sentence}) add(word);
    for (const std::string_view word : row.words) add(choiceLabel(word));
  }
  for (const ShadingModelRow& row : shadingModels())
    for (const std::string_view word : {row.label, row.sentence}) add(word);
  for (const TextureSlotRow& row : textureSlots()) add(row.label);
  return words;
}

}  // namespace dermis
