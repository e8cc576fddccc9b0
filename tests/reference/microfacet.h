// Microfacet lobes in double precision, written from the papers: what the shaders are judged by. Nothing here is
// derived from the GLSL, and where a formula has several forms this file takes the textbook's.
#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <vector>

namespace dermis::reference {

using glm::dvec3;

/// GGX normal distribution, Walter et al. 2007, equation 33, in its tangent form.
[[nodiscard]] double ggxDistribution(double nDotH, double alpha);
/// Smith's Λ for GGX, Heitz 2014, equation 72.
[[nodiscard]] double smithLambda(double cosTheta, double alpha);
/// Height-correlated masking and shadowing, Heitz 2014, equation 99.
[[nodiscard]] double smithHeightCorrelated(double nDotV, double nDotL, double alpha);
/// Schlick 1994's rational approximation of one-sided Smith masking, as a product over both sides.
[[nodiscard]] double schlickGeometry(double nDotV, double nDotL, double k);
/// Schlick 1994's Fresnel.
[[nodiscard]] dvec3 schlickFresnel(const dvec3& f0, double vDotH);
/// ((n − 1)/(n + 1))².
[[nodiscard]] double f0FromIor(double ior);

/// Single-scattering Cook-Torrance BRDF of one GGX lobe, D G F / (4 n·v n·l); 0 where either direction is below the
/// surface.
[[nodiscard]] dvec3 ggxBrdf(const dvec3& f0, double alpha, const dvec3& n, const dvec3& v, const dvec3& l);

/// G(n·v, n·l) of a lobe.
using GeometryTerm = std::function<double(double, double)>;

/// Reflectance of a lobe towards n·v with Schlick's Fresnel: f0 · scale + bias. By quadrature over half vectors.
struct SplitSum {
  double scale = 0.0, bias = 0.0;
  [[nodiscard]] dvec3 albedo(const dvec3& f0) const { return f0 * scale + dvec3(bias); }
};
[[nodiscard]] SplitSum integrateSplitSum(double nDotV, double alpha, const GeometryTerm& geometry,
                                         std::size_t nodes = 40);

/// integrateSplitSum of one lobe for every n·v: tabulated once, interpolated (in sqrt(n·v), so that grazing angles have
/// points).
class SplitSumCurve {
 public:
  SplitSumCurve(double alpha, const GeometryTerm& geometry);
  [[nodiscard]] static SplitSumCurve smith(double perceptualRoughness);
  [[nodiscard]] SplitSum at(double nDotV) const;

 private:
  std::vector<SplitSum> m_points;
};

/// A specular layer of GGX lobes with Turquin 2019's compensation, and what it leaves to the body below it
/// (materials.md, section 1). A share of the surface may be metal without a body, as glTF mixes them.
class Layer {
 public:
  struct Lobe {
    double perceptualRoughness = 0.5;
    double weight = 1.0;  ///< share times intensity
  };
  Layer(const dvec3& bodyF0, std::vector<Lobe> lobes, const dvec3& metalF0 = dvec3(1.0), double metallic = 0.0);

  /// Directional albedo of everything that the lobes reflect, and of what lies over the body.
  [[nodiscard]] dvec3 albedo(double nDotV) const;
  [[nodiscard]] dvec3 bodyAlbedo(double nDotV) const { return glm::min(albedoOf(m_bodyF0, nDotV), dvec3(1.0)); }
  /// ∫ bodyAlbedo(μ) 2μ dμ.
  [[nodiscard]] const dvec3& bodyAverage() const { return m_bodyAverage; }
  /// BRDF of the lobes, compensated for the direction of view.
  [[nodiscard]] dvec3 brdf(const dvec3& n, const dvec3& v, const dvec3& l) const;
  /// Weight of the body's diffuse light from a lamp at cosine in, seen at cosine out; and that of image light.
  [[nodiscard]] dvec3 lampWeight(double in, double out) const;
  [[nodiscard]] dvec3 imageWeight(double out) const;
  [[nodiscard]] const std::vector<Lobe>& lobes() const { return m_lobes; }
  /// What lobe i reflects of light from all around.
  [[nodiscard]] dvec3 lobeAlbedo(std::size_t i, double nDotV) const;

 private:
  [[nodiscard]] dvec3 albedoOf(const dvec3& f0, double nDotV) const;
  [[nodiscard]] dvec3 lobeAlbedoOf(const dvec3& f0, std::size_t i, double nDotV) const;
  dvec3 m_bodyF0, m_metalF0, m_bodyAverage{0.0};
  double m_metallic;
  std::vector<Lobe> m_lobes;
  std::vector<SplitSumCurve> m_curves;
};

}  // namespace dermis::reference
