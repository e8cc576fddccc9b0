// Light for a whole set-up as a list of elements: soft boxes, rings, windows, domes, a sky with its sun. Plain values;
// rig_io reads and writes them, rig_picture makes the lat-long image.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/base/json_text.h"

namespace dermis {

enum class RigElementType : std::uint8_t { Softbox, Strip, Disc, Ring, Window, Glow, Dome, Overcast, Sky, Ground };

/// One light. Which members a type uses, their JSON keys, ranges and meaning: rigFields().
///
/// Azimuth 0° is the way the built-in cameras stand and a face looks (+Z), 90° is +X, elevation 90° is +Y. At most one
/// member of each group of optional ones is set: how large, how bright, which colour.
struct RigElement {
  RigElementType type = RigElementType::Softbox;
  std::string name;
  bool enabled = true;

  float azimuthDegrees = 0.0F;
  float elevationDegrees = 0.0F;
  float distanceM = 2.0F;
  glm::vec3 aimM{0.0F};  ///< the point that the element's face looks at
  float rollDegrees = 0.0F;

  std::optional<glm::vec2> sizeM, sizeDegrees;
  std::optional<float> diameterM, diameterDegrees;
  float innerShare = 0.7F;
  float edgeShare = 1.0F;
  float softShare = 0.0F;
  float cornerShare = 0.0F;
  std::optional<float> gridDegrees;
  glm::vec2 panes{1.0F};
  float barShare = 0.08F;
  float lowerShare = 1.0F;

  glm::vec3 zenith{1.0F}, horizon{1.0F}, nadir{1.0F};
  float exponent = 1.0F;

  float turbidity = 3.0F;
  bool sun = true;
  float sunDiameterDegrees = 0.533F;
  float sunShare = 1.0F;
  float skyShare = 1.0F;

  glm::vec3 albedo{0.2F};

  std::optional<float> radiance, irradiance, luminance, illuminance;
  std::optional<glm::vec3> color;
  std::optional<float> temperatureK, daylightK;

  Json unknown = Json::object();  ///< keys that we don't know, kept
  bool operator==(const RigElement&) const = default;
};

struct LightRig {
  std::string name;
  std::string description;
  float whiteLuminance = 1000.0F;  ///< cd/m² that radiance 1 stands for
  int width = 1024;                ///< of the lat-long image
  std::vector<RigElement> elements;
  Json metadata = Json::object();
  Json unknown = Json::object();
  bool operator==(const LightRig&) const = default;
};
inline constexpr std::size_t kMaxRigElements = 256;

/// The unit vector of an azimuth and an elevation.
[[nodiscard]] glm::vec3 rigDirection(float azimuthDegrees, float elevationDegrees);

}  // namespace dermis
