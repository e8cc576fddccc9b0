// Displaced surfaces: which slots have one, how a pass draws it.
//
// A pass that draws a displaced part takes its own program with `tessellated()` applied, binds geometry and slot, and
// calls drawDisplaced() with its view. The vertex stage must be surface.vert; the fragment stage may read any of its
// outputs or none.
#pragma once

#include "core/scene/resolved_scene.h"
#include "gl/shader_library.h"
#include "passes/camera_matrices.h"
#include "passes/geometry.h"
#include "passes/scene_resources.h"

namespace dermis {

/// Whether the slot's material has all that displacement needs but a height: its program is prepared, so that moving
/// the slider compiles nothing.
[[nodiscard]] bool canDisplace(const ResolvedScene& scene, std::size_t slot);
/// Whether it is displaced.
[[nodiscard]] bool displaces(const ResolvedScene& scene, std::size_t slot);
/// Least and greatest value of a height map as the GPU reads it, of all channels; integers are taken to use their
/// range.
[[nodiscard]] glm::vec2 valueRange(const Image& image);
/// Farthest that a slot's map moves its surface, in scene units, given the map's values.
[[nodiscard]] float displacementReach(const ResolvedScene& scene, std::size_t slot, const glm::vec2& values);

/// The same program between whose vertices lie displaced ones.
[[nodiscard]] gl::ProgramSources tessellated(gl::ProgramSources sources);

/// From where, and how finely, in pixels of whatever is drawn to.
struct DisplacementView {
  glm::mat4 clipFromWorld{1.0F};
  glm::vec4 eye{0.0F, 0.0F, 1.0F, 1.0F};  ///< position and 0, or the unit direction towards the viewer and 1
  float pixelsPerUnit = 1.0F;             ///< of a length at distance 1; anywhere for a parallel view
  float pixelsPerPiece = 4.0F;            ///< longest edge of a piece
  float leastFacing = -0.3F;  ///< edges whose normals face away more are divided less; −2 divides all alike
};
[[nodiscard]] DisplacementView displacementView(const CameraMatrices& camera, glm::ivec2 size, float pixelsPerPiece);
/// Pixels that an edge of a piece has: fewer where the picture stands still, more on software GL, where a small
/// triangle costs as much as a block of pixels.
[[nodiscard]] float pixelsPerPiece(bool moving, bool software);

/// Depth only, of a displaced part: for shadow maps.
[[nodiscard]] gl::ProgramSources displacedCasterProgram();

/// Draws a part of a displaced slot with `program`, a tessellated() one in use, the geometry and the slot bound.
void drawDisplaced(const gl::Program& program, const SlotResources& slot, const Geometry& geometry, std::size_t part,
                   const DisplacementView& view);

}  // namespace dermis
