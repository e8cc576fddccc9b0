// The integrals behind the DFG tables, by quadrature.
#pragma once

namespace dermis {

enum class DfgGeometry {
  Smith,       ///< height-correlated Smith for GGX (Heitz 2014)
  SchlickIbl,  ///< Schlick-GGX with k = roughness² / 2, separable, as the published shader's tables
};

/// Scale and bias of the split sum: the directional albedo for F0 and f90 = 1 is F0 · scale + bias.
struct DfgValue {
  double scale, bias;
};

/// ∫ D G F / (4 (n·v)(n·l)) (n·l) dω_l for Schlick's Fresnel, by `points`² Gauss-Legendre points over the normals
/// visible from v. Accurate to 1e-4 for any cosine and perceptual roughness in 0..1 with 48 points.
[[nodiscard]] DfgValue dfgQuadrature(DfgGeometry geometry, double cosine, double perceptualRoughness, int points = 48);

}  // namespace dermis
