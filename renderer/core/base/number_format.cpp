#include "core/base/number_format.h"

#include <array>
#include <charconv>
#include <cmath>

namespace dermis {
namespace {

template <class T>
std::string shortest(T value) {
  // "-0" would read back as the integer 0.
  if (value == T(0) && std::signbit(value)) return "-0.0";
  std::array<char, 32> buffer{};
  const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  return error == std::errc() ? std::string(buffer.data(), end) : std::string("0");
}

}  // namespace

std::string shortestDecimal(float value) { return shortest(value); }
std::string shortestDecimal(double value) { return shortest(value); }

double widened(float value) {
  const std::string text = shortest(value);
  double wide = 0.0;
  std::from_chars(text.data(), text.data() + text.size(), wide);
  // A handful of floats lie so close to the middle of two others that decimal → double → float would miss them.
  return static_cast<float>(wide) == value ? wide : static_cast<double>(value);
}

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r\n";
  const std::size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

std::optional<float> parseFloat(std::string_view text) {
  text = trimmed(text);
  const char* const last = text.data() + text.size();
  float value = 0.0F;
  const auto [end, error] = std::from_chars(text.data(), last, value);
  if (end != last || text.empty()) return std::nullopt;
  if (error == std::errc::result_out_of_range) {
    // Too small is zero; too large is not a number that we can hold.
    double wide = 0.0;
    if (std::from_chars(text.data(), last, wide).ec != std::errc() || std::abs(wide) > 1.0) return std::nullopt;
    return static_cast<float>(wide);
  }
  if (error != std::errc() || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::optional<std::vector<float>> parseFloatList(std::string_view text) {
  std::vector<float> values;
  for (;;) {
    const std::size_t comma = text.find(',');
    const auto value = parseFloat(text.substr(0, comma));
    if (!value) return std::nullopt;
    values.push_back(*value);
    if (comma == std::string_view::npos) return values;
    text.remove_prefix(comma + 1);
  }
}

}  // namespace dermis
