// Parameter values as JSON and as text.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/base/json_fields.h"
#include "core/base/json_text.h"
#include "core/material/parameter_table.h"

namespace dermis {

/// float → number; vec2, vec3, colour → array; null colour → null; enum → its word; bool → true or false;
/// Gaussians → array of [variance mm², red, green, blue].
[[nodiscard]] Json parameterToJson(const ParameterRow& row, const ParameterValue& value);

/// The reverse; a colour may be one number. Refuses in the report, with `pointer`, what is of another type, not finite
/// or not one of the words. The value isn't clamped.
[[nodiscard]] std::optional<ParameterValue> readParameterValue(const ParameterRow& row, const Json& json,
                                                               const std::string& pointer, JsonReport& report);

/// A value as it is typed: "0.45", "0.9,0.5,0.2", "0.5" for a grey, an enum's word, "true", "null", or JSON.
/// Errors: Input, a sentence that starts with the row's id. The value isn't clamped.
[[nodiscard]] Result<ParameterValue> parseParameterText(const ParameterRow& row, std::string_view text);

/// What parseParameterText reads back: "0.45", "0.9,0.5,0.2", "smith", "true", "null".
[[nodiscard]] std::string parameterToText(const ParameterRow& row, const ParameterValue& value);

/// The value inside the row's hard range; where that changes it, a warning "WHERE is 5 and is clamped to 3 …".
[[nodiscard]] ParameterValue clampWithWarning(const ParameterRow& row, const ParameterValue& value,
                                              const std::string& where, Warnings& warnings);

}  // namespace dermis
