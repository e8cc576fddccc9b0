#include "core/material/value_json.h"

#include <algorithm>

#include "core/base/number_format.h"

namespace dermis {
namespace {

template <class Vector>
Json vectorToJson(const Vector& vector) {
  Json array = Json::array();
  for (int i = 0; i < Vector::length(); ++i) array.push_back(jsonNumber(vector[i]));
  return array;
}

std::optional<glm::vec3> readVec3(const Json& json, const std::string& pointer, JsonReport& report) {
  const auto numbers = readNumbers(json, 3, pointer, report);
  if (!numbers) return std::nullopt;
  return glm::vec3((*numbers)[0], (*numbers)[1], (*numbers)[2]);
}

std::optional<Colour> readColour(const Json& json, const std::string& pointer, JsonReport& report) {
  if (json.is_number()) {
    const auto grey = readNumber(json, pointer, report);
    if (!grey) return std::nullopt;
    return Colour{glm::vec3(*grey)};
  }
  if (!json.is_array()) {
    report.refuse(pointer, "must be a colour, three numbers or one, not " + std::string(typeName(json)));
    return std::nullopt;
  }
  const auto rgb = readVec3(json, pointer, report);
  if (!rgb) return std::nullopt;
  return Colour{*rgb};
}

std::optional<GaussianTable> readGaussians(const Json& json, const std::string& pointer, JsonReport& report) {
  if (!json.is_array()) {
    report.refuse(pointer, "must be an array of [variance, red, green, blue], not " + std::string(typeName(json)));
    return std::nullopt;
  }
  if (json.size() > kMaxGaussians) {
    report.refuse(pointer, "has " + std::to_string(json.size()) + " rows; at most " + std::to_string(kMaxGaussians) +
                               " are possible");
    return std::nullopt;
  }
  GaussianTable table;
  for (const Json& row : json) {
    const auto index = static_cast<std::size_t>(table.count);
    const auto numbers = readNumbers(row, 4, pointerStep(pointer, index), report);
    if (!numbers) return std::nullopt;
    table.terms.at(index) = {(*numbers)[0], {(*numbers)[1], (*numbers)[2], (*numbers)[3]}};
    ++table.count;
  }
  return table;
}

std::optional<EnumValue> readEnum(const ParameterRow& row, const Json& json, const std::string& pointer,
                                  JsonReport& report) {
  if (!json.is_string()) {
    report.refuse(pointer, "must be " + listed(row.words) + ", not " + std::string(typeName(json)));
    return std::nullopt;
  }
  const auto& text = json.get_ref<const std::string&>();
  const auto word = std::find(row.words.begin(), row.words.end(), text);
  if (word == row.words.end()) {
    report.refuse(pointer, "must be " + listed(row.words) + ", not " + inQuotes(text));
    return std::nullopt;
  }
  return EnumValue{static_cast<int>(word - row.words.begin())};
}

/// The variant's alternative T, where reading found one.
template <class T>
std::optional<ParameterValue> asValue(const std::optional<T>& read) {
  if (!read) return std::nullopt;
  return ParameterValue(std::in_place_type<T>, *read);
}

/// Typed text as the JSON it stands for; nothing where it is none.
std::optional<Json> jsonOfText(const ParameterRow& row, std::string_view text) {
  if (row.type == ParameterType::Enum) return Json(std::string(text));
  if (text == "null") return Json(nullptr);
  if (text == "true") return Json(true);
  if (text == "false") return Json(false);
  if (text.starts_with('[')) {
    auto json = parseJson(text, std::string(row.id));
    return json ? std::optional<Json>(std::move(*json)) : std::nullopt;
  }
  const auto numbers = parseFloatList(text);
  if (!numbers) return std::nullopt;
  if (numbers->size() == 1) return jsonNumber(numbers->front());
  Json array = Json::array();
  for (const float number : *numbers) array.push_back(jsonNumber(number));
  return array;
}

/// What a row takes, for a sentence about text that is nothing of the kind.
std::string expectation(const ParameterRow& row) {
  switch (row.type) {
    case ParameterType::Float:
      return "a number";
    case ParameterType::Vec2:
      return "two numbers with a comma between";
    case ParameterType::Vec3:
      return "three numbers with commas between";
    case ParameterType::Colour:
      return "a colour, three numbers with commas between, or one";
    case ParameterType::OptionalColour:
      return "a colour, three numbers with commas between, or one, or null";
    case ParameterType::Enum:
      return listed(row.words);
    case ParameterType::Bool:
      return "true or false";
    case ParameterType::Gaussians:
      return "a JSON array of [variance, red, green, blue]";
  }
  return "a value";
}

}  // namespace

Json parameterToJson(const ParameterRow& row, const ParameterValue& value) {
  switch (row.type) {
    case ParameterType::Float:
      return jsonNumber(std::get<float>(value));
    case ParameterType::Vec2:
      return vectorToJson(std::get<glm::vec2>(value));
    case ParameterType::Vec3:
      return vectorToJson(std::get<glm::vec3>(value));
    case ParameterType::Colour:
      return vectorToJson(std::get<Colour>(value).rgb);
    case ParameterType::OptionalColour: {
      const auto& colour = std::get<OptionalColour>(value);
      return colour ? vectorToJson(colour->rgb) : Json(nullptr);
    }
    case ParameterType::Enum: {
      const auto index = static_cast<std::size_t>(std::get<EnumValue>(value).index);
      return std::string(index < row.words.size() ? row.words[index] : row.words.front());
    }
    case ParameterType::Bool:
      return std::get<bool>(value);
    case ParameterType::Gaussians: {
      const auto& table = std::get<GaussianTable>(value);
      Json array = Json::array();
      for (int i = 0; i < table.count; ++i) {
        const GaussianTerm& term = table.terms.at(static_cast<std::size_t>(i));
        array.push_back(vectorToJson(glm::vec4(term.variance, term.weight)));
      }
      return array;
    }
  }
  return nullptr;
}

std::optional<ParameterValue> readParameterValue(const ParameterRow& row, const Json& json, const std::string& pointer,
                                                 JsonReport& report) {
  switch (row.type) {
    case ParameterType::Float:
      return asValue(readNumber(json, pointer, report));
    case ParameterType::Vec2: {
      const auto numbers = readNumbers(json, 2, pointer, report);
      if (!numbers) return std::nullopt;
      return ParameterValue(glm::vec2((*numbers)[0], (*numbers)[1]));
    }
    case ParameterType::Vec3:
      return asValue(readVec3(json, pointer, report));
    case ParameterType::Colour:
      return asValue(readColour(json, pointer, report));
    case ParameterType::OptionalColour: {
      if (json.is_null()) return ParameterValue(OptionalColour());
      const auto colour = readColour(json, pointer, report);
      if (!colour) return std::nullopt;
      return ParameterValue(OptionalColour(*colour));
    }
    case ParameterType::Enum:
      return asValue(readEnum(row, json, pointer, report));
    case ParameterType::Bool:
      if (json.is_boolean()) return ParameterValue(json.get<bool>());
      report.refuse(pointer, "must be true or false, not " + std::string(typeName(json)));
      return std::nullopt;
    case ParameterType::Gaussians:
      return asValue(readGaussians(json, pointer, report));
  }
  return std::nullopt;
}

Result<ParameterValue> parseParameterText(const ParameterRow& row, std::string_view text) {
  text = trimmed(text);
  const std::string id(row.id);
  const std::string refusal = id + " must be " + expectation(row) + ", not " + inQuotes(text);
  const auto json = jsonOfText(row, text);
  if (!json) return inputError(refusal);
  Warnings warnings;
  JsonReport report{id, warnings};
  const auto value = readParameterValue(row, *json, "", report);
  if (report.error || !value) return inputError(refusal);
  return *value;
}

std::string parameterToText(const ParameterRow& row, const ParameterValue& value) {
  const Json json = parameterToJson(row, value);
  if (json.is_string()) return json.get<std::string>();
  std::string text = writeJson(json);
  std::erase_if(text, [](char c) { return c == '\n' || c == ' '; });
  // Typed lists have no brackets; a table keeps them.
  if (json.is_array() && row.type != ParameterType::Gaussians) text = text.substr(1, text.size() - 2);
  return text;
}

ParameterValue clampWithWarning(const ParameterRow& row, const ParameterValue& value, const std::string& where,
                                Warnings& warnings) {
  bool changed = false;
  ParameterValue inside = clampToHardRange(row, value, &changed);
  if (changed)
    warnings.push_back(where + " is " + parameterToText(row, value) + " and is clamped to " +
                       parameterToText(row, inside) + "; its range is " + shortestDecimal(row.hardMin) + " to " +
                       shortestDecimal(row.hardMax));
  return inside;
}

}  // namespace dermis
