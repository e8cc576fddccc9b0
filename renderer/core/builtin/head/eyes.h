// Eyeballs and corneas.
#pragma once

#include "core/scene/model.h"

namespace dermis::sculpt {

/// The left eyeball in millimetres about its centre, looking along +Z: a sphere with a hollow iris. Its texture
/// coordinates are an equal-area map of the sphere about the pupil, in a disc of radius ½ about (½, ½). One slot, eye.
[[nodiscard]] Model makeEyeball(int segments);
/// How far the front of the eye, cornea included, lies before its centre at a distance from its axis, mm.
[[nodiscard]] float frontOfEye(float radius);
/// The cornea before it, a cap with its rim on the limbus. One slot, lens.
[[nodiscard]] Model makeCornea(int segments);

}  // namespace dermis::sculpt
