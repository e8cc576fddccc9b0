// An environment's pixels, repaired and ready to be summed or interpolated.
#pragma once

#include <array>
#include <cstddef>
#include <glm/glm.hpp>
#include <vector>

#include "core/scene/resolved_scene.h"

namespace dermis {

/// Repaired texels of an environment.
struct CleanedTexels {
  std::size_t negative = 0;   ///< channels below zero, set to 0
  std::size_t nonFinite = 0;  ///< NaN set to 0, +infinity to the image's largest finite value
  [[nodiscard]] std::size_t total() const { return negative + nonFinite; }
};

/// RGB radiance, linear Rec.709, every value finite and ≥ 0. Row 0 is the top.
struct RadianceImage {
  int width = 0;
  int height = 0;
  std::vector<glm::vec3> pixels;

  [[nodiscard]] const glm::vec3& at(int x, int y) const {
    return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
  }
};

/// Converts any Image (grey is spread; 8- and 16-bit integers are read as sRGB) and repairs it, adding to `cleaned`.
[[nodiscard]] RadianceImage cleanRadiance(const Image& image, CleanedTexels& cleaned);

/// The decoded, repaired light of an environment.
struct RadianceMap {
  enum class Layout { Constant, LatLong, Faces };
  Layout layout = Layout::Constant;
  glm::vec3 constant{0.0F};
  RadianceImage latLong;
  std::array<RadianceImage, 6> faces;
  CleanedTexels cleaned;

  explicit RadianceMap(const EnvironmentImages& images);

  /// Bilinear lat-long radiance at pixel coordinates (texel centres at integers); x wraps, y mirrors over the pole.
  [[nodiscard]] glm::vec3 latLongAt(float x, float y) const;
  /// Bilinear radiance inside a face at 0..1 coordinates; beyond the outermost texel centres it continues in the
  /// neighbouring faces.
  [[nodiscard]] glm::vec3 faceAt(int face, float s, float t) const;
  /// Pixels a quarter turn at the equator holds: what a cube face should have to keep the detail.
  [[nodiscard]] int pixelsPerFace() const;
};

}  // namespace dermis
