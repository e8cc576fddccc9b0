// What is looked at: the whole look, as in a .dermis file. Plain values; nothing is loaded here. In memory paths of
// files are absolute (scene_io makes them relative to the scene's folder when it writes).
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/light_rig/inline_rig.h"
#include "core/material/material.h"

namespace dermis {

/// A file of a model made of several, placed by scale, then rotation (degrees about X, then Y, then Z), then
/// translation.
struct ModelFilePart {
  std::string path;
  glm::vec3 translate{0.0F};
  glm::vec3 rotateDegrees{0.0F};
  glm::vec3 scale{1.0F};
  nlohmann::ordered_json unknown = nlohmann::ordered_json::object();  ///< keys that we don't know, kept
  bool operator==(const ModelFilePart&) const = default;
};

/// Exactly one of path, builtin and parts is set.
struct ModelSource {
  std::string path;
  std::string builtin = "head";  ///< one of builtinModels()
  std::vector<ModelFilePart> parts;
  std::optional<float> millimetresPerUnit;  ///< unset: the file's own unit, or guessed
  bool operator==(const ModelSource&) const = default;
};

/// What a slot wears: a copy of a preset, and where it came from.
struct MaterialBinding {
  Material material;
  std::string presetPath;  ///< absolute, or "builtin:NAME"; empty for an inline preset
  bool edited = false;     ///< differs from the preset at presetPath: saved inline with "based_on"
  bool missing = false;    ///< there was no such preset to read: `material` is the default, and the path is kept
  bool operator==(const MaterialBinding&) const = default;
};

enum class BackgroundKind { Environment, Irradiance, Prefiltered, Color, None };
struct Background {
  BackgroundKind kind = BackgroundKind::Environment;
  float perceptualRoughness = 0.0F;  ///< for Prefiltered
  glm::vec3 color{0.0F};             ///< for Color, linear Rec.709
  bool operator==(const Background&) const = default;
};

/// Exactly one of path, faces, builtin, constant and rig is set.
struct EnvironmentSource {
  std::string path;
  std::array<std::string, 6> faces;  ///< +X −X +Y −Y +Z −Z
  std::string builtin = "studio";    ///< "studio", "overcast", "rim"
  std::optional<glm::vec3> constant;
  InlineRig rig;                 ///< a light rig of the scene's own
  float rotationDegrees = 0.0F;  ///< about +Y, counter-clockwise seen from above
  float exposureStops = 0.0F;
  Background background;
  [[nodiscard]] bool hasFaces() const { return !faces[0].empty(); }
  bool operator==(const EnvironmentSource&) const = default;
};

enum class LightType { Point, Directional, Spot, Sphere, Rect };
enum class AnimationKind { None, Orbit, Sway };
struct LightAnimation {
  AnimationKind kind = AnimationKind::None;
  float amplitude = 1.0F;  ///< scene units for sway, radius factor for orbit
  float speed = 1.0F;      ///< radians a second
  bool operator==(const LightAnimation&) const = default;
};
struct Light {
  std::string name;
  LightType type = LightType::Point;
  glm::vec3 position{0.0F, 0.0F, 1.0F};    ///< scene units
  glm::vec3 direction{0.0F, 0.0F, -1.0F};  ///< the way the light travels
  glm::vec3 color{1.0F};                   ///< linear Rec.709
  float intensity = 1.0F;  ///< color · intensity is radiant intensity; irradiance for a directional light
  bool shadow = true;
  bool visible = false;  ///< drawn as a sphere in scene radiance
  bool enabled = true;
  float innerDegrees = 20.0F, outerDegrees = 30.0F;  ///< half angles of a spot
  float radiusMm = 50.0F;                            ///< of a sphere light, and of a visible lamp
  glm::vec2 sizeMm{200.0F, 200.0F};                  ///< of a rect light
  LightAnimation animation;
  nlohmann::ordered_json unknown = nlohmann::ordered_json::object();  ///< keys that we don't know, kept
  bool operator==(const Light&) const = default;
};
inline constexpr std::size_t kMaxLights = 16;

struct Camera {
  glm::vec3 position{0.0F, 0.0F, 6.0F};
  glm::vec3 target{0.0F};
  glm::vec3 up{0.0F, 1.0F, 0.0F};
  float verticalFovDegrees = 26.0F;
  std::optional<float> orthographicHeight;  ///< scene units; instead of the field of view
  bool operator==(const Camera&) const = default;
};

/// A place to look from that somebody wants to find again.
struct CameraBookmark {
  std::string name;
  Camera camera;
  nlohmann::ordered_json unknown = nlohmann::ordered_json::object();  ///< keys that we don't know, kept
  bool operator==(const CameraBookmark&) const = default;
};
inline constexpr std::size_t kMaxBookmarks = 256;

struct ViewSettings {
  std::string transform = "ACES";
  std::string display = "sRGB";
  float exposureStops = 0.0F;
  bool operator==(const ViewSettings&) const = default;
};

struct Scene {
  ModelSource model;
  std::map<std::string, MaterialBinding> materials;  ///< by slot; "*" catches the rest
  EnvironmentSource environment;
  std::vector<Light> lights;
  std::optional<Camera> camera;  ///< unset: one that frames the model's bounds from +Z
  std::vector<CameraBookmark> bookmarks;
  ViewSettings view;
  std::string name;
  /// Keys that we don't know, kept; those inside "model", "environment", "camera" and "view" under these names.
  nlohmann::ordered_json unknown = nlohmann::ordered_json::object();
  bool operator==(const Scene&) const = default;

  /// The binding for a slot: its own, else that of "*", else null.
  [[nodiscard]] const MaterialBinding* bindingFor(const std::string& slot) const {
    auto it = materials.find(slot);
    if (it == materials.end()) it = materials.find("*");
    return it == materials.end() ? nullptr : &it->second;
  }
};

}  // namespace dermis
