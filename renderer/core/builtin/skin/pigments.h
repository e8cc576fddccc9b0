// From what is in skin to its colour: melanin in the epidermis, blood in the dermis.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <vector>

namespace dermis::skin {

struct Pigments {
  double melanin = 0.02;      ///< volume fraction of melanosomes in the epidermis, 0.013 (fair) to 0.43 (dark)
  double blood = 0.01;        ///< volume fraction of whole blood in the dermis, 0.002 to 0.07
  double oxygenation = 0.75;  ///< share of the haemoglobin that carries oxygen
};

/// Absorption of whole blood, 1/cm, 400 to 700 nm.
[[nodiscard]] double bloodAbsorption(double nanometres, double oxygenation);
/// Diffuse reflectance at a wavelength.
[[nodiscard]] double skinReflectance(double nanometres, const Pigments& pigments);
/// Under D65 as linear Rec.709.
[[nodiscard]] glm::dvec3 skinAlbedo(const Pigments& pigments);

/// skinAlbedo() by table, for millions of texels.
class AlbedoTable {
 public:
  AlbedoTable();
  [[nodiscard]] glm::vec3 at(float melanin, float blood, float oxygenation) const;

 private:
  static constexpr int kSteps = 56;
  [[nodiscard]] const glm::vec3& logarithm(int melanin, int blood, int oxygen) const;
  std::vector<glm::vec3> m_logarithms;
};

/// The pigments whose albedo has the colour of `albedo`, whatever its brightness, most nearly.
[[nodiscard]] Pigments pigmentsOf(const glm::dvec3& albedo);

/// Albedo of skin tone 1 to 6; between them in equal ratios.
[[nodiscard]] glm::dvec3 toneAlbedo(double tone);

}  // namespace dermis::skin
