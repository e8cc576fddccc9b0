// Numbers as text and back, whatever the locale.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace dermis {

/// The shortest decimal that reads back to the same 32-bit float, as JSON writes numbers: "0.45", "1", "1e-07".
/// The value must be finite.
[[nodiscard]] std::string shortestDecimal(float value);
/// The same for a double.
[[nodiscard]] std::string shortestDecimal(double value);

/// The double whose shortest decimal is that of `value`: 0.45 rather than 0.449999988. It narrows to `value` again.
[[nodiscard]] double widened(float value);

/// The whole text (blanks around it aside) as a finite number; nothing where it isn't one.
[[nodiscard]] std::optional<float> parseFloat(std::string_view text);
/// Numbers separated by commas: "0.9, 0.5,0.2"; nothing where any part isn't a finite number.
[[nodiscard]] std::optional<std::vector<float>> parseFloatList(std::string_view text);

/// The text without blanks at its ends.
[[nodiscard]] std::string_view trimmed(std::string_view text);

}  // namespace dermis
