#include "core/base/json_text.h"

#include <algorithm>
#include <cmath>
#include <unordered_set>
#include <vector>

#include "core/base/file_io.h"
#include "core/base/number_format.h"

namespace dermis {
namespace {

/// Length in bytes of the well-formed UTF-8 sequence at the start of `text` (Unicode 15, table 3-7), 0 where it is
/// none.
std::size_t utf8Length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U; };
  const auto continues = [&](std::size_t i) { return (byte(i) & 0xC0U) == 0x80U; };
  const unsigned first = byte(0);
  if (first < 0x80U) return 1;
  if (first >= 0xC2U && first <= 0xDFU) return continues(1) ? 2 : 0;
  if (first >= 0xE0U && first <= 0xEFU) {
    const unsigned lowest = first == 0xE0U ? 0xA0U : 0x80U;
    const unsigned highest = first == 0xEDU ? 0x9FU : 0xBFU;  // no surrogates
    return byte(1) >= lowest && byte(1) <= highest && continues(2) ? 3 : 0;
  }
  if (first >= 0xF0U && first <= 0xF4U) {
    const unsigned lowest = first == 0xF0U ? 0x90U : 0x80U;
    const unsigned highest = first == 0xF4U ? 0x8FU : 0xBFU;  // no more than U+10FFFF
    return byte(1) >= lowest && byte(1) <= highest && continues(2) && continues(3) ? 4 : 0;
  }
  return 0;
}

/// Appends the text as the inside of a JSON string.
void appendEscaped(std::string& out, std::string_view text) {
  constexpr std::string_view kHex = "0123456789abcdef";
  while (!text.empty()) {
    const std::size_t length = utf8Length(text);
    const auto c = static_cast<unsigned char>(text.front());
    if (length == 0) {
      out += "\xEF\xBF\xBD";
    } else if (c == '"' || c == '\\') {
      out += {'\\', static_cast<char>(c)};
    } else if (c == '\n') {
      out += "\\n";
    } else if (c == '\t') {
      out += "\\t";
    } else if (c == '\r') {
      out += "\\r";
    } else if (c < 0x20U || c == 0x7FU) {
      out += std::string("\\u00") + kHex[c >> 4U] + kHex[c & 15U];
    } else {
      out += text.substr(0, length);
    }
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
}

// ---- reading

/// "line 3, column 17" of a byte of the text.
std::string lineAndColumn(std::string_view text, std::size_t position) {
  text = text.substr(0, std::min(position, text.size()));
  const auto line = std::count(text.begin(), text.end(), '\n') + 1;
  const std::size_t lineStart = text.rfind('\n');
  const std::size_t column = text.size() - (lineStart == std::string_view::npos ? 0 : lineStart + 1);
  return "line " + std::to_string(line) + ", column " + std::to_string(std::max<std::size_t>(column, 1));
}

/// Builds the document from the parser's events and stops at the first thing that we refuse.
class Builder : public nlohmann::json_sax<Json> {
 public:
  Builder(std::string_view text, const std::string& name) : m_text(text), m_name(name) {}

  Json root;
  std::string error;  ///< a sentence, empty while all is well

  bool null() override { return add(nullptr); }
  bool boolean(bool value) override { return add(value); }
  bool number_integer(number_integer_t value) override { return add(value); }
  bool number_unsigned(number_unsigned_t value) override { return add(value); }
  bool number_float(number_float_t value, const string_t& /*text*/) override { return add(value); }
  bool string(string_t& value) override { return add(std::move(value)); }
  bool binary(binary_t& /*value*/) override { return false; }

  bool start_object(std::size_t /*size*/) override { return open(Json::object()); }
  bool start_array(std::size_t /*size*/) override { return open(Json::array()); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }

  bool key(string_t& value) override {
    Level& level = m_levels.back();
    level.key = value;
    if (level.keys.insert(value).second) return true;
    error = m_name + ": " + pointer() + " stands twice in the same object; keep one";
    return false;
  }

  bool parse_error(std::size_t position, const std::string& /*token*/, const Json::exception& exception) override {
    error = m_name + " is not valid JSON at " + lineAndColumn(m_text, position) + ": " + reason(exception);
    return false;
  }

 private:
  struct Level {
    Json* value;
    std::string key;
    std::unordered_set<std::string> keys;  // ordered_json itself looks for a key from the front
  };

  bool add(Json&& value) {
    place(std::move(value));
    return true;
  }

  Json* place(Json&& value) {
    if (m_levels.empty()) {
      root = std::move(value);
      return &root;
    }
    Level& level = m_levels.back();
    if (level.value->is_array()) {
      level.value->push_back(std::move(value));
      return &level.value->back();
    }
    appendMember(*level.value, level.key, std::move(value));  // pointer() needs the key, too
    return &level.value->get_ref<Json::object_t&>().back().second;
  }

  bool open(Json&& container) {
    if (m_levels.size() >= static_cast<std::size_t>(kMaxJsonDepth)) {
      error = m_name + " is nested deeper than " + std::to_string(kMaxJsonDepth) + " levels; no file of ours is";
      return false;
    }
    m_levels.push_back({place(std::move(container)), {}, {}});
    return true;
  }
  bool close() {
    m_levels.pop_back();
    return true;
  }

  [[nodiscard]] std::string pointer() const {
    std::string path;
    for (const Level& level : m_levels)
      path = level.value->is_array() ? pointerStep(path, level.value->size() - 1) : pointerStep(path, level.key);
    return path;
  }

  /// The parser's own words without its bookkeeping.
  [[nodiscard]] std::string reason(const Json::exception& exception) const {
    constexpr int kNumberOverflow = 406;
    if (exception.id == kNumberOverflow) return "a number is too large to be held";
    std::string text = exception.what();
    if (const auto dash = text.find(" - "); dash != std::string::npos) text.erase(0, dash + 3);
    if (const auto token = text.find("; last read"); token != std::string::npos) text.erase(token);
    if (text.starts_with("unexpected end of input")) return "the text ends too early";
    return text;
  }

  std::string_view m_text;
  const std::string& m_name;
  std::vector<Level> m_levels;
};

// ---- writing

constexpr std::size_t kLineWidth = 100;

bool hasObjects(const Json& value) {
  if (value.is_object()) return true;
  return value.is_array() && std::any_of(value.begin(), value.end(), hasObjects);
}

/// On one line: scalars, arrays without objects, and small objects of those.
bool isFlat(const Json& value) {
  if (value.is_object()) return std::none_of(value.begin(), value.end(), hasObjects);
  return !hasObjects(value);
}

void appendScalar(std::string& out, const Json& value) {
  switch (value.type()) {
    case Json::value_t::string:
      out += '"';
      appendEscaped(out, value.get_ref<const std::string&>());
      out += '"';
      break;
    case Json::value_t::boolean:
      out += value.get<bool>() ? "true" : "false";
      break;
    case Json::value_t::number_integer:
      out += std::to_string(value.get<std::int64_t>());
      break;
    case Json::value_t::number_unsigned:
      out += std::to_string(value.get<std::uint64_t>());
      break;
    case Json::value_t::number_float: {
      const double number = value.get<double>();
      out += std::isfinite(number) ? shortestDecimal(number) : "null";
      break;
    }
    default:
      out += "null";
      break;
  }
}

void appendKey(std::string& out, const std::string& key) {
  out += '"';
  appendEscaped(out, key);
  out += "\": ";
}

void appendOnOneLine(std::string& out, const Json& value) {
  if (!value.is_structured()) return appendScalar(out, value);
  out += value.is_object() ? '{' : '[';
  bool first = true;
  for (auto it = value.begin(); it != value.end(); ++it) {
    if (!first) out += ", ";
    first = false;
    if (value.is_object()) appendKey(out, it.key());
    appendOnOneLine(out, *it);
  }
  out += value.is_object() ? '}' : ']';
}

/// `column` is where the value starts in its line.
void append(std::string& out, const Json& value, std::size_t indentation, bool isRoot) {
  if (!value.is_structured()) return appendScalar(out, value);
  if (value.empty() || (!isRoot && isFlat(value))) {
    const std::size_t lineStart = out.rfind('\n') + 1;  // npos + 1 is 0
    const std::size_t before = out.size();
    appendOnOneLine(out, value);
    if (value.empty() || out.size() - lineStart <= kLineWidth) return;
    out.resize(before);
  }
  out += value.is_object() ? "{\n" : "[\n";
  bool first = true;
  for (auto it = value.begin(); it != value.end(); ++it) {
    if (!first) out += ",\n";
    first = false;
    out.append(indentation + 2, ' ');
    if (value.is_object()) appendKey(out, it.key());
    append(out, *it, indentation + 2, false);
  }
  out += '\n';
  out.append(indentation, ' ');
  out += value.is_object() ? '}' : ']';
}

/// Whether all keys and strings are UTF-8: a file's name may hold any bytes.
bool holdsOnlyUtf8(const Json& value) {
  if (value.is_string()) return isUtf8(value.get_ref<const std::string&>());
  if (!value.is_structured()) return true;
  for (const auto& [key, member] : value.items())
    if (!isUtf8(key) || !holdsOnlyUtf8(member)) return false;
  return true;
}

}  // namespace

Result<Json> parseJson(std::string_view text, const std::string& name) {
  Builder builder(text, name);
  if (!Json::sax_parse(text.begin(), text.end(), &builder)) return inputError(std::move(builder.error));
  return std::move(builder.root);
}

std::string writeJson(const Json& value) {
  std::string out;
  append(out, value, 0, true);
  out += '\n';
  return out;
}

Result<void> saveJson(const std::filesystem::path& path, const Json& value) {
  if (!holdsOnlyUtf8(value))
    return runtimeError(path.string() +
                        " cannot be written: a name or path in it is not UTF-8, which JSON must be; rename that file");
  return writeFileAtomically(path, writeJson(value));
}

void appendMember(Json& object, std::string key, Json value) {
  using Members = std::vector<Json::object_t::value_type, Json::object_t::allocator_type>;
  Members& members = object.get_ref<Json::object_t&>();
  members.emplace_back(std::move(key), std::move(value));
}

Json jsonNumber(float value) { return widened(value); }

std::string pointerStep(const std::string& pointer, std::string_view key) {
  std::string step;
  for (const char c : key) step += c == '~' ? "~0" : c == '/' ? "~1" : std::string(1, c);
  std::string result = pointer + "/";
  for (std::size_t i = 0; i < step.size(); ++i)
    if (static_cast<unsigned char>(step[i]) < 0x20U || step[i] == 0x7F)
      appendEscaped(result, std::string_view(step).substr(i, 1));
    else
      result += step[i];
  return result;
}

std::string pointerStep(const std::string& pointer, std::size_t index) { return pointer + "/" + std::to_string(index); }

std::string inQuotes(std::string_view text) {
  constexpr std::size_t kLongest = 80;
  const bool cut = text.size() > kLongest;
  if (cut) {
    text = text.substr(0, kLongest);
    while (!text.empty() && !isUtf8(text)) text.remove_suffix(1);
  }
  std::string out = "\"";
  appendEscaped(out, text);
  return out + (cut ? "…\"" : "\"");
}

bool isUtf8(std::string_view text) {
  while (!text.empty()) {
    const std::size_t length = utf8Length(text);
    if (length == 0) return false;
    text.remove_prefix(length);
  }
  return true;
}

}  // namespace dermis
