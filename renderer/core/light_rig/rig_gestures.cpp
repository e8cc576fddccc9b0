#include "core/light_rig/rig_gestures.h"

#include <algorithm>
#include <cmath>

#include "core/base/json_fields.h"
#include "core/light_rig/rig_fields.h"

namespace dermis {
namespace {

const RigField& fieldOf(std::string_view key) {
  const auto fields = rigFields();
  return *std::find_if(fields.begin(), fields.end(), [&](const RigField& field) { return field.key == key; });
}

float within(float value, std::string_view key) {
  const Range& range = fieldOf(key).range;
  return std::clamp(value, range.lowest, range.highest);
}
glm::vec2 within(const glm::vec2& value, std::string_view key) { return {within(value.x, key), within(value.y, key)}; }

/// A number that a person can read in a file.
float tidy(float degrees) { return std::round(degrees * 100.0F) / 100.0F; }

bool isRound(RigElementType type) { return type == RigElementType::Disc || type == RigElementType::Ring; }

/// The member that says how bright, null where none is set.
std::optional<float> RigElement::*amountMember(const RigElement& element) {
  for (const auto member :
       {&RigElement::radiance, &RigElement::luminance, &RigElement::irradiance, &RigElement::illuminance})
    if (element.*member) return member;
  return nullptr;
}

}  // namespace

bool hasPlace(RigElementType type) { return fieldOf("azimuth_degrees").usedBy(type); }

glm::vec3 worldDirection(const RigElement& element, float rotationDegrees) {
  return rigDirection(element.azimuthDegrees + rotationDegrees, element.elevationDegrees);
}

RigElement turnedTo(const RigElement& element, const glm::vec3& towards, float rotationDegrees) {
  RigElement next = element;
  const bool upright = std::hypot(towards.x, towards.z) > 1e-4F;
  const float azimuth =
      upright ? glm::degrees(std::atan2(towards.x, towards.z)) - rotationDegrees : element.azimuthDegrees;
  next.azimuthDegrees = tidy(std::remainder(azimuth, 360.0F));
  next.elevationDegrees = tidy(glm::degrees(std::asin(std::clamp(towards.y, -1.0F, 1.0F))));
  // Its own place is no point to face.
  const glm::vec3 centre = rigDirection(next.azimuthDegrees, next.elevationDegrees) * next.distanceM;
  return glm::length(next.aimM - centre) > 1e-3F * next.distanceM ? next : element;
}

std::optional<RigSize> sizeOf(const RigElement& e) {
  if (!hasPlace(e.type)) return std::nullopt;
  if (e.type == RigElementType::Sky) return RigSize{glm::vec2(e.sunDiameterDegrees), true, true};
  if (isRound(e.type))
    return RigSize{glm::vec2(e.diameterDegrees.value_or(e.diameterM.value_or(1.0F))), e.diameterDegrees.has_value(),
                   true};
  if (e.type == RigElementType::Glow) return RigSize{e.sizeDegrees.value_or(glm::vec2(30.0F)), true, false};
  return RigSize{e.sizeDegrees.value_or(e.sizeM.value_or(glm::vec2(1.0F))), e.sizeDegrees.has_value(), false};
}

RigElement withSize(const RigElement& element, const glm::vec2& size) {
  RigElement next = element;
  const auto now = sizeOf(element);
  if (!now) return next;
  if (element.type == RigElementType::Sky)
    next.sunDiameterDegrees = within(size.x, "sun_diameter_degrees");
  else if (now->isRound && now->inDegrees)
    next.diameterDegrees = within(size.x, "diameter_degrees");
  else if (now->isRound)
    next.diameterM = within(size.x, "diameter_m");
  else if (now->inDegrees)
    next.sizeDegrees = within(size, "size_degrees");
  else
    next.sizeM = within(size, "size_m");
  return next;
}

float amountOf(const RigElement& element) {
  if (const auto member = amountMember(element)) return *(element.*member);
  return element.type == RigElementType::Sky ? element.skyShare : 1.0F;
}

RigElement withAmount(const RigElement& element, float amount) {
  RigElement next = element;
  if (!fieldOf("irradiance").usedBy(element.type)) return next;
  const float value = std::max(amount, 0.0F);
  if (const auto member = amountMember(element)) {
    next.*member = value;
  } else if (element.type == RigElementType::Sky) {
    // Sky and sun keep their ratio, where there is one.
    next.sunShare = element.skyShare > 0.0F ? element.sunShare * value / element.skyShare : value;
    next.skyShare = value;
  } else {
    next.radiance = value;
  }
  return next;
}

}  // namespace dermis
