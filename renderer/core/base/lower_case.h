// ASCII lower case, whatever the locale: file endings, keywords, names.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>

namespace dermis {

[[nodiscard]] constexpr char lowerCase(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

[[nodiscard]] inline std::string lowerCase(std::string_view text) {
  std::string lower(text);
  std::transform(lower.begin(), lower.end(), lower.begin(), [](char c) { return lowerCase(c); });
  return lower;
}

}  // namespace dermis
