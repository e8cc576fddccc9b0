#include "core/material/builtin_presets.h"

#include "core/base/resources.h"
#include "core/material/preset_io.h"

namespace dermis {
namespace {

constexpr std::string_view kFolder = "presets/";
constexpr std::string_view kEnding = ".json";

}  // namespace

const std::vector<BuiltinPreset>& builtinPresets() {
  static const std::vector<BuiltinPreset> kPresets = [] {
    std::vector<BuiltinPreset> presets;
    for (std::string_view path : resourcePaths(kFolder)) {
      if (!path.ends_with(kEnding)) continue;
      path.remove_prefix(kFolder.size());
      path.remove_suffix(kEnding.size());
      Warnings warnings;
      const auto material = loadBuiltinPreset(path, warnings);
      presets.push_back({std::string(path), material ? material->name : std::string(path)});
    }
    return presets;
  }();
  return kPresets;
}

Result<Material> loadBuiltinPreset(std::string_view id, Warnings& warnings) {
  const std::string name = "builtin:" + std::string(id);
  const std::string_view text = resource(std::string(kFolder) + std::string(id) + std::string(kEnding));
  if (text.empty()) return inputError(name + " is not a preset that this program carries");
  return readPreset(text, name, {}, warnings);
}

}  // namespace dermis
