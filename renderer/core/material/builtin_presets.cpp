#include "core/material/builtin_presets.h"

#include <algorithm>
#include <tuple>

#include "core/base/file_reference.h"
#include "core/base/resources.h"
#include "core/material/preset_io.h"

namespace dermis {
namespace {

constexpr std::string_view kFolder = "presets/";
constexpr std::string_view kEnding = ".json";

}  // namespace

const std::vector<BuiltinPreset>& builtinPresets() {
  static const std::vector<BuiltinPreset> kPresets = [] {
    struct Row {
      BuiltinPreset preset;
      std::tuple<ShadingModel, int, std::string> order;
    };
    std::vector<Row> rows;
    for (std::string_view path : resourcePaths(kFolder)) {
      if (!path.ends_with(kEnding)) continue;
      path.remove_prefix(kFolder.size());
      path.remove_suffix(kEnding.size());
      Warnings warnings;
      const auto material = loadBuiltinPreset(path, warnings);
      // The tones first, then other skins, what else diffuses, and the other shading models.
      const std::string id(path);
      const int rank = id.starts_with("skin_tone_") ? 0 : id.starts_with("skin_") ? 1 : 2;
      const ShadingModel model = material ? material->model : ShadingModel::Skin;
      rows.push_back({{id, material ? material->name : id}, {model, rank, id}});
    }
    std::ranges::sort(rows, {}, &Row::order);
    std::vector<BuiltinPreset> presets;
    presets.reserve(rows.size());
    for (Row& row : rows) presets.push_back(std::move(row.preset));
    return presets;
  }();
  return kPresets;
}

Result<Material> loadBuiltinPreset(std::string_view id, Warnings& warnings) {
  const std::string name = builtinReference(id);
  const std::string_view text = resource(std::string(kFolder) + std::string(id) + std::string(kEnding));
  if (text.empty()) return inputError(name + " is not a preset that this program carries");
  return readPreset(text, name, {}, warnings);
}

}  // namespace dermis
