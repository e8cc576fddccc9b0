#include "core/scene/scene_io.h"

#include <algorithm>
#include <limits>

#include "core/base/file_io.h"
#include "core/base/file_reference.h"
#include "core/base/json_fields.h"
#include "core/base/json_text.h"
#include "core/base/number_format.h"
#include "core/light_rig/rig_io.h"
#include "core/material/preset_io.h"
#include "core/scene/cameras.h"

namespace dermis {
namespace {

namespace fs = std::filesystem;

constexpr float kLargest = std::numeric_limits<float>::max();
constexpr Range kNotNegative{0.0F, kLargest};
constexpr Range kStops{-32.0F, 32.0F};
/// More than any model has; a file of nothing but slots or parts would fill the memory.
constexpr std::size_t kMaxSlots = 4096;
constexpr std::size_t kMaxParts = 1024;

/// What reading needs everywhere: where paths start, and the presets read so far (several slots often share one).
struct SceneReader {
  fs::path folder;
  JsonReport& report;
  MissingPresets missing;
  std::map<std::string, Material> presets;

  void read(JsonFields& root, Scene& scene);

 private:
  /// Keeps what an object holds beyond our keys under its name in Scene::unknown.
  void keepUnknown(JsonFields& fields, std::string_view name, Scene& scene) {
    if (Json unknown = fields.unknown(); !unknown.empty()) scene.unknown[std::string(name)] = std::move(unknown);
  }
  void readPath(JsonFields& fields, std::string_view key, std::string& target);
  void readModel(JsonFields& root, Scene& scene);
  ModelFilePart readPart(const Json& json, const std::string& pointer);
  void readMaterials(JsonFields& root, Scene& scene);
  MaterialBinding readBinding(const Json& json, const std::string& pointer);
  void readEnvironment(JsonFields& root, Scene& scene);
  void readLights(JsonFields& root, Scene& scene);
  Light readLight(const Json& json, const std::string& pointer);
  void readBookmarks(JsonFields& root, Scene& scene);
  void readView(JsonFields& root, Scene& scene);
};

/// A path of a file, which must not be empty where it is given.
void SceneReader::readPath(JsonFields& fields, std::string_view key, std::string& target) {
  if (fields.find(key) == nullptr) return;
  fields.read(key, target);
  if (target.empty()) report.refuse(fields.pointerTo(key), "must name a file");
  target = absoluteReference(target, folder);
}

/// Exactly one of these keys may be there; returns it, or an empty text for none.
std::string_view oneOf(JsonFields& fields, const std::string& pointer, std::initializer_list<std::string_view> keys) {
  std::string_view found;
  for (const std::string_view key : keys) {
    if (fields.find(key) == nullptr) continue;
    if (!found.empty())
      fields.report().refuse(pointer, "has both " + std::string(found) + " and " + std::string(key) + "; keep one");
    found = key;
  }
  return found;
}

void SceneReader::readModel(JsonFields& root, Scene& scene) {
  const Json* json = root.find("model");
  if (json == nullptr) return;
  const std::string pointer = root.pointerTo("model");
  JsonFields fields(*json, pointer, report);
  ModelSource& model = scene.model;
  const std::string_view source = oneOf(fields, pointer, {"path", "builtin", "parts"});
  if (source == "path" || source == "parts") model.builtin.clear();
  readPath(fields, "path", model.path);
  fields.read("builtin", model.builtin);
  if (source == "builtin" && model.builtin.empty())
    report.refuse(fields.pointerTo("builtin"), "must name a built-in model");

  if (const Json* parts = fields.find("parts"); parts != nullptr) {
    const std::string place = fields.pointerTo("parts");
    if (!parts->is_array() || parts->empty() || parts->size() > kMaxParts)
      report.refuse(place, "must be an array of 1 to " + std::to_string(kMaxParts) + " files, each with its path");
    else
      for (std::size_t i = 0; i < parts->size(); ++i)
        model.parts.push_back(readPart((*parts)[i], pointerStep(place, i)));
  }
  if (fields.find("millimetres_per_unit") != nullptr) {
    float millimetres = 1.0F;
    fields.read("millimetres_per_unit", millimetres);
    if (millimetres <= 0.0F) report.refuse(fields.pointerTo("millimetres_per_unit"), "must be above 0");
    model.millimetresPerUnit = millimetres;
  }
  keepUnknown(fields, "model", scene);
}

ModelFilePart SceneReader::readPart(const Json& json, const std::string& pointer) {
  ModelFilePart part;
  JsonFields fields(json, pointer, report);
  if (json.is_object() && fields.find("path") == nullptr) report.refuse(pointer, "has no path");
  readPath(fields, "path", part.path);
  fields.read("translate", part.translate);
  fields.read("rotate_degrees", part.rotateDegrees);
  fields.readColour("scale", part.scale);  // three numbers, or one for all axes
  if (part.scale.x == 0.0F || part.scale.y == 0.0F || part.scale.z == 0.0F)
    report.refuse(fields.pointerTo("scale"), "must not be 0");
  part.unknown = fields.unknown();
  return part;
}

void SceneReader::readMaterials(JsonFields& root, Scene& scene) {
  const Json* json = root.find("materials");
  if (json == nullptr) return;
  const std::string pointer = root.pointerTo("materials");
  if (!json->is_object())
    return report.refuse(pointer, "must be an object of slots, not " + std::string(typeName(*json)));
  if (json->size() > kMaxSlots)
    return report.refuse(pointer, "has " + std::to_string(json->size()) + " slots; at most " +
                                      std::to_string(kMaxSlots) + " are possible");
  for (const auto& [slot, value] : json->items())
    scene.materials[slot] = readBinding(value, pointerStep(pointer, slot));
}

MaterialBinding SceneReader::readBinding(const Json& json, const std::string& pointer) {
  MaterialBinding binding;
  if (json.is_object()) {
    // An inline preset may say which file it is an edited copy of.
    Json preset = json;
    if (const auto based = json.find("based_on"); based != json.end()) {
      if (based->is_string())
        binding.presetPath = absoluteReference(based->get<std::string>(), folder);
      else
        report.refuse(pointerStep(pointer, "based_on"), "must be a string, not " + std::string(typeName(*based)));
      preset.erase("based_on");
    }
    binding.edited = !binding.presetPath.empty();
    binding.material = readMaterial(preset, pointer, PresetPlace::Inline, folder, report);
    return binding;
  }
  if (!json.is_string() || json.get_ref<const std::string&>().empty()) {
    report.refuse(pointer, "must be the path of a preset or a preset itself, not " +
                               (json.is_string() ? "an empty string" : std::string(typeName(json))));
    return binding;
  }
  binding.presetPath = absoluteReference(json.get<std::string>(), folder);
  auto known = presets.find(binding.presetPath);
  if (known == presets.end() && !report.error) {
    auto loaded = loadPreset(binding.presetPath, report.warnings);
    if (loaded)
      known = presets.emplace(binding.presetPath, std::move(*loaded)).first;
    else if (missing == MissingPresets::Refuse)
      report.refuse(pointer, "names a preset that cannot be used: " + loaded.error().message);
    else
      report.warn(pointer, "wears the default material, because its preset cannot be used: " + loaded.error().message);
  }
  if (known != presets.end())
    binding.material = known->second;
  else
    binding.missing = true;
  return binding;
}

void SceneReader::readEnvironment(JsonFields& root, Scene& scene) {
  const Json* json = root.find("environment");
  if (json == nullptr) return;
  const std::string pointer = root.pointerTo("environment");
  JsonFields fields(*json, pointer, report);
  EnvironmentSource& environment = scene.environment;
  const std::string_view source = oneOf(fields, pointer, {"path", "faces", "builtin", "constant", "rig"});
  if (!source.empty()) environment.builtin.clear();
  readPath(fields, "path", environment.path);
  fields.read("builtin", environment.builtin);
  if (source == "builtin" && environment.builtin.empty())
    report.refuse(fields.pointerTo("builtin"), "must name a built-in environment");

  if (const Json* faces = fields.find("faces"); faces != nullptr) {
    bool whole = faces->is_array() && faces->size() == environment.faces.size();
    for (std::size_t i = 0; whole && i < environment.faces.size(); ++i) {
      const Json& face = (*faces)[i];
      whole = face.is_string() && !face.get_ref<const std::string&>().empty();
      if (whole) environment.faces.at(i) = absoluteReference(face.get<std::string>(), folder);
    }
    if (!whole) report.refuse(fields.pointerTo("faces"), "must be six paths: +X, -X, +Y, -Y, +Z, -Z");
  }
  if (source == "constant") {
    glm::vec3 radiance(0.0F);
    fields.readColour("constant", radiance, kNotNegative);
    environment.constant = radiance;
  }
  if (const Json* rig = fields.find("rig"); rig != nullptr)
    environment.rig = InlineRig(readRig(*rig, fields.pointerTo("rig"), report));
  fields.read("rotation_degrees", environment.rotationDegrees);
  fields.read("exposure_stops", environment.exposureStops, kStops);
  if (std::string text; fields.find("background") != nullptr) {
    fields.read("background", text);
    const auto background = backgroundFromText(text);
    if (background)
      environment.background = *background;
    else
      report.refuse(
          fields.pointerTo("background"),
          "must be environment, irradiance, prefiltered:ROUGHNESS, color:R,G,B or none, not " + inQuotes(text));
  }
  keepUnknown(fields, "environment", scene);
}

void SceneReader::readLights(JsonFields& root, Scene& scene) {
  const Json* json = root.find("lights");
  if (json == nullptr) return;
  const std::string pointer = root.pointerTo("lights");
  if (!json->is_array()) return report.refuse(pointer, "must be an array, not " + std::string(typeName(*json)));
  if (json->size() > kMaxLights)
    return report.refuse(pointer, "has " + std::to_string(json->size()) + " lights; at most " +
                                      std::to_string(kMaxLights) + " are possible");
  for (std::size_t i = 0; i < json->size(); ++i) scene.lights.push_back(readLight((*json)[i], pointerStep(pointer, i)));
}

Light SceneReader::readLight(const Json& json, const std::string& pointer) {
  constexpr Range kHalfAngle{0.0F, 90.0F};
  Light light;
  JsonFields fields(json, pointer, report);
  int type = 0;
  fields.readWord("type", {"point", "directional", "spot", "sphere", "rect"}, type);
  light.type = static_cast<LightType>(type);
  fields.read("name", light.name);
  fields.read("position", light.position);
  fields.read("direction", light.direction);
  if (!hasDirection(light.direction))
    report.refuse(fields.pointerTo("direction"), "has no direction; give a vector that is not 0");
  fields.readColour("color", light.color, kNotNegative);
  fields.read("intensity", light.intensity, kNotNegative);
  fields.read("shadow", light.shadow);
  fields.read("visible", light.visible);
  fields.read("enabled", light.enabled);
  fields.read("outer_degrees", light.outerDegrees, kHalfAngle);
  // A narrow cone with the default inner angle is meant to be narrow.
  light.innerDegrees = std::min(light.innerDegrees, light.outerDegrees);
  fields.read("inner_degrees", light.innerDegrees, {0.0F, light.outerDegrees});
  fields.read("radius_mm", light.radiusMm, kNotNegative);
  fields.read("size_mm", light.sizeMm, kNotNegative);

  Json unknownOfAnimation = Json::object();
  if (const Json* animation = fields.find("animation"); animation != nullptr) {
    JsonFields inner(*animation, fields.pointerTo("animation"), report);
    int kind = 0;
    inner.readWord("kind", {"none", "orbit", "sway"}, kind);
    light.animation.kind = static_cast<AnimationKind>(kind);
    inner.read("amplitude", light.animation.amplitude);
    inner.read("speed", light.animation.speed);
    unknownOfAnimation = inner.unknown();
  }
  light.unknown = fields.unknown();
  if (!unknownOfAnimation.empty()) light.unknown["animation"] = std::move(unknownOfAnimation);
  return light;
}

void SceneReader::readBookmarks(JsonFields& root, Scene& scene) {
  const Json* json = root.find("bookmarks");
  if (json == nullptr) return;
  const std::string pointer = root.pointerTo("bookmarks");
  if (!json->is_array() || json->size() > kMaxBookmarks)
    return report.refuse(pointer, "must be an array of at most " + std::to_string(kMaxBookmarks) + " named cameras");
  for (std::size_t i = 0; i < json->size(); ++i) {
    CameraBookmark bookmark;
    JsonFields fields((*json)[i], pointerStep(pointer, i), report);
    fields.read("name", bookmark.name);
    readCamera(fields, bookmark.camera);
    bookmark.unknown = fields.unknown();
    scene.bookmarks.push_back(std::move(bookmark));
  }
}

void SceneReader::readView(JsonFields& root, Scene& scene) {
  const Json* json = root.find("view");
  if (json == nullptr) return;
  JsonFields fields(*json, root.pointerTo("view"), report);
  fields.read("transform", scene.view.transform);
  fields.read("display", scene.view.display);
  fields.read("exposure_stops", scene.view.exposureStops, kStops);
  keepUnknown(fields, "view", scene);
}

void SceneReader::read(JsonFields& root, Scene& scene) {
  checkFormat(root, kSceneFormat, kSceneVersion, true);
  root.read("name", scene.name);
  readModel(root, scene);
  readMaterials(root, scene);
  readEnvironment(root, scene);
  readLights(root, scene);
  if (const Json* json = root.find("camera"); json != nullptr) {
    JsonFields fields(*json, root.pointerTo("camera"), report);
    readCamera(fields, scene.camera.emplace());
    keepUnknown(fields, "camera", scene);
  }
  readBookmarks(root, scene);
  readView(root, scene);
  const Json unknown = root.unknown();
  for (const auto& [key, value] : unknown.items()) appendMember(scene.unknown, key, value);
}

}  // namespace

Result<Scene> readScene(std::string_view text, const std::string& name, const fs::path& baseFolder, Warnings& warnings,
                        MissingPresets missing) {
  const auto json = parseJson(text, name);
  if (!json) return tl::unexpected(json.error());
  Warnings found;
  JsonReport report{name, found};
  Scene scene;
  JsonFields root(*json, "", report);
  SceneReader{baseFolder, report, missing, {}}.read(root, scene);
  if (report.error) return tl::unexpected(std::move(*report.error));
  warnings.insert(warnings.end(), found.begin(), found.end());
  return scene;
}

Result<Scene> loadScene(const fs::path& path, Warnings& warnings, MissingPresets missing) {
  const auto text = readFile(path, kMaxJsonBytes);
  if (!text) return tl::unexpected(text.error());
  return readScene(*text, path.string(), fs::absolute(path).parent_path(), warnings, missing);
}

}  // namespace dermis
