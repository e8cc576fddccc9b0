#include "core/light_rig/light_colour.h"

#include <cmath>

namespace dermis {

glm::dvec3 rec709FromXyz(const glm::dvec3& xyz) {
  // IEC 61966-2-1: primaries of ITU-R BT.709, white D65.
  return {3.2404542 * xyz.x - 1.5371385 * xyz.y - 0.4985314 * xyz.z,
          -0.9692660 * xyz.x + 1.8760108 * xyz.y + 0.0415560 * xyz.z,
          0.0556434 * xyz.x - 0.2040259 * xyz.y + 1.0572252 * xyz.z};
}

double luminance(const glm::dvec3& rgb) { return 0.2126729 * rgb.r + 0.7151522 * rgb.g + 0.0721750 * rgb.b; }

glm::dvec3 insideRec709(const glm::dvec3& rgb) {
  const glm::dvec3 inside = glm::max(rgb, glm::dvec3(0.0));
  const double y = luminance(inside);
  return y > 0.0 ? inside * (std::max(luminance(rgb), 0.0) / y) : inside;
}

glm::dvec2 blackBodyChromaticity(double t) {
  // Krystek 1985, "An algorithm to calculate correlated colour temperature", Color Res. Appl. 10(1): CIE 1960 u, v.
  const double u =
      (0.860117757 + 1.54118254e-4 * t + 1.28641212e-7 * t * t) / (1.0 + 8.42420235e-4 * t + 7.08145163e-7 * t * t);
  const double v =
      (0.317398726 + 4.22806245e-5 * t + 4.20481691e-8 * t * t) / (1.0 - 2.89741816e-5 * t + 1.61456053e-7 * t * t);
  const double d = 2.0 * u - 8.0 * v + 4.0;
  return {3.0 * u / d, 2.0 * v / d};
}

glm::dvec2 daylightChromaticity(double t) {
  // Judd, MacAdam & Wyszecki 1964; CIE 15:2004, equations 3.3 and 3.4.
  const double x = t <= 7000.0 ? ((-4.6070e9 / t + 2.9678e6) / t + 0.09911e3) / t + 0.244063
                               : ((-2.0064e9 / t + 1.9018e6) / t + 0.24748e3) / t + 0.237040;
  return {x, (-3.000 * x + 2.870) * x - 0.275};
}

glm::dvec3 colourOfChromaticity(const glm::dvec2& xy) {
  return insideRec709(rec709FromXyz({xy.x / xy.y, 1.0, (1.0 - xy.x - xy.y) / xy.y}));
}

glm::dvec3 colourMatching(double wavelength) {
  // Wyman, Sloan & Shirley 2013, "Simple Analytic Approximations to the CIE XYZ Color Matching Functions", equation 4.
  const auto lobe = [wavelength](double scale, double centre, double below, double above) {
    const double t = (wavelength - centre) * (wavelength < centre ? below : above);
    return scale * std::exp(-0.5 * t * t);
  };
  return {lobe(0.362, 442.0, 0.0624, 0.0374) + lobe(1.056, 599.8, 0.0264, 0.0323) - lobe(0.065, 501.1, 0.0490, 0.0382),
          lobe(0.821, 568.8, 0.0213, 0.0247) + lobe(0.286, 530.9, 0.0613, 0.0322),
          lobe(1.217, 437.0, 0.0845, 0.0278) + lobe(0.681, 459.0, 0.0385, 0.0725)};
}

}  // namespace dermis
