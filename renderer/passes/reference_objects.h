// Grey and chrome balls and a colour chart, in the lower left of the picture, lit by the scene.
#pragma once

#include <array>
#include <glm/glm.hpp>

#include "passes/frame_context.h"

namespace dermis {

/// Where they stand, in pixels from the lower left of a picture. All sizes follow from the picture's shorter side.
struct ReferenceLayout {
  float radius = 0.0F;  ///< of each ball
  glm::vec2 grey{0.0F}, chrome{0.0F};
  glm::vec2 chart{0.0F};  ///< its lower left corner
  float cell = 0.0F;      ///< a patch with the frame round it; six of them in a row, four rows
  /// The middle of patch `index`, 0 to 23, in the chart's own order: row by row from the upper left.
  [[nodiscard]] glm::vec2 patch(int index) const;
};
[[nodiscard]] ReferenceLayout referenceLayout(const ReferenceObjects& objects, glm::ivec2 size);

inline constexpr float kGreyBallAlbedo = 0.18F;
/// The chart's reflectances, linear Rec.709: "ColorChecker Classic", L*a*b* (D50, 2°) that X-Rite publishes for charts
/// made since November 2014, to Rec.709 by Bradford's adaptation. Cyan lies outside of Rec.709; what is negative is 0.
[[nodiscard]] const std::array<glm::vec3, 24>& chartPatches();

[[nodiscard]] gl::ProgramSources referenceProgram();
/// Draws what the request asks for over the finished picture.
void referencePass(const FrameContext& frame, glm::vec2 jitter);

}  // namespace dermis
