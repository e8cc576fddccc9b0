// The published shaders as C++ in double precision, from their equations: what `thesis`, `reflection` and
// `microfacet_lab` must show.
#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <vector>

#include "reference/microfacet.h"

namespace dermis::reference {

/// Light as it arrives at a point: unit direction towards it, and irradiance on a surface facing it.
struct Arriving {
  dvec3 toLight{0.0};
  dvec3 irradiance{0.0};
};

/// Light from all around, as functions of direction.
struct Surroundings {
  std::function<dvec3(const dvec3&)> radiance;
  std::function<dvec3(const dvec3&)> irradianceOverPi;
  std::function<dvec3(const dvec3&, double perceptualRoughness)> prefiltered;
};
/// The same radiance from everywhere.
[[nodiscard]] Surroundings constantSurroundings(const dvec3& radiance);
/// Radiance base + x·d.x + y·d.y + z·d.z: smooth, different everywhere, and with exact integrals: irradiance/π is
/// base + ⅔ slope·n, and the GGX-weighted mean about r is base + m(roughness) slope·r with m a one-dimensional
/// integral.
[[nodiscard]] Surroundings linearSurroundings(const dvec3& base, const dvec3& x, const dvec3& y, const dvec3& z);

/// "Physically Based Skin rendering Using OpenGL" (2024).
struct ThesisMaterial {
  dvec3 albedo{0.8, 0.6, 0.5};
  double metallic = 0.0, roughness = 0.45, specular = 1.0, occlusion = 1.0;
  dvec3 sssColor{0.9, 0.5, 0.2};
  double sssScale = 0.6, thickness = 0.1;
};
/// The geometry term of its DFG table: Schlick-GGX with k = roughness²/2, while D's α is roughness².
[[nodiscard]] SplitSumCurve thesisSplitSum(double roughness);
[[nodiscard]] dvec3 thesisRadiance(const ThesisMaterial& material, const SplitSumCurve& table, const dvec3& n,
                                   const dvec3& v, const std::vector<Arriving>& lights, const Surroundings* around);

/// The lab's programs; values are encoded.
[[nodiscard]] dvec3 labReflection(const dvec3& n, const dvec3& v, const Surroundings& around);
enum class LabTerm { One, Smith, CookTorrance };
[[nodiscard]] dvec3 labMicrofacet(const dvec3& f0, double perceptualRoughness, LabTerm geometry, const dvec3& n,
                                  const dvec3& v, const Surroundings& around);

}  // namespace dermis::reference
