// Planes with things above them, and how much of a light reaches each pixel of them.
#pragma once

#include <functional>
#include <vector>

#include "gpu/frame_support.h"

namespace dermis::test {

using glm::dvec3;

/// A flat four-sided patch, corners counter-clockwise as seen from its front; slot `name`.
[[nodiscard]] Model quad(const dvec3& a, const dvec3& b, const dvec3& c, const dvec3& d,
                         const std::string& name = "default");
/// The plane z = 0, −2..2 in x and y.
[[nodiscard]] Model ground();
/// x from −1.5 to −0.6 and y from −1 to 1, `height` above the ground, facing up.
[[nodiscard]] Model awning(double height = 0.5);
/// `model` with `other` added, both wearing what its only slot wears.
[[nodiscard]] Model both(Model model, const Model& other);

/// White, rough, without reflections to speak of: what is seen is the light that arrives.
[[nodiscard]] Material chalk();

/// Black world, chalk everywhere, and a camera that looks down on ±`half` about `centre` from far above.
[[nodiscard]] ResolvedScene litFromAbove(Model model, const Light& light, const glm::vec2& centre = glm::vec2(0.0F),
                                         float half = 0.5F);

/// A light of each type that lights the ground from (−1.2, 0, 1.1): areas are points.
[[nodiscard]] Light lampOf(LightType type);
/// Unit direction from a point to that light.
[[nodiscard]] dvec3 towards(const Light& light, const dvec3& point);

class ShadowTest : public FrameTest {
 protected:
  /// Share of the light's own picture without shadows that arrives at each pixel, row by row from the top; −1 where
  /// nothing arrives anyway.
  std::vector<double> arriving(ResolvedScene scene, int samples = 32);
  /// World x or y of a pixel's centre in litFromAbove.
  [[nodiscard]] double across(int pixel, double centre = 0.0, double half = 0.5) const {
    return centre + half * (2.0 * (pixel + 0.5) / m_size.x - 1.0);
  }
  [[nodiscard]] std::size_t at(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(m_size.x) + static_cast<std::size_t>(x);
  }
};

}  // namespace dermis::test
