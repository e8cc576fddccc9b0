// What varies over a face: pigments and relief, as layers of noise in the resting head's space.
#pragma once

#include <glm/glm.hpp>

#include "core/builtin/head/regions.h"

namespace dermis::skin {

/// Who it is.
struct Look {
  float tone = 2.0F;     ///< 1 to 6: the built-in skin tones I to VI
  float melanin = 1.0F;  ///< factors on the tone's own
  float haemoglobin = 1.0F;
  float age = 28.0F;       ///< years
  float freckles = 0.08F;  ///< 0 none, 1 covered
  float flush = 0.25F;     ///< of cheeks, nose, ears
  float stubble = 0.8F;    ///< of beard and shaved scalp: 0 none, 1 three days old
  std::uint32_t seed = 1;
  bool operator==(const Look&) const = default;
};

/// A place on the skin: rest position in millimetres, and which parts of the face it belongs to.
struct SkinPlace {
  glm::vec3 p;
  RegionWeights regions;
  [[nodiscard]] float operator[](HeadRegion region) const { return regions[region]; }
};

/// Factors on the tone's pigments, and what grows over them.
struct PigmentLayers {
  float melanin = 1.0F, blood = 1.0F;
  float oxygenation = 0.75F;
  float hair = 0.0F;    ///< share of the skin that hairs hide
  float buried = 0.0F;  ///< share of it with shafts below the surface
};
[[nodiscard]] PigmentLayers pigmentLayers(const SkinPlace& place, const Look& look);

/// Height in millimetres: pores, the net of fine furrows, lines of lips, forehead and eyes. Detail finer than two
/// texels is left out.
[[nodiscard]] float reliefHeight(const SkinPlace& place, const HeadRegions& curves, const Look& look,
                                 float millimetresPerTexel);

/// How strong the finest relief is, 0..1.
[[nodiscard]] float fineRelief(const SkinPlace& place);

/// Perceptual roughness.
[[nodiscard]] float skinRoughness(const SkinPlace& place, const Look& look);

}  // namespace dermis::skin
