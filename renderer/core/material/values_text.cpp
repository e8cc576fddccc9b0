#include "core/material/values_text.h"

#include "core/material/preset_io.h"
#include "core/material/value_json.h"

namespace dermis {
namespace {

constexpr std::string_view kFormat = "dermis.values";
constexpr int kVersion = 1;
constexpr std::string_view kPlace = "the clipboard";

/// The object of values in a text of one of the two formats. Errors: Input.
Result<Json> valuesObject(std::string_view text) {
  Result<Json> json = parseJson(text, std::string(kPlace));
  if (!json || !json->is_object()) return inputError("the clipboard holds no parameter values");
  const auto format = json->find("format");
  const bool isPreset = format != json->end() && *format == kPresetFormat;
  if (!isPreset && (format == json->end() || *format != kFormat))
    return inputError("the clipboard holds no parameter values");
  const auto version = json->find("version");
  if (version == json->end() || !version->is_number_integer() ||
      version->get<std::int64_t>() > (isPreset ? kPresetVersion : kVersion))
    return inputError("the clipboard holds values of a later version of Dermis; copy them from this one");
  const auto values = json->find(isPreset ? "parameters" : "values");
  if (values == json->end() || !values->is_object()) return inputError("the clipboard holds no parameter values");
  return *values;
}

Result<ParameterValue> readOne(const ParameterRow& row, const Json& json) {
  Warnings warnings;
  JsonReport report{std::string(kPlace), warnings};
  const auto value = readParameterValue(row, json, pointerStep("", row.id), report);
  if (!value) return tl::unexpected(*report.error);
  return *value;
}

}  // namespace

std::string writeValues(const std::vector<NamedValue>& values) {
  Json object = Json::object();
  for (const NamedValue& named : values)
    appendMember(object, std::string(named.row->id), parameterToJson(*named.row, named.value));
  Json root = Json::object();
  appendMember(root, "format", std::string(kFormat));
  appendMember(root, "version", kVersion);
  appendMember(root, "values", std::move(object));
  return writeJson(root);
}

Result<std::vector<NamedValue>> readValues(std::string_view text) {
  const Result<Json> object = valuesObject(text);
  if (!object) return tl::unexpected(object.error());
  std::vector<NamedValue> values;
  for (const auto& [id, json] : object->items()) {
    const ParameterRow* row = findParameter(id);
    if (row == nullptr) continue;
    const Result<ParameterValue> value = readOne(*row, json);
    if (!value) return tl::unexpected(value.error());
    values.push_back({row, *value});
  }
  if (values.empty()) return inputError("the clipboard holds no parameter that this version knows");
  return values;
}

Result<ParameterValue> readValueFor(const ParameterRow& row, std::string_view text) {
  const Result<Json> object = valuesObject(text);
  if (object) {
    if (const auto own = object->find(row.id); own != object->end()) return readOne(row, *own);
    if (object->size() == 1)
      if (Result<ParameterValue> only = readOne(row, object->front())) return only;
  } else if (Result<ParameterValue> typed = parseParameterText(row, text)) {
    return typed;
  }
  return inputError("the clipboard holds no value for " + std::string(row.group) + (row.group.empty() ? "" : " › ") +
                    std::string(row.label));
}

}  // namespace dermis
