// A camera as matrices: reversed depth in 0..1, sub-pixel jitter, near and far from what is looked at.
#pragma once

#include <glm/glm.hpp>
#include <span>

#include "core/scene/model.h"
#include "core/scene/scene.h"

namespace dermis {

struct CameraMatrices {
  glm::mat4 view{1.0F}, projection{1.0F}, viewProjection{1.0F}, inverseViewProjection{1.0F};
  glm::vec3 position{0.0F}, forward{0.0F, 0.0F, -1.0F};
  bool orthographic = false;
  float near = 0.01F;
};

/// Depth is 1 at the near plane and falls to 0 at infinity (perspective) or at the far plane (orthographic): a reversed
/// float depth buffer is equally fine everywhere (Reed 2015, "Depth Precision Visualized"). Needs glClipControl with
/// GL_ZERO_TO_ONE. `jitter` is in pixels, −½..½. `extra` are points, the lamps, that must lie inside the far plane too.
[[nodiscard]] CameraMatrices cameraMatrices(const Camera& camera, const Bounds& bounds, glm::ivec2 size,
                                            glm::vec2 jitter, std::span<const glm::vec3> extra = {});

/// Pixels from `lower` up to, not including, `upper`, counted from the lower left.
struct PixelArea {
  glm::ivec2 lower{0}, upper{0};
  [[nodiscard]] glm::ivec2 extent() const { return upper - lower; }
  [[nodiscard]] bool holds(const PixelArea& other) const {
    return glm::all(glm::lessThanEqual(lower, other.lower)) && glm::all(glm::greaterThanEqual(upper, other.upper));
  }
  bool operator==(const PixelArea&) const = default;
};
/// The camera of that part of a picture of `size`: the same points on the same pixels, counted from the part's corner.
[[nodiscard]] CameraMatrices cropped(const CameraMatrices& camera, const PixelArea& part, glm::ivec2 size);

/// A rectangle that holds all of `bounds` on the screen; the whole screen where that reaches behind the camera.
[[nodiscard]] PixelArea screenArea(const CameraMatrices& camera, const Bounds& bounds, glm::ivec2 size);

/// What a pixel is wide where `bounds` are nearest to the camera, scene units; 0 where they reach behind it.
[[nodiscard]] float nearestPixel(const CameraMatrices& camera, const Bounds& bounds, glm::ivec2 size);

/// Sample `index` of the R2 sequence (Roberts 2018, "The Unreasonable Effectiveness of Quasirandom Sequences"), −½..½;
/// the first is (0, 0).
[[nodiscard]] glm::vec2 pixelJitter(int index);

}  // namespace dermis
