#include "core/builtin/environments.h"

#include <array>
#include <vector>

#include "core/base/file_reference.h"
#include "core/base/resources.h"
#include "core/builtin/image_cache.h"
#include "core/io/content_hash.h"
#include "core/light_rig/rig_io.h"
#include "core/light_rig/rig_picture.h"
#include "generated/rig_source_hash.h"

namespace dermis {
namespace {

/// The rigs of resources/rigs in the order in which people look through them.
constexpr std::array<std::string_view, 8> kOrder = {"studio",   "clamshell",   "rim",    "window",
                                                    "overcast", "golden_hour", "clinic", "night_street"};

std::shared_ptr<const EnvironmentImages> environmentOf(std::shared_ptr<const Image> image, const std::string& name) {
  auto environment = std::make_shared<EnvironmentImages>();
  environment->contentHash = contentHash(image->pixels);
  environment->name = name;
  environment->latLong = std::move(image);
  return environment;
}

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
  return environmentOf(std::move(*image), name);
}

std::shared_ptr<const EnvironmentImages> builtinEnvironment(std::string_view id, int width) {
  const auto rig = builtinRig(id);
  if (!rig) return nullptr;
  // Painted once: reading takes a tenth of the time.
  const ImageKey key = {kRigSourceHash,
                        std::to_string(width) + '|' + std::string(resource("rigs/" + std::string(id) + ".json"))};
  if (auto kept = readCachedImage(key, rig->name))
    return environmentOf(std::make_shared<const Image>(std::move(*kept)), std::string(id));
  auto painted = environmentOfRig(*rig, std::string(id), width).value();
  writeCachedImage(key, *painted->latLong);
  return painted;
}

}  // namespace dermis
