#include "core/material/texture_match.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <optional>
#include <string_view>

#include "core/base/lower_case.h"

namespace dermis {
namespace {

using Words = std::vector<std::string>;

bool isLower(char c) { return std::islower(static_cast<unsigned char>(c)) != 0; }
bool isUpper(char c) { return std::isupper(static_cast<unsigned char>(c)) != 0; }
bool isDigit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }
/// Letters beyond ASCII count as letters.
bool isWordCharacter(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || static_cast<unsigned char>(c) >= 0x80;
}

/// "HeadBaseColor_4k" → head base color 4k.
Words wordsOf(const std::string& name) {
  Words words;
  for (std::size_t i = 0; i < name.size(); ++i) {
    const char c = name[i];
    if (!isWordCharacter(c)) continue;
    const bool first = i == 0 || !isWordCharacter(name[i - 1]);
    const bool hump = !first && isUpper(c) && isLower(name[i - 1]);
    const bool acronymEnds =
        !first && isUpper(c) && isUpper(name[i - 1]) && i + 1 < name.size() && isLower(name[i + 1]);
    // "4k" and "16bit" stay together; "head2" and "normal4k" do not.
    const bool number = !first && isDigit(c) && !isDigit(name[i - 1]);
    if (first || hump || acronymEnds || number) words.emplace_back();
    words.back() += c;
  }
  for (std::string& word : words) word = lowerCase(word);
  return words;
}

std::string joined(const Words& words, std::size_t from, std::size_t count) {
  std::string text;
  for (std::size_t i = from; i < from + count; ++i) text += words[i];
  return text;
}

/// What a name may carry besides the map's own: it says nothing about which map it is.
bool isNote(const std::string& word) {
  static constexpr std::array<std::string_view, 21> kNotes = {
      "gl",  "opengl", "open", "ogl",   "dx",    "directx", "direct", "x",     "srgb", "linear", "lin",
      "raw", "bit",    "8bit", "16bit", "32bit", "udim",    "acescg", "final", "map",  "tex"};
  if (std::find(kNotes.begin(), kNotes.end(), word) != kNotes.end()) return true;
  const std::size_t digits = word.find_first_not_of("0123456789");
  return digits == std::string::npos || (digits > 0 && (word.substr(digits) == "k" || word.substr(digits) == "x"));
}

int resolutionOf(const Words& words) {
  int largest = 0;
  for (const std::string& word : words) {
    const std::size_t digits = word.find_first_not_of("0123456789");
    if (digits == 0 || word.size() > 6) continue;
    const int number = std::stoi(word);
    if (digits != std::string::npos && word.substr(digits) == "k") largest = std::max(largest, number * 1024);
    if (digits == std::string::npos &&
        (number == 512 || number == 1024 || number == 2048 || number == 4096 || number == 8192))
      largest = std::max(largest, number);
  }
  return largest;
}

/// The deeper a format can be, the better.
int formatRank(const std::filesystem::path& path) {
  static constexpr std::array<std::string_view, 6> kWorstFirst = {".jpeg", ".jpg", ".tga", ".png", ".tif", ".exr"};
  const auto found = std::find(kWorstFirst.begin(), kWorstFirst.end(), lowerCase(path.extension().string()));
  return found == kWorstFirst.end() ? 0 : static_cast<int>(found - kWorstFirst.begin());
}

struct Ending {
  std::string word;  ///< without separators: "basecolor"
  TextureSlot texture;
  bool invert;
};

const std::vector<Ending>& endings() {
  static const std::vector<Ending> kEndings = [] {
    std::vector<Ending> all;
    for (const TextureSlotRow& row : textureSlots()) {
      std::string word;
      for (const char c : std::string(row.suffixes) + ' ') {
        if (isWordCharacter(c)) word += c;
        if (c != ' ') continue;
        if (!word.empty()) all.push_back({word, row.slot, false});
        word.clear();
      }
    }
    for (const char* gloss : {"gloss", "glossiness", "glossy", "smoothness"})
      all.push_back({gloss, TextureSlot::Roughness, true});
    return all;
  }();
  return kEndings;
}

const Ending* endingNamed(const std::string& word) {
  for (const Ending& ending : endings())
    if (ending.word == word) return &ending;
  return nullptr;
}

struct Found {
  const Ending* ending = nullptr;
  bool last = false;  ///< it stands at the end of the name
};

Found findEnding(const Words& words) {
  std::size_t end = words.size();
  while (end > 0 && isNote(words[end - 1])) --end;
  for (std::size_t last = end; last > 0; --last)
    for (std::size_t count = std::min<std::size_t>(3, last); count > 0; --count)
      if (const Ending* ending = endingNamed(joined(words, last - count, count))) return {ending, last == end};
  // Nothing separates "faceroughness"; short endings would be found in ordinary words.
  if (end == 0) return {};
  const Ending* longest = nullptr;
  for (const Ending& ending : endings())
    if (ending.word.size() >= 5 && words[end - 1].ends_with(ending.word) &&
        (longest == nullptr || ending.word.size() > longest->word.size()))
      longest = &ending;
  return {longest, true};
}

bool names(const Words& words, const std::string& slot) {
  const Words wanted = wordsOf(slot);
  if (wanted.empty() || endingNamed(joined(wanted, 0, wanted.size())) != nullptr) return false;
  return std::search(words.begin(), words.end(), wanted.begin(), wanted.end()) != words.end();
}

}  // namespace

TextureMatches matchTextures(std::vector<std::filesystem::path> files, const std::string& slot,
                             const std::vector<std::string>& allSlots) {
  std::sort(files.begin(), files.end());
  struct Candidate {
    TextureMatch match;
    std::array<int, 4> score;
  };
  TextureMatches result;
  std::map<TextureSlot, Candidate> best;
  for (const std::filesystem::path& file : files) {
    const Words words = wordsOf(file.stem().string());
    const Found found = findEnding(words);
    const bool own = names(words, slot);
    const bool others = std::any_of(allSlots.begin(), allSlots.end(),
                                    [&](const std::string& other) { return other != slot && names(words, other); });
    if (found.ending == nullptr || (others && !own)) {
      result.leftOver.push_back(file);
      continue;
    }
    const bool isNormal =
        found.ending->texture == TextureSlot::Normal || found.ending->texture == TextureSlot::DetailNormal;
    const bool directX = std::find(words.begin(), words.end(), "dx") != words.end() ||
                         lowerCase(file.stem().string()).find("directx") != std::string::npos;
    const Candidate candidate{{found.ending->texture, file, isNormal && directX, found.ending->invert},
                              {own ? 1 : 0, found.last ? 1 : 0, resolutionOf(words), formatRank(file)}};
    const auto [it, added] = best.try_emplace(found.ending->texture, candidate);
    if (added) continue;
    const bool better = candidate.score > it->second.score;
    result.leftOver.push_back(better ? it->second.match.path : file);
    if (better) it->second = candidate;
  }
  for (const auto& [texture, candidate] : best) result.maps.push_back(candidate.match);
  std::sort(result.leftOver.begin(), result.leftOver.end());
  return result;
}

}  // namespace dermis
