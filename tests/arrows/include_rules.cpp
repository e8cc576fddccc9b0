#include "arrows/include_rules.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <sstream>

namespace dermis::arrows {
namespace {

bool isSource(const std::filesystem::path& path) {
  const std::string extension = path.extension().string();
  return extension == ".cpp" || extension == ".h";
}

bool isBelow(const std::filesystem::path& path, const std::filesystem::path& folder) {
  return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first == folder.end();
}

}  // namespace

std::vector<Include> includesOf(std::string_view text) {
  static const std::regex kInclude(R"(^\s*#\s*include\s*[<"]([^>"]+)[>"].*)");
  std::vector<Include> includes;
  std::istringstream lines{std::string(text)};
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    std::smatch match;
    if (std::regex_match(line, match, kInclude)) includes.push_back({match[1].str(), number});
  }
  return includes;
}

std::vector<std::string> violations(const std::filesystem::path& folder, const std::vector<std::regex>& never,
                                    const std::vector<std::string>& except) {
  std::vector<std::string> found;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    const std::filesystem::path relative = std::filesystem::relative(entry.path(), folder);
    const bool anotherLayers =
        std::any_of(except.begin(), except.end(), [&](const std::string& other) { return isBelow(relative, other); });
    if (!entry.is_regular_file() || !isSource(entry.path()) || anotherLayers) continue;
    std::ifstream file(entry.path());
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    for (const Include& include : includesOf(text))
      if (std::any_of(never.begin(), never.end(),
                      [&](const std::regex& pattern) { return std::regex_match(include.header, pattern); }))
        found.push_back(entry.path().string() + ":" + std::to_string(include.line) + " includes " + include.header);
  }
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace dermis::arrows
