// Reading an object of one of our files key by key, with one sentence where a value is not what it must be.
#pragma once

#include <glm/glm.hpp>
#include <initializer_list>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/json_text.h"
#include "core/base/result.h"

namespace dermis {

/// What is found while one file is read: the first thing wrong with it, and warnings. Reading goes on after an error
/// (its results are thrown away), so that callers need not look after every value.
struct JsonReport {
  std::string file;
  Warnings& warnings;
  std::optional<Error> error = std::nullopt;

  /// With `file`, where there is one: "fair.json: /parameters/specular.ior must be …". The first sentence stays.
  void refuse(const std::string& pointer, const std::string& what);
  void warn(const std::string& pointer, const std::string& what);
  [[nodiscard]] std::string sentence(const std::string& pointer, const std::string& what) const;
};

/// "a number", "a string", … for sentences.
[[nodiscard]] std::string_view typeName(const Json& value);

/// A finite number that a 32-bit float can hold; else refuses and returns nothing.
[[nodiscard]] std::optional<float> readNumber(const Json& value, const std::string& pointer, JsonReport& report);
/// Whether a vector is neither zero nor so long or short that normalising it would leave the range of a float.
[[nodiscard]] bool hasDirection(const glm::vec3& vector);
/// Exactly `count` of them.
[[nodiscard]] std::optional<std::vector<float>> readNumbers(const Json& value, std::size_t count,
                                                            const std::string& pointer, JsonReport& report);

struct Range {
  float lowest = std::numeric_limits<float>::lowest();
  float highest = std::numeric_limits<float>::max();
};

/// One object. Every read leaves the target as it is where the key is absent. Keys that were never asked for are what
/// unknown() returns.
class JsonFields {
 public:
  /// Anything but an object is refused and read as an empty one.
  JsonFields(const Json& object, std::string pointer, JsonReport& report);

  /// The value, or null where the key is absent.
  const Json* find(std::string_view key);
  [[nodiscard]] std::string pointerTo(std::string_view key) const { return pointerStep(m_pointer, key); }
  [[nodiscard]] JsonReport& report() { return m_report; }

  void read(std::string_view key, float& target, Range range = {});  ///< outside: clamped with a warning
  void read(std::string_view key, glm::vec2& target, Range range = {});
  void read(std::string_view key, glm::vec3& target, Range range = {});
  void read(std::string_view key, bool& target);
  void read(std::string_view key, std::string& target);
  /// A colour: three numbers, or one for all channels.
  void readColour(std::string_view key, glm::vec3& target, Range range = {});
  /// One of `words`, as its index.
  void readWord(std::string_view key, std::initializer_list<std::string_view> words, int& index);

  /// The keys nobody asked for with their values; each is reported as kept.
  [[nodiscard]] Json unknown();

 private:
  void readVector(std::string_view key, float* target, std::size_t count, Range range, bool oneForAll);

  const Json& m_object;
  std::string m_pointer;
  JsonReport& m_report;
  std::vector<std::string> m_asked;
};

/// "a, b or c".
template <class Words>
[[nodiscard]] std::string listed(const Words& words) {
  std::string text;
  std::size_t i = 0;
  for (const auto& word : words) {
    if (i > 0) text += i + 1 == words.size() ? " or " : ", ";
    text += word;
    ++i;
  }
  return text;
}

/// Checks `format` and `version` of the file's root. A file must have both; an object inside another file may leave
/// them out (`mustHave` false).
void checkFormat(JsonFields& root, std::string_view format, int version, bool mustHave);

}  // namespace dermis
