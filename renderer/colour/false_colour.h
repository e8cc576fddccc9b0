// Numbers as colours: what the views of data (thickness, depth, energy) show, and the legend beside them.
#pragma once

#include <glm/glm.hpp>
#include <optional>

#include "renderer.h"

namespace dermis {

/// Viridis by Eric Firing, Stéfan van der Walt and Nathaniel Smith (matplotlib 2015, CC0): perceptually uniform,
/// readable for the colour-blind and in grey. A polynomial fitted to the published table, within 0.01 of it;
/// sRGB-encoded, as the table is. GLSL twin: resources/shaders/false_colour.glsl.
[[nodiscard]] glm::vec3 viridis(float share);

enum class ColourRamp { Viridis, WhiteToBlack };

/// Which numbers the ends of the ramp stand for.
struct ValueRange {
  float low = 0.0F, high = 1.0F;  ///< in the unit in which the image holds them
  float inMillimetres = 0.0F;     ///< millimetres of one such unit; 0: no length
  ColourRamp ramp = ColourRamp::Viridis;
  bool marksAbove = false;  ///< what is above `high` is an error and red; else it has the last colour
};

/// Images that are not radiance.
[[nodiscard]] bool isData(Aov aov);

/// For the views of numbers; nothing for the others. Thickness ends at the largest maximum of the materials that have
/// one, depth at the model's box seen from the camera, energy at 1.
[[nodiscard]] std::optional<ValueRange> valueRange(Aov aov, const ResolvedScene& scene, const Camera& camera);

/// The colour of a number, display-encoded, as the view draws it.
[[nodiscard]] glm::vec3 falseColour(const ValueRange& range, float value);

}  // namespace dermis
