#include "colour/false_colour.h"

#include <algorithm>
#include <cmath>

namespace dermis {

namespace {

constexpr glm::vec3 kAboveRange(0.86F, 0.10F, 0.10F);
/// Half floats and the mean of many samples end a little beside the limit; that is no error.
constexpr float kTolerance = 0.002F;

float thickestMillimetres(const ResolvedScene& scene) {
  float thickest = 0.0F;
  for (const ResolvedMaterial& slot : scene.slots)
    if (slot.material.model == ShadingModel::Skin)
      thickest = std::max(thickest, slot.material.parameters.transmissionThicknessMaxMm);
  return thickest > 0.0F ? thickest : MaterialParameters().transmissionThicknessMaxMm;
}

}  // namespace

glm::vec3 viridis(float share) {
  static constexpr glm::vec3 kTerms[] = {{0.276788F, 0.003760F, 0.337536F},   {-0.135082F, 1.479996F, 0.959632F},
                                         {2.095792F, -0.615107F, 5.078130F},  {-13.319863F, -2.501471F, -40.379558F},
                                         {20.558165F, 8.221440F, 97.061529F}, {-6.324603F, -8.707683F, -101.116871F},
                                         {-2.167732F, 3.023969F, 38.195460F}};
  const float t = std::clamp(share, 0.0F, 1.0F);
  glm::vec3 colour(0.0F);
  for (auto term = std::rbegin(kTerms); term != std::rend(kTerms); ++term) colour = *term + t * colour;
  return colour;
}

bool isData(Aov aov) {
  switch (aov) {
    case Aov::Normal:
    case Aov::Thickness:
    case Aov::Occlusion:
    case Aov::Depth:
    case Aov::ProfileId:
    case Aov::Energy:
      return true;
    default:
      return false;
  }
}

std::optional<ValueRange> valueRange(Aov aov, const ResolvedScene& scene, const Camera& camera) {
  switch (aov) {
    case Aov::Thickness:
      return ValueRange{0.0F, thickestMillimetres(scene), 1.0F, ColourRamp::Viridis, false};
    case Aov::Energy:
      return ValueRange{0.0F, 1.0F, 0.0F, ColourRamp::Viridis, true};
    case Aov::Depth: {
      const Bounds& bounds = scene.model->bounds;
      const glm::vec3 forward = glm::normalize(camera.target - camera.position);
      const float middle = glm::dot(bounds.centre() - camera.position, forward);
      const float half = 0.5F * glm::dot(bounds.max - bounds.min, glm::abs(forward));
      return ValueRange{std::max(middle - half, 0.0F), middle + half, scene.millimetresPerUnit,
                        ColourRamp::WhiteToBlack, false};
    }
    default:
      return std::nullopt;
  }
}

glm::vec3 falseColour(const ValueRange& range, float value) {
  if (range.marksAbove && value > range.high + kTolerance) return kAboveRange;
  const float share = (value - range.low) / std::max(range.high - range.low, 1e-6F);
  if (range.ramp == ColourRamp::WhiteToBlack) return glm::vec3(1.0F - std::clamp(share, 0.0F, 1.0F));
  return viridis(share);
}

}  // namespace dermis
