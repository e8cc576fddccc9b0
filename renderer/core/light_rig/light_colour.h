// Colours of light by their temperature or spectrum, as linear Rec.709.
#pragma once

#include <glm/glm.hpp>

namespace dermis {

/// Of CIE XYZ (1931, 2°), white D65. Colours outside Rec.709 have negative parts.
[[nodiscard]] glm::dvec3 rec709FromXyz(const glm::dvec3& xyz);
/// Luminance of linear Rec.709: the Y row of IEC 61966-2-1.
[[nodiscard]] double luminance(const glm::dvec3& rgb);
/// The colour without negative parts, of the same luminance.
[[nodiscard]] glm::dvec3 insideRec709(const glm::dvec3& rgb);

/// CIE 1931 x, y of a black body, 1000 to 15000 K.
[[nodiscard]] glm::dvec2 blackBodyChromaticity(double kelvin);
/// CIE 1931 x, y of CIE daylight, 4000 to 25000 K.
[[nodiscard]] glm::dvec2 daylightChromaticity(double kelvin);
/// A colour of luminance 1, inside Rec.709.
[[nodiscard]] glm::dvec3 colourOfChromaticity(const glm::dvec2& xy);

/// CIE 1931 colour matching functions x̄, ȳ, z̄ at a wavelength in nanometres.
[[nodiscard]] glm::dvec3 colourMatching(double wavelength);

}  // namespace dermis
