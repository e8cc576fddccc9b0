// Cameras by name, from a model's bounds, and as JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string_view>

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

/// `pointer` is the JSON pointer of the value, for messages. Errors: Input, naming the place ("/camera/position").
/// Keys that are left out keep the values of `base`.
[[nodiscard]] Result<Camera> cameraFromJson(const nlohmann::ordered_json& json, const std::string& pointer,
                                            const Camera& base);
[[nodiscard]] nlohmann::ordered_json cameraToJson(const Camera& camera);

}  // namespace dermis
