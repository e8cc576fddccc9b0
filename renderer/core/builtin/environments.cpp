#include "core/builtin/environments.h"

#include <array>
#include <vector>

#include "core/base/file_reference.h"
#include "core/base/resources.h"
#include "core/io/content_hash.h"
#include "core/light_rig/rig_io.h"
#include "core/light_rig/rig_picture.h"

namespace dermis {
namespace {

/// The rigs of resources/rigs in the order in which people look through them.
constexpr std::array<std::string_view, 8> kOrder = {"studio",   "clamshell",   "rim",    "window",
                                                    "overcast", "golden_hour", "clinic", "night_street"};

}  // namespace

std::span<const BuiltinEnvironmentRow> builtinEnvironments() {
  static const std::vector<BuiltinEnvironmentRow> kRows = [] {
    std::vector<BuiltinEnvironmentRow> rows;
    for (const std::string_view id : kOrder)
      if (const auto rig = builtinRig(id)) rows.push_back({std::string(id), rig->name, rig->description});
    return rows;
  }();
  return kRows;
}

Result<LightRig> builtinRig(std::string_view id) {
  const std::string name = builtinReference(id);
  const std::string_view text = resource("rigs/" + std::string(id) + ".json");
  if (text.empty()) return inputError(name + " is not a light rig that this program carries");
  Warnings warnings;
  return readRig(text, name, warnings);
}

Result<std::shared_ptr<const EnvironmentImages>> environmentOfRig(const LightRig& rig, const std::string& name,
                                                                  int width, const std::stop_token& stop) {
  auto image = rigPicture(rig, width, stop);
  if (!image) return tl::unexpected(image.error());
  auto environment = std::make_shared<EnvironmentImages>();
  environment->contentHash = contentHash((*image)->pixels);
  environment->name = name;
  environment->latLong = std::move(*image);
  return environment;
}

std::shared_ptr<const EnvironmentImages> builtinEnvironment(std::string_view id, int width) {
  const auto rig = builtinRig(id);
  if (!rig) return nullptr;
  return environmentOfRig(*rig, std::string(id), width).value();
}

}  // namespace dermis
