#include "core/scene/recovery_io.h"

#include <algorithm>

#include "core/base/file_reference.h"
#include "core/base/json_text.h"
#include "core/scene/scene_io.h"

namespace dermis {
namespace {
constexpr const char* kKey = "recovery";
}  // namespace

Result<void> saveRecovery(const std::filesystem::path& path, const Recovery& recovery) {
  Scene scene = recovery.scene;
  for (auto& [slot, binding] : scene.materials)
    if (!binding.presetPath.empty() && !namesNoFile(binding.presetPath) && !binding.missing) binding.edited = true;
  Json about = Json::object();
  about["scene_path"] = recovery.scenePath.string();
  about["saved_at_ms"] = recovery.savedAtMilliseconds;
  scene.unknown[kKey] = std::move(about);
  return saveScene(path, scene);
}

Result<Recovery> loadRecovery(const std::filesystem::path& path, Warnings& warnings) {
  Warnings found;
  Result<Scene> scene = loadScene(path, found, MissingPresets::Keep);
  if (!scene) return tl::unexpected(scene.error());
  const auto about = scene->unknown.find(kKey);
  if (about == scene->unknown.end() || !about->is_object() || !about->value("scene_path", Json()).is_string() ||
      !about->value("saved_at_ms", Json()).is_number_integer())
    return inputError(path.string() + ": /recovery is missing or not what this program writes; open it as a scene");
  Recovery recovery;
  recovery.scenePath = about->at("scene_path").get<std::string>();
  recovery.savedAtMilliseconds = about->at("saved_at_ms").get<std::int64_t>();
  scene->unknown.erase(kKey);
  recovery.scene = std::move(*scene);
  // Our own key is nothing to tell anybody about.
  std::erase_if(found, [](const std::string& line) { return line.find("/recovery") != std::string::npos; });
  warnings.insert(warnings.end(), found.begin(), found.end());
  return recovery;
}

}  // namespace dermis
