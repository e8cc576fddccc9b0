#include <algorithm>
#include <cmath>

#include "core/builtin/skin/noise.h"
#include "core/builtin/skin/skin_layers.h"

namespace dermis::skin {
namespace {

using enum HeadRegion;

/// Thin lines where the noise crosses 0, 1 on them; `width` in the noise's own unit.
float lines(float value, float width) { return std::exp(-value * value / (width * width)); }

float bell(float x, float width) { return std::exp(-x * x / (width * width)); }

/// Share of how old skin looks, from 25 to 85 years.
float aged(const Look& look) { return glm::smoothstep(25.0F, 85.0F, look.age); }

/// Melanin in spots, as a sum of optical depths over the skin's own.
float freckles(const SkinPlace& at, const Look& look) {
  // Where the sun falls on a face that looks ahead; none on lips and lids' margins.
  const float sunned = 0.12F + 0.75F * at[Cheek] + 0.8F * at[Nose] + 0.35F * at[Forehead] + 0.45F * at[UnderEye] +
                       0.25F * at[Chest] + 0.3F * at[Ear];
  const float open = 1.0F - std::max({at[Lips], at[LidMargin], at[Caruncle], at[Scalp]});
  if (look.freckles * sunned * open < 0.005F) return 0.0F;
  const float patchy = 1.0F + 0.6F * fractal(at.p / 22.0F, 2, look.seed + 60);
  const float amount = look.freckles * sunned * open * patchy;
  const glm::vec3 wobble = 0.35F * glm::vec3(noise(at.p / 1.3F, look.seed + 61), noise(at.p / 1.3F, look.seed + 62),
                                             noise(at.p / 1.3F, look.seed + 63));
  return 1.3F * spots((at.p + wobble) / 1.8F, 1.1F * amount, 0.56F, 0.5F, look.seed + 64) +
         1.7F * spots((at.p + 1.6F * wobble) / 3.3F, 0.65F * amount, 0.5F, 0.45F, look.seed + 65);
}

float moles(const SkinPlace& at, const Look& look) {
  const float open = 1.0F - std::max({at[Lips], at[LidMargin], at[Caruncle]});
  return open * 7.0F * spots(at.p / 34.0F, 0.2F, 0.035F, 0.25F, look.seed + 70);
}

float ageSpots(const SkinPlace& at, const Look& look) {
  const float old = glm::smoothstep(45.0F, 85.0F, look.age);
  if (old <= 0.0F) return 0.0F;
  const glm::vec3 wobble = 2.0F * glm::vec3(noise(at.p / 4.0F, look.seed + 71), noise(at.p / 4.0F, look.seed + 72),
                                            noise(at.p / 4.0F, look.seed + 73));
  const float where = 0.3F + 0.5F * at[Forehead] + 0.5F * at[Cheek] + 0.5F * at[Scalp] + 0.4F * at[CrowsFeet];
  return 0.9F * spots((at.p + wobble) / 13.0F, old * where * 0.6F, 0.3F, 0.4F, look.seed + 74);
}

/// How densely hair grows: of the shaved scalp and the beard, 0..1. Its borders wander, as a hairline does.
float growth(const SkinPlace& at, const Look& look) {
  const float scalp = at[Scalp] * (1.0F - at[Ear]);
  // Thick on lip and chin, thin on the cheeks and below the corners of the mouth.
  const float patch = bell(std::abs(at.p.x) - 21.0F, 8.0F) * bell(at.p.y + 86.0F, 9.0F);
  const float middle = glm::smoothstep(48.0F, 18.0F, std::abs(at.p.x)) * glm::smoothstep(60.0F, 85.0F, at.p.z);
  const float beard = at[Beard] * (0.62F + 0.3F * middle - 0.25F * patch);
  const float most = std::max(scalp, beard);
  if (most <= 0.0F) return 0.0F;
  const float wander = 0.3F * fractal(at.p / 8.0F, 2, look.seed + 82) + 0.1F * fractal(at.p / 31.0F, 2, look.seed + 84);
  return std::clamp(most * (1.0F + 0.4F * wander) + 3.0F * wander * most * (1.0F - most), 0.0F, 1.0F);
}

/// Hairs that hide skin, and shafts in it: below the brows' own hairs a shade; stubble is dots, one a follicle, over
/// the shade of what stands below the surface.
void growHairs(const SkinPlace& at, const Look& look, PigmentLayers& out) {
  out.hair = std::max(0.0F, at[Brow] * (0.16F + 0.12F * noise(at.p / 1.1F, look.seed + 80)));
  const float density = look.stubble > 0.0F ? growth(at, look) : 0.0F;
  if (density <= 0.0F) return;
  constexpr float kSpacing = 0.85F;
  const Cells follicle = cells(at.p / kSpacing, look.seed + 83);
  const std::uint32_t own = latticeHash(glm::ivec3(static_cast<int>(follicle.hash & 0xFFFFU), 5, 9), look.seed + 83);
  // Thinner growth is fewer hairs, not fainter ones.
  const float present = glm::smoothstep(0.0F, 0.1F, density - 0.92F * unit(own));
  const float end = bell(follicle.first, 0.24F + 0.06F * unit(own, 11));
  out.hair = std::min(1.0F, out.hair + std::min(1.0F, 0.25F + 0.75F * look.stubble) * 0.85F * present * end);
  out.buried = 0.44F * look.stubble * density;
}

/// Veins near the surface, 0..1: at the temples, on the lids, on neck and chest.
float veins(const SkinPlace& at, const Look& look) {
  const float side = glm::smoothstep(46.0F, 60.0F, std::abs(at.p.x)) * glm::smoothstep(-8.0F, 12.0F, at.p.y) *
                     (1.0F - at[Ear]) * (1.0F - 0.7F * at[Scalp]);
  const float where = 0.8F * side + 0.5F * std::max(at[UpperLid], at[UnderEye]) + 0.5F * at[Neck] + 0.6F * at[Chest];
  if (where <= 0.02F) return 0.0F;
  const glm::vec3 bent =
      at.p + 5.0F * glm::vec3(noise(at.p / 14.0F, look.seed + 90), noise(at.p / 14.0F, look.seed + 91),
                              noise(at.p / 14.0F, look.seed + 92));
  // As wide everywhere: where the noise hardly changes, its zero alone would be a patch.
  constexpr float kScale = 24.0F, kStep = 1.0F, kHalfWidth = 0.8F, kLeastSlope = 0.008F;
  const auto field = [&](const glm::vec3& p) { return noise(p / kScale, look.seed + 93); };
  const float zero = field(bent);
  const glm::vec3 slope = (glm::vec3(field(bent + glm::vec3(kStep, 0, 0)), field(bent + glm::vec3(0, kStep, 0)),
                                     field(bent + glm::vec3(0, 0, kStep))) -
                           zero) /
                          kStep;
  const float net = lines(zero / std::max(glm::length(slope), kLeastSlope), kHalfWidth);
  return where * net * glm::smoothstep(-0.3F, 0.4F, noise(at.p / 30.0F, look.seed + 94));
}

}  // namespace

PigmentLayers pigmentLayers(const SkinPlace& at, const Look& look) {
  const float old = aged(look);
  const std::uint32_t s = look.seed;
  PigmentLayers out;

  // Melanin: where the sun falls and round the eyes more, on lips less; mottled at three sizes.
  float melanin = 1.0F + 0.16F * at[Forehead] + 0.12F * at[Nose] + 0.1F * at[UpperLid] + 0.05F * at[LowerLid] +
                  0.1F * at[UnderEye] - 0.16F * at[Neck] * glm::smoothstep(0.0F, 30.0F, at.p.z) + 0.1F * at[Chest];
  const float mottle = 1.0F + 0.8F * old;
  melanin *= std::exp(mottle * (0.14F * fractal(at.p / 16.0F, 3, s + 10) + 0.10F * fractal(at.p / 3.4F, 2, s + 20)));
  melanin *= 1.0F + freckles(at, look) + ageSpots(at, look) + moles(at, look);
  growHairs(at, look, out);
  out.melanin = glm::mix(melanin, 0.45F * melanin, at[Lips]);
  // The inner corner and the margins of the lids are mucous: no melanin to speak of.
  out.melanin *= 1.0F - 0.7F * std::max(at[Caruncle], at[LidMargin]);

  // Blood: full where the skin is thin or the vessels wide.
  const float warm = 0.35F * at[Cheek] + 0.5F * at[NoseTip] + 0.2F * at[Nose] + 0.65F * at[Ear] + 0.15F * at[UpperLid] +
                     0.2F * at[LowerLid] + 0.3F * at[Chin] + 0.4F * at[UnderEye] - 0.2F * at[Forehead] -
                     0.1F * at[Neck];
  const float flushed = look.flush * (1.7F * at[Cheek] + 1.4F * at[NoseTip] + 1.3F * at[Ear] + 0.5F * at[Chin] +
                                      0.35F * at[Forehead] + 0.6F * at[Chest]);
  const float blotched =
      std::exp(0.22F * mottle * fractal(at.p / 11.0F, 3, s + 30) + 0.16F * fractal(at.p / 2.3F, 3, s + 40));
  float blood = (1.0F + warm + flushed) * blotched;
  // Widened capillaries beside the nose come with age.
  const float widened = 1.2F * old * std::max(at[NoseTip], 0.7F * at[Cheek]);
  if (widened > 0.01F)
    blood += widened * lines(noise(at.p / 2.6F + 0.4F * fractal(at.p / 1.1F, 2, s + 51), s + 50), 0.06F);
  const float vein = veins(at, look);
  blood += 0.35F * vein;
  // The red of the lips, in streaks along their furrows.
  if (at[Lips] > 0.0F) {
    const float streak = 1.0F + 0.18F * noise(glm::vec3(at.p.x / 0.8F, at.p.y / 4.0F, 0.0F), s + 52);
    blood = glm::mix(blood, 2.8F * streak * blotched * (1.0F - 0.25F * old), at[Lips]);
  }
  blood = glm::mix(blood, 6.0F, std::max(at[Caruncle], 0.6F * at[LidMargin]));
  out.blood = blood;

  out.oxygenation = 0.75F - 0.4F * vein - 0.1F * at[UnderEye] - 0.1F * at[UpperLid] + 0.12F * at[Lips];
  return out;
}

float skinRoughness(const SkinPlace& at, const Look& look) {
  // Sebum makes the middle of the face glossier (Weyrich et al. 2006, "Analysis of Human Faces using a
  // Measurement-Based Skin Reflectance Model": nose and forehead have the narrowest lobes, cheeks and chin wider ones).
  float roughness = 0.49F - 0.05F * at[Forehead] - 0.06F * at[Nose] - 0.04F * at[Chin] - 0.03F * at[TZone] -
                    0.02F * at[NoseTip] - 0.03F * at[UpperLid] + 0.03F * at[Neck] - 0.04F * at[Scalp] +
                    0.05F * aged(look);
  roughness += 0.03F * fractal(at.p / 6.0F, 2, look.seed + 100) + 0.02F * noise(at.p / 1.4F, look.seed + 101);
  if (at[Lips] > 0.0F) roughness = glm::mix(roughness, 0.36F + 0.05F * noise(at.p / 1.2F, look.seed + 102), at[Lips]);
  roughness = glm::mix(roughness, 0.22F, std::max(at[LidMargin], at[Caruncle]));
  return std::clamp(roughness, 0.15F, 0.8F);
}

}  // namespace dermis::skin
