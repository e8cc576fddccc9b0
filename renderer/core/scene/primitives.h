// Shapes made in code: what `builtin` models are built from. All keep the invariants of Model.
#pragma once

#include <glm/glm.hpp>
#include <string>

#include "core/scene/model.h"

namespace dermis {

/// The built-in sphere: radius 1 at the origin, `segments` round the equator and half as many from pole to pole, exact
/// normals and tangents, 100 mm a unit, one slot "default". UV: u = .5 faces +Z and grows to the right seen from
/// there, v runs from the lower pole to the upper one. `segments` is at least 8.
[[nodiscard]] Model makeSphere(int segments = 512);

/// The built-in plane: −1..1 in x and y, facing +Z, UV 0..1, 100 mm a unit, one slot "default".
[[nodiscard]] Model makePlane();

/// Applied in this order: scale, rotation (degrees about X, then Y, then Z), translation.
struct Placement {
  glm::vec3 scale{1.0F};
  glm::vec3 rotateDegrees{0.0F};
  glm::vec3 translate{0.0F};
};
/// Appends `other` to `model`, placed. A slot name that `model` already has gets a suffix `.2`, `.3`, …; embedded
/// images keep their bindings.
void appendModel(Model& model, const Model& other, const Placement& placement = {});

}  // namespace dermis
