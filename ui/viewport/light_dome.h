// Where lights come from, as a map round the middle of the viewport: the middle is the camera's own direction, the
// first ring what comes from the side, the second what comes from straight behind. Every light has one place on it,
// wherever the camera looks and however far away the light is. Pure functions.
#pragma once

#include <QPointF>
#include <optional>

#include "core/scene/scene.h"
#include "ui/viewport/projection.h"

namespace dermis::dome {

/// Radius of the first ring (90° from the camera) in pixels.
[[nodiscard]] double ringRadius(const Projection& projection);
/// The place of the light that comes from `towards`, a unit vector from what is lit to the light.
[[nodiscard]] QPointF place(const Projection& projection, const glm::vec3& towards);
/// The direction that a place stands for.
[[nodiscard]] glm::vec3 direction(const Projection& projection, QPointF place);

/// Unit vector from `centre` to where the light comes from.
[[nodiscard]] glm::vec3 towards(const Light& light, const glm::vec3& centre);
/// The light turned round `centre` until it comes from `towards`, at its own distance; what it aims at turns along.
[[nodiscard]] Light turned(const Light& light, const glm::vec3& centre, const glm::vec3& towards);
/// The light with its distance from `centre` multiplied.
[[nodiscard]] Light moved(const Light& light, const glm::vec3& centre, float factor);
/// The size that its type has, multiplied: radius, sides, or the angles of a cone.
[[nodiscard]] Light resized(const Light& light, float factor);
/// The enabled light that sends most to `centre`; nothing where none does.
[[nodiscard]] std::optional<std::size_t> keyLight(const std::vector<Light>& lights, const glm::vec3& centre);

}  // namespace dermis::dome
