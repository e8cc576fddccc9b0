// Our JSON files as text: a strict reader that says where it stopped, a writer that is the same on every machine.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace dermis {

/// Keeps the order of keys, so that what is saved reads as it was written.
using Json = nlohmann::ordered_json;

/// Larger preset and scene files are refused.
inline constexpr std::size_t kMaxJsonBytes = std::size_t{8} << 20U;
/// Deeper nesting is refused.
inline constexpr int kMaxJsonDepth = 64;

/// Parses a whole text. Errors: Input, `name` and line and column of what isn't JSON (NaN and numbers that overflow
/// among them), a key that stands twice in an object, nesting deeper than kMaxJsonDepth.
[[nodiscard]] Result<Json> parseJson(std::string_view text, const std::string& name);

/// Text with two spaces of indentation and a line feed at its end. Numbers are their shortest decimals; a container
/// without objects in it stands on one line where it fits. What isn't UTF-8 in a string becomes U+FFFD.
[[nodiscard]] std::string writeJson(const Json& value);

/// Writes that text beside the target and renames. Errors: Runtime, as writeFileAtomically; a string that isn't UTF-8.
[[nodiscard]] Result<void> saveJson(const std::filesystem::path& path, const Json& value);

/// Adds a member whose key is known to be new: ordered_json's own operator[] looks through all keys first, which makes
/// building a large object quadratic.
void appendMember(Json& object, std::string key, Json value);

/// A number that is written as the shortest decimal of the 32-bit float.
[[nodiscard]] Json jsonNumber(float value);

/// `pointer` with one more step, escaped as RFC 6901 says, control characters as a JSON string would.
[[nodiscard]] std::string pointerStep(const std::string& pointer, std::string_view key);
[[nodiscard]] std::string pointerStep(const std::string& pointer, std::size_t index);

/// The text in quotation marks as a sentence can show it: control characters escaped, cut when long.
[[nodiscard]] std::string inQuotes(std::string_view text);

[[nodiscard]] bool isUtf8(std::string_view text);

}  // namespace dermis
