// The writing half of scene_io.
#include <algorithm>
#include <array>

#include "core/base/file_reference.h"
#include "core/base/json_text.h"
#include "core/base/number_format.h"
#include "core/light_rig/rig_io.h"
#include "core/material/preset_io.h"
#include "core/scene/cameras.h"
#include "core/scene/scene_io.h"

namespace dermis {
namespace {

namespace fs = std::filesystem;

Json toJson(const glm::vec3& v) { return Json::array({jsonNumber(v.x), jsonNumber(v.y), jsonNumber(v.z)}); }
Json toJson(const glm::vec2& v) { return Json::array({jsonNumber(v.x), jsonNumber(v.y)}); }

/// Adds the members of `unknown[name]`, where there are any.
void appendUnknown(Json& object, const Json& unknown, std::string_view name) {
  const auto kept = unknown.find(name);
  if (kept == unknown.end() || !kept->is_object()) return;
  for (const auto& [key, value] : kept->items()) appendMember(object, key, value);
}

Json partToJson(const ModelFilePart& part, const fs::path& folder) {
  Json json = {{"path", relativeReference(part.path, folder)},
               {"translate", toJson(part.translate)},
               {"rotate_degrees", toJson(part.rotateDegrees)},
               {"scale", toJson(part.scale)}};
  for (const auto& [key, value] : part.unknown.items()) appendMember(json, key, value);
  return json;
}

Json modelToJson(const ModelSource& model, const fs::path& folder) {
  Json json = Json::object();
  if (!model.path.empty()) {
    json["path"] = relativeReference(model.path, folder);
  } else if (!model.parts.empty()) {
    json["parts"] = Json::array();
    for (const ModelFilePart& part : model.parts) json["parts"].push_back(partToJson(part, folder));
  } else if (model.builtin != ModelSource().builtin) {
    json["builtin"] = model.builtin;
  }
  if (model.millimetresPerUnit) json["millimetres_per_unit"] = jsonNumber(*model.millimetresPerUnit);
  return json;
}

Json bindingToJson(const MaterialBinding& binding, const fs::path& folder) {
  const std::string preset = relativeReference(binding.presetPath, folder);
  if (!binding.edited && !preset.empty()) return preset;
  Json json = materialToJson(binding.material, folder);
  if (!preset.empty()) json["based_on"] = preset;
  return json;
}

Json environmentToJson(const EnvironmentSource& environment, const fs::path& folder) {
  Json json = Json::object();
  if (!environment.path.empty()) {
    json["path"] = relativeReference(environment.path, folder);
  } else if (environment.hasFaces()) {
    json["faces"] = Json::array();
    for (const std::string& face : environment.faces) json["faces"].push_back(relativeReference(face, folder));
  } else if (environment.constant) {
    json["constant"] = toJson(*environment.constant);
  } else if (environment.rig) {
    json["rig"] = rigToJson(*environment.rig);
  } else {
    json["builtin"] = environment.builtin;
  }
  json["rotation_degrees"] = jsonNumber(environment.rotationDegrees);
  json["exposure_stops"] = jsonNumber(environment.exposureStops);
  json["background"] = toString(environment.background);
  return json;
}

/// What the light's type uses is always written, so that a changed default never changes an old file; what it doesn't
/// use is written where somebody has set it.
Json lightToJson(const Light& light) {
  const Light plain;
  const bool spot = light.type == LightType::Spot;
  const bool aimed = spot || light.type == LightType::Directional || light.type == LightType::Rect;
  const bool placed = light.type != LightType::Directional;
  Json json = {{"type", std::string(toString(light.type))}};
  if (!light.name.empty()) json["name"] = light.name;
  if (placed || light.position != plain.position) json["position"] = toJson(light.position);
  if (aimed || light.direction != plain.direction) json["direction"] = toJson(light.direction);
  json["color"] = toJson(light.color);
  json["intensity"] = jsonNumber(light.intensity);
  json["shadow"] = light.shadow;
  json["visible"] = light.visible;
  if (light.enabled != plain.enabled) json["enabled"] = light.enabled;
  if (spot || light.innerDegrees != plain.innerDegrees) json["inner_degrees"] = jsonNumber(light.innerDegrees);
  if (spot || light.outerDegrees != plain.outerDegrees) json["outer_degrees"] = jsonNumber(light.outerDegrees);
  if (light.type == LightType::Sphere || light.visible || light.radiusMm != plain.radiusMm)
    json["radius_mm"] = jsonNumber(light.radiusMm);
  if (light.type == LightType::Rect || light.sizeMm != plain.sizeMm) json["size_mm"] = toJson(light.sizeMm);
  if (light.animation != plain.animation) {
    Json& animation = json["animation"];
    animation = {{"kind", std::string(toString(light.animation.kind))},
                 {"amplitude", jsonNumber(light.animation.amplitude)},
                 {"speed", jsonNumber(light.animation.speed)}};
    appendUnknown(animation, light.unknown, "animation");
  }
  for (const auto& [key, value] : light.unknown.items())
    if (key != "animation") appendMember(json, key, value);
  return json;
}

Json viewToJson(const ViewSettings& view) {
  return {{"transform", view.transform}, {"display", view.display}, {"exposure_stops", jsonNumber(view.exposureStops)}};
}

Json bookmarkToJson(const CameraBookmark& bookmark) {
  Json json = {{"name", bookmark.name}};
  const Json camera = cameraToJson(bookmark.camera);
  for (const auto& [key, value] : camera.items()) json[key] = value;
  for (const auto& [key, value] : bookmark.unknown.items()) appendMember(json, key, value);
  return json;
}

constexpr std::array<std::string_view, 5> kObjects = {"model", "materials", "environment", "camera", "view"};

Json sceneToJson(const Scene& scene, const fs::path& folder) {
  Json json = {{"format", kSceneFormat}, {"version", kSceneVersion}};
  if (!scene.name.empty()) json["name"] = scene.name;

  Json model = modelToJson(scene.model, folder);
  appendUnknown(model, scene.unknown, "model");
  if (!model.empty()) json["model"] = std::move(model);

  if (!scene.materials.empty()) {
    Json& materials = json["materials"] = Json::object();
    for (const auto& [slot, binding] : scene.materials) appendMember(materials, slot, bindingToJson(binding, folder));
  }
  Json& environment = json["environment"] = environmentToJson(scene.environment, folder);
  appendUnknown(environment, scene.unknown, "environment");
  Json& lights = json["lights"] = Json::array();
  for (const Light& light : scene.lights) lights.push_back(lightToJson(light));
  if (scene.camera) {
    Json& camera = json["camera"] = cameraToJson(*scene.camera);
    appendUnknown(camera, scene.unknown, "camera");
  }
  if (!scene.bookmarks.empty()) {
    Json& bookmarks = json["bookmarks"] = Json::array();
    for (const CameraBookmark& bookmark : scene.bookmarks) bookmarks.push_back(bookmarkToJson(bookmark));
  }
  Json& view = json["view"] = viewToJson(scene.view);
  appendUnknown(view, scene.unknown, "view");

  for (const auto& [key, value] : scene.unknown.items())
    if (std::find(kObjects.begin(), kObjects.end(), key) == kObjects.end()) appendMember(json, key, value);
  return json;
}

constexpr std::array<std::string_view, 5> kLightTypes = {"point", "directional", "spot", "sphere", "rect"};
constexpr std::array<std::string_view, 3> kAnimationKinds = {"none", "orbit", "sway"};

}  // namespace

std::string_view toString(LightType type) { return kLightTypes.at(static_cast<std::size_t>(type)); }
std::string_view toString(AnimationKind kind) { return kAnimationKinds.at(static_cast<std::size_t>(kind)); }

std::optional<Background> backgroundFromText(std::string_view text) {
  constexpr std::string_view kPrefiltered = "prefiltered:";
  constexpr std::string_view kColor = "color:";
  Background background;
  if (text == "environment") return background;
  if (text == "irradiance") {
    background.kind = BackgroundKind::Irradiance;
  } else if (text == "none") {
    background.kind = BackgroundKind::None;
  } else if (text.starts_with(kPrefiltered)) {
    const auto roughness = parseFloat(text.substr(kPrefiltered.size()));
    if (!roughness || *roughness < 0.0F || *roughness > 1.0F) return std::nullopt;
    background.kind = BackgroundKind::Prefiltered;
    background.perceptualRoughness = *roughness;
  } else if (text.starts_with(kColor)) {
    const auto rgb = parseFloatList(text.substr(kColor.size()));
    if (!rgb || rgb->size() != 3 || std::any_of(rgb->begin(), rgb->end(), [](float c) { return c < 0.0F; }))
      return std::nullopt;
    background.kind = BackgroundKind::Color;
    background.color = {(*rgb)[0], (*rgb)[1], (*rgb)[2]};
  } else {
    return std::nullopt;
  }
  return background;
}

std::string toString(const Background& background) {
  switch (background.kind) {
    case BackgroundKind::Environment:
      return "environment";
    case BackgroundKind::Irradiance:
      return "irradiance";
    case BackgroundKind::Prefiltered:
      return "prefiltered:" + shortestDecimal(background.perceptualRoughness);
    case BackgroundKind::Color:
      return "color:" + shortestDecimal(background.color.r) + "," + shortestDecimal(background.color.g) + "," +
             shortestDecimal(background.color.b);
    case BackgroundKind::None:
      return "none";
  }
  return "environment";
}

std::string writeScene(const Scene& scene, const fs::path& sceneFolder) {
  return writeJson(sceneToJson(scene, sceneFolder));
}

Result<void> saveScene(const fs::path& path, const Scene& scene) {
  return saveJson(path, sceneToJson(scene, fs::absolute(path).parent_path()));
}

}  // namespace dermis
