// Diffusion profiles: how far under the surface light spreads before it leaves. Lengths in mm, a profile a channel.
#pragma once

#include <array>
#include <glm/glm.hpp>

#include "core/material/material.h"

namespace dermis {

/// d = ℓ / s(A): what Burley's profile divides a length ℓ of the given reading by, for a surface of albedo A
/// (Christensen & Burley 2015, "Approximate Reflectance Profiles for Efficient Subsurface Scattering").
[[nodiscard]] double burleyScaling(RadiusReading reading, double albedo);

/// The share of light that enters at a point and leaves at a distance r from it, per unit of area: R(r) in 1/mm². It
/// integrates to 1 over the plane; the albedo is applied elsewhere. Either
///   Burley      R(r) = (e^(−r/d) + e^(−r/3d)) / (8π d r)             (Christensen & Burley 2015, eq. 3), or
///   Gaussians   R(r) = Σ wᵢ e^(−r²/2vᵢ) / (2π vᵢ), the weights made to sum to 1 a channel (d'Eon & Luebke 2007, eq.
///   3).
/// What has no width at all leaves where it entered: direct() says how much, and no density holds it.
class DiffusionProfile {
 public:
  /// All light leaves where it entered.
  DiffusionProfile() = default;
  [[nodiscard]] static DiffusionProfile burley(const glm::dvec3& d);
  /// `scale` multiplies the standard deviations.
  [[nodiscard]] static DiffusionProfile gaussians(const GaussianTable& table,
                                                  const glm::dvec3& scale = glm::dvec3(1.0));
  /// What a material says. `albedo` is the A that Burley's lengths depend on: one number a channel for the material,
  /// base.albedo times the mean of its map (meanAlbedo() in core/scene), so that a profile is one curve.
  [[nodiscard]] static DiffusionProfile of(const Material& material, const glm::vec3& albedo);

  [[nodiscard]] DiffusionFamily family() const { return m_family; }
  /// Burley's d, or the standard deviation of a sum of Gaussians along one axis.
  [[nodiscard]] glm::dvec3 lengths() const;
  /// Share that leaves where it entered.
  [[nodiscard]] glm::dvec3 direct() const;
  /// Radius that holds all but 1/4000 of the light: 24 d of Burley's.
  [[nodiscard]] glm::dvec3 extent() const;

  /// R(r), r > 0.
  [[nodiscard]] glm::dvec3 value(double r) const;
  /// Share that leaves within r, direct() included.
  [[nodiscard]] glm::dvec3 radialCdf(double r) const;
  /// The radius within which the share u of a channel leaves, 0 ≤ u < 1.
  [[nodiscard]] double radius(int channel, double u) const;
  /// ∫ R(√(x² + y²)) dy: what a line of light shows at the distance x ≠ 0, in 1/mm.
  [[nodiscard]] glm::dvec3 lineSpread(double x) const;
  /// What a half plane of light, lit for x > 0, shows at x: ½ at its edge, 1 far inside.
  [[nodiscard]] glm::dvec3 edgeSpread(double x) const;

  bool operator==(const DiffusionProfile&) const = default;

 private:
  /// One Gaussian of one channel.
  struct Term {
    double variance = 0.0, weight = 0.0;
    bool operator==(const Term&) const = default;
  };
  [[nodiscard]] double beyond(int channel, double r) const;  ///< 1 − CDF

  DiffusionFamily m_family = DiffusionFamily::Burley;
  glm::dvec3 m_d{0.0};
  std::array<std::array<Term, kMaxGaussians>, 3> m_terms{};
};

}  // namespace dermis
