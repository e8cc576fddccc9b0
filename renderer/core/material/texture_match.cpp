#include "core/material/texture_match.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <initializer_list>
#include <map>
#include <optional>
#include <set>
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

/// A map that a name's ending stands for.
struct Part {
  TextureSlot texture;
  TextureChannel channel = TextureChannel::R;
  bool invert = false;
};

struct Ending {
  std::string word;         ///< without separators: "basecolor"
  std::vector<Part> parts;  ///< several: channels of one file; none: opacity
};

const std::vector<Ending>& endings() {
  static const std::vector<Ending> kEndings = [] {
    using enum TextureSlot;
    constexpr auto kR = TextureChannel::R, kG = TextureChannel::G, kB = TextureChannel::B;
    std::vector<Ending> all;
    const auto packed = [&](std::initializer_list<const char*> words, const std::vector<Part>& parts) {
      for (const char* word : words) all.push_back({word, parts});
    };
    packed({"orm", "arm", "aorm", "occlusionroughnessmetallic", "occlusionroughnessmetalness", "aoroughnessmetallic",
            "aoroughmetal"},
           {{Occlusion, kR}, {Roughness, kG}, {Metallic, kB}});
    packed({"rma", "roughnessmetallicao", "roughnessmetallicocclusion"},
           {{Roughness, kR}, {Metallic, kG}, {Occlusion, kB}});
    packed({"mra", "mrao", "metallicroughnessao", "metallicroughnessocclusion"},
           {{Metallic, kR}, {Roughness, kG}, {Occlusion, kB}});
    packed({"metallicroughness", "metalroughness", "metalrough"}, {{Roughness, kG}, {Metallic, kB}});
    packed({"maskmap"}, {{Metallic, kR}, {Occlusion, kG}, {DetailMask, kB}, {Roughness, TextureChannel::A, true}});
    for (const TextureSlotRow& row : textureSlots()) {
      std::string word;
      for (const char c : std::string(row.suffixes) + ' ') {
        if (isWordCharacter(c)) word += c;
        if (c != ' ') continue;
        if (!word.empty()) all.push_back({word, {{row.slot}}});
        word.clear();
      }
    }
    packed({"gloss", "glossiness", "glossy", "smoothness"}, {{Roughness, kR, true}});
    packed({"opacity", "alpha", "mask", "transparency", "cutout"}, {});
    return all;
  }();
  return kEndings;
}

const Ending* endingNamed(const std::string& word) {
  for (const Ending& ending : endings())
    if (ending.word == word) return &ending;
  return nullptr;
}

/// "left_arm.png" is of an arm; "wall_arm_4k.png" holds occlusion, roughness and metal.
bool isLimb(const Words& words, std::size_t at) {
  static constexpr std::array<std::string_view, 10> kSides = {"left",  "right", "l",     "r",    "upper",
                                                              "lower", "fore",  "under", "both", "the"};
  return words[at] == "arm" && (at == 0 || std::find(kSides.begin(), kSides.end(), words[at - 1]) != kSides.end());
}

struct Found {
  const Ending* ending = nullptr;
  bool last = false;  ///< it stands at the end of the name
};

Found findEnding(const Words& words) {
  std::size_t end = words.size();
  while (end > 0 && isNote(words[end - 1])) --end;
  // Unity's name ends in a word that says nothing elsewhere.
  if (end > 0 && end < words.size() && joined(words, end - 1, 2) == "maskmap") return {endingNamed("maskmap"), true};
  for (std::size_t last = end; last > 0; --last)
    for (std::size_t count = std::min<std::size_t>(3, last); count > 0; --count)
      if (const Ending* ending = endingNamed(joined(words, last - count, count));
          ending != nullptr && (count > 1 || !isLimb(words, last - 1))) {
        // "head_subsurface_mask": what is masked says which map it is.
        if (ending->parts.empty() && last > count && endingNamed(words[last - count - 1]) != nullptr) continue;
        return {ending, last == end};
      }
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
    std::array<int, 5> score;
  };
  using Why = TextureLeftOver::Why;
  TextureMatches result;
  std::map<TextureSlot, Candidate> best;
  std::set<std::filesystem::path> tried;
  for (const std::filesystem::path& file : files) {
    const Words words = wordsOf(file.stem().string());
    const Found found = findEnding(words);
    const bool own = names(words, slot);
    const bool others = std::any_of(allSlots.begin(), allSlots.end(),
                                    [&](const std::string& other) { return other != slot && names(words, other); });
    if (found.ending == nullptr || (others && !own) || found.ending->parts.empty()) {
      result.leftOver.push_back({file, found.ending == nullptr ? Why::NoMapsName
                                       : others && !own        ? Why::OtherSlot
                                                               : Why::Opacity});
      continue;
    }
    tried.insert(file);
    const bool directX = std::find(words.begin(), words.end(), "dx") != words.end() ||
                         lowerCase(file.stem().string()).find("directx") != std::string::npos;
    for (const Part& part : found.ending->parts) {
      const bool isNormal = part.texture == TextureSlot::Normal || part.texture == TextureSlot::DetailNormal;
      const bool alone = found.ending->parts.size() == 1;
      const Candidate candidate{
          {part.texture, file, isNormal && directX, part.invert, part.channel},
          {own ? 1 : 0, alone ? 1 : 0, found.last ? 1 : 0, resolutionOf(words), formatRank(file)}};
      const auto [it, added] = best.try_emplace(part.texture, candidate);
      if (!added && candidate.score > it->second.score) it->second = candidate;
    }
  }
  for (const auto& [texture, candidate] : best) {
    result.maps.push_back(candidate.match);
    tried.erase(candidate.match.path);
  }
  for (const std::filesystem::path& file : tried) result.leftOver.push_back({file, Why::Poorer});
  std::sort(result.leftOver.begin(), result.leftOver.end(),
            [](const TextureLeftOver& a, const TextureLeftOver& b) { return a.path < b.path; });
  return result;
}

}  // namespace dermis
