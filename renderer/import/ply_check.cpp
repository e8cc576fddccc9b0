#include "import/ply_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <vector>

#include "import/text.h"

namespace dermis::import {
namespace {

struct PlyError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct Property {
  std::size_t bytes = 0;       ///< of the value, or of one list item
  std::size_t countBytes = 0;  ///< of a list's count; 0 for a single value
};
struct Element {
  std::string name;
  std::uint64_t count = 0;
  std::vector<Property> properties;
};
enum class Encoding { Text, Little, Big };
struct Header {
  Encoding encoding = Encoding::Text;
  std::vector<Element> elements;
  std::size_t bodyAt = 0;
};

std::vector<std::string_view> words(std::string_view line) {
  std::vector<std::string_view> out;
  for (std::size_t at = line.find_first_not_of(" \t"); at != std::string_view::npos;) {
    const std::size_t end = std::min(line.find_first_of(" \t", at), line.size());
    out.push_back(line.substr(at, end - at));
    at = line.find_first_not_of(" \t", end);
  }
  return out;
}

std::size_t typeBytes(std::string_view type) {
  constexpr std::array<std::pair<std::string_view, std::size_t>, 16> kTypes = {{{"char", 1},
                                                                                {"uchar", 1},
                                                                                {"int8", 1},
                                                                                {"uint8", 1},
                                                                                {"short", 2},
                                                                                {"ushort", 2},
                                                                                {"int16", 2},
                                                                                {"uint16", 2},
                                                                                {"int", 4},
                                                                                {"uint", 4},
                                                                                {"int32", 4},
                                                                                {"uint32", 4},
                                                                                {"float", 4},
                                                                                {"float32", 4},
                                                                                {"double", 8},
                                                                                {"float64", 8}}};
  for (const auto& [name, bytes] : kTypes)
    if (name == type) return bytes;
  throw PlyError(fmt::format("the header has an unknown type \"{}\"", phrase(type, 30)));
}

Property propertyOf(const std::vector<std::string_view>& line) {
  const bool isList = line.size() == 5 && line[1] == "list";
  if (!isList && line.size() != 3) throw PlyError("the header has a property that is not complete");
  Property property;
  property.bytes = typeBytes(line[isList ? 3 : 1]);
  property.countBytes = isList ? typeBytes(line[2]) : 0;
  if (property.countBytes > 4) throw PlyError("the header has a list counted by a fraction");
  return property;
}

Header readHeader(std::string_view bytes) {
  if (!bytes.starts_with("ply")) throw PlyError("it does not begin with \"ply\"");
  constexpr std::size_t kLongestHeader = 1 << 20;
  Header header;
  bool hasFormat = false;
  std::size_t at = 0;
  while (at < std::min(bytes.size(), kLongestHeader)) {
    const std::size_t end = bytes.find('\n', at);
    if (end == std::string_view::npos) break;
    std::string_view text = bytes.substr(at, end - at);
    if (!text.empty() && text.back() == '\r') text.remove_suffix(1);
    const std::vector<std::string_view> line = words(text);
    at = end + 1;
    if (line.empty()) throw PlyError("the header has an empty line");
    if (line[0] == "ply" || line[0] == "comment" || line[0] == "obj_info") continue;
    if (line[0] == "end_header") {
      if (!hasFormat) throw PlyError("the header names no format");
      header.bodyAt = at;
      return header;
    }
    if (line[0] == "format" && line.size() >= 2) {
      hasFormat = true;
      if (line[1] == "binary_little_endian")
        header.encoding = Encoding::Little;
      else if (line[1] == "binary_big_endian")
        header.encoding = Encoding::Big;
      else if (line[1] != "ascii")
        throw PlyError(fmt::format("the header has an unknown format \"{}\"", phrase(line[1], 30)));
    } else if (line[0] == "element" && line.size() == 3) {
      Element element;
      element.name = phrase(line[1], 40);
      const auto [stop, error] = std::from_chars(line[2].data(), line[2].data() + line[2].size(), element.count);
      if (error != std::errc() || stop != line[2].data() + line[2].size())
        throw PlyError(fmt::format("the header has an impossible number of elements \"{}\"", phrase(line[2], 30)));
      header.elements.push_back(std::move(element));
    } else if (line[0] == "property" && !header.elements.empty()) {
      header.elements.back().properties.push_back(propertyOf(line));
    } else {
      throw PlyError(fmt::format("the header has a line that cannot be read, \"{}\"", phrase(text, 40)));
    }
  }
  throw PlyError("the header is cut off before end_header");
}

std::uint32_t listLength(const char* at, std::size_t bytes, Encoding encoding) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < bytes; ++i) {
    const std::size_t place = encoding == Encoding::Big ? i : bytes - 1 - i;
    value = value << 8U | static_cast<std::uint8_t>(at[place]);
  }
  return value;
}

void cutOff(const Element& element, std::uint64_t found) {
  throw PlyError(fmt::format("the header promises {} elements \"{}\", but the file ends after {}", element.count,
                             element.name, found));
}

void checkBinaryBody(const Header& header, std::string_view body) {
  std::size_t at = 0;
  for (const Element& element : header.elements) {
    std::size_t fixed = 0;
    bool lists = false;
    for (const Property& property : element.properties) {
      lists = lists || property.countBytes > 0;
      fixed += property.countBytes > 0 ? 0 : property.bytes;
    }
    if (!lists) {
      if (fixed == 0) continue;
      if (element.count > (body.size() - at) / fixed) cutOff(element, (body.size() - at) / fixed);
      at += static_cast<std::size_t>(element.count) * fixed;
      continue;
    }
    for (std::uint64_t i = 0; i < element.count; ++i)
      for (const Property& property : element.properties) {
        if (property.countBytes > body.size() - at) cutOff(element, i);
        const std::size_t items =
            property.countBytes > 0 ? listLength(body.data() + at, property.countBytes, header.encoding) : 1;
        at += property.countBytes;
        if (items > (body.size() - at) / property.bytes) cutOff(element, i);
        at += items * property.bytes;
      }
  }
}

/// One line an element, of which each has at least a value a property.
void checkTextBody(const Header& header, std::string_view body) {
  std::size_t at = 0;
  for (const Element& element : header.elements)
    for (std::uint64_t i = 0; i < element.count && !element.properties.empty(); ++i) {
      at = std::min(body.find_first_not_of(" \t\r\n", at), body.size());
      if (at == body.size()) cutOff(element, i);
      const std::size_t end = std::min(body.find('\n', at), body.size());
      if (end - at + 1 < 2 * element.properties.size()) cutOff(element, i);
      at = end;
    }
}

}  // namespace

Result<void> checkPly(std::string_view bytes, const std::string& name) try {
  const Header header = readHeader(bytes);
  std::uint64_t total = 0;
  for (const Element& element : header.elements) {
    if (element.count > bytes.size())
      throw PlyError(fmt::format("the header promises {} elements \"{}\", but the file holds only {} bytes",
                                 element.count, element.name, bytes.size()));
    total += element.count;
  }
  if (total == 0) throw PlyError("it holds no elements");
  const std::string_view body = bytes.substr(header.bodyAt);
  if (header.encoding == Encoding::Text)
    checkTextBody(header, body);
  else
    checkBinaryBody(header, body);
  return {};
} catch (const PlyError& error) {
  return inputError(fmt::format("{}: not usable PLY: {}; export it again", name, error.what()));
}

}  // namespace dermis::import
