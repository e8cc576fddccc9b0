// Cameras by name, from a model's bounds, and as JSON.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "core/base/json_fields.h"
#include "core/base/json_text.h"
#include "core/base/result.h"
#include "core/scene/model.h"
#include "core/scene/scene.h"

namespace dermis {

struct NamedCameraRow {
  std::string_view id;     ///< "three-quarter"
  std::string_view label;  ///< for people
};
/// front, three-quarter, profile, ear and the seed's four views, in this order.
[[nodiscard]] std::span<const NamedCameraRow> namedCameras();

/// A named camera round a head that faces +Z; the name's case doesn't matter. Empty for an unknown name.
[[nodiscard]] std::optional<Camera> namedCamera(std::string_view name, const Bounds& bounds);

/// The camera of a scene that states none: from +Z, the whole of the bounds in view at any aspect from square upwards.
[[nodiscard]] Camera framingCamera(const Bounds& bounds);
/// The same along any direction (from the target to the camera).
[[nodiscard]] Camera framingCamera(const Bounds& bounds, const glm::vec3& towardsCamera);

/// Reads a camera's keys over what `camera` is; those that are left out keep their values. Refuses in the report what
/// has no direction: a zero `up`, one along the view, a target at the position.
void readCamera(JsonFields& fields, Camera& camera);
/// The same for a camera on its own; `pointer` is the JSON pointer of the value, for messages. Unknown keys are
/// refused. Errors: Input, naming the place ("/camera/position").
[[nodiscard]] Result<Camera> cameraFromJson(const Json& json, const std::string& pointer, const Camera& base);
[[nodiscard]] Json cameraToJson(const Camera& camera);

}  // namespace dermis
