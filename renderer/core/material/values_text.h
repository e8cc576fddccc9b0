// Parameter values as a text that one program puts on the clipboard and another reads:
// {"format": "dermis.values", "version": 1, "values": {"subsurface.scale": 1.0, …}}. A preset's text is read as well.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/material/parameter_table.h"

namespace dermis {

struct NamedValue {
  const ParameterRow* row = nullptr;
  ParameterValue value;
};

/// Rows need not be of the table, but those of an enum need their words.
[[nodiscard]] std::string writeValues(const std::vector<NamedValue>& values);

/// All values of the table that the text holds, not clamped. Errors: Input, one sentence: not such a text, a value of
/// another type, none that this version knows.
[[nodiscard]] Result<std::vector<NamedValue>> readValues(std::string_view text);

/// The value in the text that suits `row`: the one with its id; else the only one, where it is of the row's type; else
/// the text as it would be typed ("0.45", "0.9,0.5,0.2", "smith"). Errors: Input, one sentence.
[[nodiscard]] Result<ParameterValue> readValueFor(const ParameterRow& row, std::string_view text);

}  // namespace dermis
