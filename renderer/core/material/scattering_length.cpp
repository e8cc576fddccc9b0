#include "core/material/scattering_length.h"

namespace dermis {

ScatteringLength scatteringLength(const MaterialParameters& parameters) {
  const glm::vec3 scale = parameters.subsurfaceScale * parameters.subsurfaceColor.rgb;
  if (parameters.subsurfaceProfile == DiffusionFamily::Burley)
    return {scale * parameters.subsurfaceRadiusMm, parameters.subsurfaceRadiusReading};
  glm::vec3 weights(0.0F);
  glm::vec3 variances(0.0F);
  for (const GaussianTerm& term : parameters.subsurfaceGaussians.terms) {
    weights += term.weight;
    variances += term.weight * term.variance;
  }
  const glm::vec3 d = glm::sqrt(variances / (7.0F * glm::max(weights, glm::vec3(1e-6F))));
  return {scale * d, RadiusReading::BurleyD};
}

}  // namespace dermis
