// A clear sky and its sun: Preetham, Shirley & Smits 1999, "A Practical Analytic Model for Daylight".
#pragma once

#include <array>
#include <glm/glm.hpp>

namespace dermis {

/// Luminance and chromaticity of the sky for one place of the sun. Good for turbidities 2 to 6 and a sun above the
/// horizon, as its authors say; below the horizon the sun is taken at it.
class SkyModel {
 public:
  /// `sun`: unit vector towards it.
  SkyModel(double turbidity, const glm::dvec3& sun);

  /// CIE x, y and luminance in cd/m² along a unit vector above the horizon.
  [[nodiscard]] glm::dvec3 xyY(const glm::dvec3& direction) const;
  /// The same as linear Rec.709, cd/m².
  [[nodiscard]] glm::dvec3 radiance(const glm::dvec3& direction) const;
  /// x, y, Y overhead.
  [[nodiscard]] const glm::dvec3& zenith() const { return m_zenith; }

 private:
  struct Perez {
    double a, b, c, d, e;
    [[nodiscard]] double value(double cosTheta, double gamma, double cosGamma) const;
  };
  glm::dvec3 m_sun;
  glm::dvec3 m_zenith;
  std::array<Perez, 3> m_perez;      ///< of x, y, Y
  std::array<double, 3> m_overhead;  ///< their values overhead
};

/// Irradiance of the sun's disc on a surface that faces it, below an atmosphere of this turbidity: linear Rec.709, lux.
/// 0 with the sun below the horizon.
[[nodiscard]] glm::dvec3 sunIlluminance(double turbidity, double sunElevation);

}  // namespace dermis
