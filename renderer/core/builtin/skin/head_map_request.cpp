#include <algorithm>
#include <bit>
#include <cmath>
#include <iterator>

#include "core/base/json_fields.h"
#include "core/base/number_format.h"
#include "core/builtin/skin/head_maps.h"

namespace dermis {
namespace {

constexpr std::array<std::string_view, kHeadMapCount> kNames = {"head_albedo",    "head_normal",    "head_displacement",
                                                                "head_roughness", "head_cavity",    "head_detail",
                                                                "head_occlusion", "head_thickness", "head_region"};

/// A setting of the look, and what it may be.
struct Setting {
  std::string_view key;
  float lowest, highest;
  float skin::Look::*member;
};
constexpr std::array<Setting, 7> kSettings = {{{"tone", 1.0F, 6.0F, &skin::Look::tone},
                                               {"melanin", 0.05F, 20.0F, &skin::Look::melanin},
                                               {"haemoglobin", 0.05F, 20.0F, &skin::Look::haemoglobin},
                                               {"age", 1.0F, 100.0F, &skin::Look::age},
                                               {"freckles", 0.0F, 1.0F, &skin::Look::freckles},
                                               {"flush", 0.0F, 1.0F, &skin::Look::flush},
                                               {"stubble", 0.0F, 1.0F, &skin::Look::stubble}}};

tl::unexpected<Error> outside(std::string_view key, float lowest, float highest) {
  return inputError("has a " + std::string(key) + " that is no number from " + shortestDecimal(lowest) + " to " +
                    shortestDecimal(highest));
}

Result<void> readSetting(std::string_view key, std::string_view value, HeadMapRequest& request) {
  const std::optional<float> number = parseFloat(value);
  const auto within = [&](float lowest, float highest) { return number && *number >= lowest && *number <= highest; };
  for (const Setting& setting : kSettings) {
    if (setting.key != key) continue;
    if (!within(setting.lowest, setting.highest)) return outside(key, setting.lowest, setting.highest);
    request.look.*setting.member = *number;
    return {};
  }
  const bool whole = number && *number == std::floor(*number);
  if (key == "seed") {
    constexpr float kMostSeeds = 1e6F;
    if (!whole || !within(0.0F, kMostSeeds)) return outside(key, 0.0F, kMostSeeds);
    request.look.seed = static_cast<std::uint32_t>(*number);
    return {};
  }
  if (key == "size") {
    if (!whole || !within(64.0F, 8192.0F) || !std::has_single_bit(static_cast<unsigned>(*number)))
      return inputError("has a size that is no power of two from 64 to 8192");
    request.size = static_cast<int>(*number);
    return {};
  }
  if (key == "relative") {
    if (!whole || !within(0.0F, 1.0F)) return inputError("has a relative that is neither 0 nor 1");
    request.relative = *number == 1.0F;
    return {};
  }
  if (key == "region") {
    std::vector<std::string_view> regions;
    for (std::size_t i = 0; i < kHeadRegionCount; ++i) regions.push_back(headRegionName(static_cast<HeadRegion>(i)));
    const auto found = std::find(regions.begin(), regions.end(), value);
    if (found == regions.end()) return inputError("has a region that there is not; there are " + listed(regions));
    request.region = static_cast<HeadRegion>(found - regions.begin());
    return {};
  }
  std::vector<std::string_view> known;
  known.reserve(std::size(kSettings) + 4);
  for (const Setting& setting : kSettings) known.push_back(setting.key);
  known.insert(known.end(), {"seed", "size", "relative", "region"});
  return inputError("has no setting \"" + std::string(key) + "\"; there are " + listed(known));
}

}  // namespace

std::array<std::string_view, kHeadMapCount> headMapNames() { return kNames; }

Result<HeadMapRequest> parseHeadMap(std::string_view name) {
  const std::size_t mark = name.find('?');
  const auto found = std::find(kNames.begin(), kNames.end(), name.substr(0, mark));
  if (found == kNames.end()) return inputError("is not a map that this program carries");
  HeadMapRequest request;
  request.map = static_cast<HeadMap>(found - kNames.begin());
  std::string_view rest = mark == std::string_view::npos ? std::string_view() : name.substr(mark + 1);
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find('&'), rest.size());
    const std::string_view setting = rest.substr(0, end);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    const std::size_t equals = setting.find('=');
    if (equals == std::string_view::npos)
      return inputError("has a setting \"" + std::string(setting) + "\" without a value; write age=40");
    if (const auto read = readSetting(setting.substr(0, equals), setting.substr(equals + 1), request); !read)
      return tl::unexpected(read.error());
  }
  return request;
}

}  // namespace dermis
