#include "core/base/json_fields.h"

#include <algorithm>
#include <cmath>

#include "core/base/number_format.h"

namespace dermis {
namespace {

const Json& emptyObject() {
  static const Json kEmpty = Json::object();
  return kEmpty;
}

/// At most this many unknown keys of one object are reported one by one.
constexpr std::size_t kMaxReported = 20;

}  // namespace

void JsonReport::refuse(const std::string& pointer, const std::string& what) {
  if (!error) error = Error{Error::Kind::Input, sentence(pointer, what)};
}

void JsonReport::warn(const std::string& pointer, const std::string& what) {
  warnings.push_back(sentence(pointer, what));
}

std::string JsonReport::sentence(const std::string& pointer, const std::string& what) const {
  // The root's pointer is the empty text; a sentence needs a noun.
  return (file.empty() ? "" : file + ": ") + (pointer.empty() ? "the root" : pointer) + " " + what;
}

std::string_view typeName(const Json& value) {
  switch (value.type()) {
    case Json::value_t::null:
      return "null";
    case Json::value_t::object:
      return "an object";
    case Json::value_t::array:
      return "an array";
    case Json::value_t::string:
      return "a string";
    case Json::value_t::boolean:
      return "true or false";
    default:
      return "a number";
  }
}

std::optional<float> readNumber(const Json& value, const std::string& pointer, JsonReport& report) {
  if (!value.is_number()) {
    report.refuse(pointer, "must be a number, not " + std::string(typeName(value)));
    return std::nullopt;
  }
  const auto number = value.get<double>();
  if (std::abs(number) <= std::numeric_limits<float>::max()) return static_cast<float>(number);
  report.refuse(pointer, "is too large for a 32-bit number");
  return std::nullopt;
}

std::optional<std::vector<float>> readNumbers(const Json& value, std::size_t count, const std::string& pointer,
                                              JsonReport& report) {
  const std::string wanted = "must be an array of " + std::to_string(count) + " numbers, not ";
  if (!value.is_array()) {
    report.refuse(pointer, wanted + std::string(typeName(value)));
    return std::nullopt;
  }
  if (value.size() != count) {
    report.refuse(pointer, wanted + std::to_string(value.size()));
    return std::nullopt;
  }
  std::vector<float> numbers;
  for (std::size_t i = 0; i < count; ++i) {
    const auto number = readNumber(value[i], pointerStep(pointer, i), report);
    if (!number) return std::nullopt;
    numbers.push_back(*number);
  }
  return numbers;
}

bool hasDirection(const glm::vec3& vector) {
  const double length = glm::length(glm::dvec3(vector));
  return length > 1e-9 && length < 1e9;
}

JsonFields::JsonFields(const Json& object, std::string pointer, JsonReport& report)
    : m_object(object.is_object() ? object : emptyObject()), m_pointer(std::move(pointer)), m_report(report) {
  if (!object.is_object()) m_report.refuse(m_pointer, "must be an object, not " + std::string(typeName(object)));
}

const Json* JsonFields::find(std::string_view key) {
  m_asked.emplace_back(key);
  const auto it = m_object.find(key);
  return it == m_object.end() ? nullptr : &*it;
}

void JsonFields::readVector(std::string_view key, float* target, std::size_t count, Range range, bool oneForAll) {
  const Json* value = find(key);
  if (value == nullptr) return;
  std::vector<float> numbers;
  if (count == 1 || (oneForAll && value->is_number())) {
    const auto number = readNumber(*value, pointerTo(key), m_report);
    if (!number) return;
    numbers.assign(count, *number);
  } else {
    auto read = readNumbers(*value, count, pointerTo(key), m_report);
    if (!read) return;
    numbers = std::move(*read);
  }
  bool clamped = false;
  for (std::size_t i = 0; i < count; ++i) {
    target[i] = std::clamp(numbers[i], range.lowest, range.highest);
    clamped = clamped || target[i] != numbers[i];
  }
  if (clamped)
    m_report.warn(pointerTo(key), "is clamped to its range, " + shortestDecimal(range.lowest) + " to " +
                                      shortestDecimal(range.highest));
}

void JsonFields::read(std::string_view key, float& target, Range range) { readVector(key, &target, 1, range, false); }
void JsonFields::read(std::string_view key, glm::vec2& target, Range range) {
  readVector(key, &target.x, 2, range, false);
}
void JsonFields::read(std::string_view key, glm::vec3& target, Range range) {
  readVector(key, &target.x, 3, range, false);
}
void JsonFields::readColour(std::string_view key, glm::vec3& target, Range range) {
  readVector(key, &target.x, 3, range, true);
}

void JsonFields::read(std::string_view key, bool& target) {
  const Json* value = find(key);
  if (value == nullptr) return;
  if (value->is_boolean())
    target = value->get<bool>();
  else
    m_report.refuse(pointerTo(key), "must be true or false, not " + std::string(typeName(*value)));
}

void JsonFields::read(std::string_view key, std::string& target) {
  const Json* value = find(key);
  if (value == nullptr) return;
  if (value->is_string())
    target = value->get<std::string>();
  else
    m_report.refuse(pointerTo(key), "must be a string, not " + std::string(typeName(*value)));
}

void JsonFields::readWord(std::string_view key, std::initializer_list<std::string_view> words, int& index) {
  const Json* value = find(key);
  if (value == nullptr) return;
  if (!value->is_string())
    return m_report.refuse(pointerTo(key), "must be " + listed(words) + ", not " + std::string(typeName(*value)));
  const auto& text = value->get_ref<const std::string&>();
  const auto word = std::find(words.begin(), words.end(), text);
  if (word == words.end())
    return m_report.refuse(pointerTo(key), "must be " + listed(words) + ", not " + inQuotes(text));
  index = static_cast<int>(word - words.begin());
}

Json JsonFields::unknown() {
  Json rest = Json::object();
  std::size_t count = 0;
  for (const auto& [key, value] : m_object.items()) {
    if (std::find(m_asked.begin(), m_asked.end(), key) != m_asked.end()) continue;
    appendMember(rest, key, value);
    if (++count <= kMaxReported) m_report.warn(pointerTo(key), "is not known to this version and is kept as it is");
  }
  if (count > kMaxReported)
    m_report.warn(m_pointer,
                  "has " + std::to_string(count - kMaxReported) + " more unknown keys, all kept as they are");
  return rest;
}

void checkFormat(JsonFields& root, std::string_view format, int version, bool mustHave) {
  JsonReport& report = root.report();
  const std::string wanted = "must be \"" + std::string(format) + "\"";
  if (const Json* value = root.find("format"); value == nullptr) {
    if (mustHave) report.refuse(root.pointerTo("format"), "is missing; it " + wanted);
  } else if (!value->is_string()) {
    report.refuse(root.pointerTo("format"), wanted + ", not " + std::string(typeName(*value)));
  } else if (value->get_ref<const std::string&>() != format) {
    report.refuse(root.pointerTo("format"), wanted + ", not " + inQuotes(value->get_ref<const std::string&>()));
  }

  const std::string pointer = root.pointerTo("version");
  const Json* value = root.find("version");
  if (value == nullptr) {
    if (mustHave) report.refuse(pointer, "is missing; it must be " + std::to_string(version));
    return;
  }
  if (!value->is_number()) return report.refuse(pointer, "must be a number, not " + std::string(typeName(*value)));
  const double number = value->get<double>();
  const std::string shown = shortestDecimal(number);
  if (number > version)
    return report.refuse(pointer, "is " + shown + ", a format from the future: this version of Dermis reads up to " +
                                      std::to_string(version) + "; update Dermis");
  if (number != version) report.refuse(pointer, "must be " + std::to_string(version) + ", not " + shown);
}

}  // namespace dermis
