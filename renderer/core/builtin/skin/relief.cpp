#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "core/builtin/skin/noise.h"
#include "core/builtin/skin/skin_layers.h"

namespace dermis::skin {
namespace {

using enum HeadRegion;

float bell(float x, float width) { return std::exp(-x * x / (width * width)); }

/// How much of detail `size` mm across a picture of this density can hold: none below two texels, all from three.
float kept(float size, float millimetresPerTexel) { return glm::smoothstep(2.0F, 3.0F, size / millimetresPerTexel); }

/// A fold: a narrow valley along distance 0 with a low rise on both sides. −1 at its bottom.
float fold(float distance, float width) { return 0.25F * bell(distance, 2.6F * width) - 1.25F * bell(distance, width); }

float pores(const SkinPlace& at, const Look& look, float texel) {
  const float depth =
      0.04F + 0.14F * at[NoseTip] + 0.09F * at[Nose] + 0.14F * at[Cheek] + 0.07F * at[Chin] + 0.05F * at[Forehead];
  const float bare = 1.0F - std::max({at[Lips], at[LidMargin], at[Caruncle], at[UnderEye], at[Ear], at[UpperLid]});
  if (bare <= 0.0F) return 0.0F;
  constexpr float kSpacing = 1.0F;
  const Cells net = cells(at.p / kSpacing, look.seed + 110);
  const float size = 0.6F + 0.4F * unit(net.hash, 7);
  // A pore narrower than a texel is drawn a texel wide and so much shallower.
  const float radius = std::max(0.2F * size, 0.8F * texel);
  const float drawn = std::min(1.0F, 0.2F * size / radius);
  return -bare * depth * (1.0F + 0.5F * glm::smoothstep(30.0F, 70.0F, look.age)) * size * drawn *
         bell(net.first * kSpacing, radius);
}

/// The net of furrows that all skin has: ridges between cells, drawn out with age.
float net(const SkinPlace& at, const Look& look, float texel) {
  float height = 0.0F;
  const float strength = (0.4F + 0.6F * glm::smoothstep(20.0F, 70.0F, look.age)) * (1.0F - 0.85F * at[NoseTip]) *
                         (1.0F - std::max(at[Lips], at[LidMargin]));
  for (const float size : {1.7F, 0.8F}) {
    const float share = kept(0.5F * size, texel);
    if (share <= 0.0F) continue;
    const Cells c = cells(at.p / size, look.seed + static_cast<std::uint32_t>(120.0F + 10.0F * size));
    height -= share * 0.07F * size * strength * bell((c.second - c.first) * size, 0.28F * size);
  }
  return height + 0.012F * strength * kept(1.2F, texel) * noise(at.p / 1.2F, look.seed + 125);
}

float lips(const SkinPlace& at, const HeadRegions& curves, const Look& look, float texel) {
  if (at[Lips] <= 0.0F) return 0.0F;
  // Furrows run from the mouth line outwards, spreading a little towards the corners.
  const float away = at.p.y - curves.mouthLine(std::abs(at.p.x));
  const float across = at.p.x * (1.0F - 0.012F * std::abs(away)) + 0.5F * noise(at.p / 3.0F, look.seed + 130);
  const float coarse = noise({across / 1.5F, 0.11F * away, 0.5F}, look.seed + 131);
  const float fine = kept(0.5F, texel) * noise({across / 0.8F, 0.2F * away, 3.5F}, look.seed + 132);
  const float depth = 0.09F + 0.1F * glm::smoothstep(35.0F, 75.0F, look.age);
  return -depth * at[Lips] * (bell(coarse, 0.16F) + 0.4F * bell(fine, 0.25F));
}

float forehead(const SkinPlace& at, const HeadRegions& curves, const Look& look) {
  const float old = glm::smoothstep(22.0F, 80.0F, look.age);
  const float x = std::abs(at.p.x);
  float height = 0.0F;
  if (at[Forehead] > 0.0F) {
    // Lines follow the brows, each broken where the muscle's two halves meet or don't.
    const float lifted = at.p.y - 0.35F * (curves.browHeight(std::clamp(x, 8.0F, 50.0F)) - 20.0F) +
                         2.2F * noise(glm::vec3(at.p.x / 26.0F, at.p.y / 40.0F, 0.0F), look.seed + 140);
    constexpr float kSpacing = 8.5F;
    const float row = std::round((lifted - 36.0F) / kSpacing);
    const float off = lifted - 36.0F - kSpacing * row;
    const float broken = glm::smoothstep(-0.35F, 0.25F, noise({at.p.x / 22.0F, 7.3F * row, 0.5F}, look.seed + 141));
    height += (0.015F + 0.75F * old) * at[Forehead] * broken * fold(off, 0.9F + 0.4F * old);
  }
  // The two upright lines between the brows.
  const float between = bell(at.p.y - 16.0F, 11.0F) * glm::smoothstep(60.0F, 85.0F, at.p.z);
  if (between > 0.02F)
    height += 0.75F * old * between * fold(x - 7.5F - 1.5F * noise(at.p / 9.0F, look.seed + 142), 1.2F);
  return height;
}

float eyes(const SkinPlace& at, const Look& look) {
  const float old = glm::smoothstep(24.0F, 75.0F, look.age);
  const float x = std::abs(at.p.x);
  float height = 0.0F;
  if (at[CrowsFeet] > 0.02F) {
    // A fan from the outer corner of the eye, on the surface: sideways is x and z together.
    const glm::vec2 from(std::hypot(x - 46.0F, at.p.z - 74.0F), at.p.y + 1.0F);
    const float angle = std::atan2(from.y, from.x) + 0.12F * noise(at.p / 7.0F, look.seed + 150);
    const float reach = glm::length(from);
    constexpr float kApart = 0.3F;
    const float ray = std::round(angle / kApart);
    const float off = (angle - kApart * ray) * reach;
    const float broken =
        glm::smoothstep(-0.4F, 0.2F, noise({reach / 9.0F, 5.1F * ray, at.p.x < 0.0F ? 0.5F : 9.5F}, look.seed + 151));
    height += (0.012F + 0.68F * old) * at[CrowsFeet] * broken * glm::smoothstep(3.0F, 8.0F, reach) *
              fold(off, 0.7F + 0.4F * old);
  }
  if (at[UnderEye] > 0.02F) {
    // Fine lines along the lower lid.
    const glm::vec2 from(x - 31.5F, at.p.y * 1.25F);
    const float rings = glm::length(from) + 0.9F * noise(at.p / 5.0F, look.seed + 152);
    constexpr float kSpacing = 2.1F;
    const float off = rings - kSpacing * std::round(rings / kSpacing);
    const float broken = glm::smoothstep(-0.3F, 0.3F, noise(at.p / 6.0F, look.seed + 153));
    height += (0.008F + 0.26F * old) * at[UnderEye] * broken * fold(off, 0.45F + 0.2F * old);
  }
  return height;
}

/// Distance in front view to a line through some points, and how far along it from 0 to 1.
glm::vec2 toLine(const glm::vec2& p, std::span<const glm::vec2> line) {
  glm::vec2 best(1e6F, 0.0F);
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const glm::vec2 step = line[i + 1] - line[i];
    const float along = std::clamp(glm::dot(p - line[i], step) / glm::dot(step, step), 0.0F, 1.0F);
    const float distance = glm::distance(p, line[i] + along * step);
    if (distance < best.x) best = {distance, (static_cast<float>(i) + along) / static_cast<float>(line.size() - 1)};
  }
  return best;
}

/// The folds from the nose's wings round the mouth, and from its corners down.
float mouthFolds(const SkinPlace& at, const Look& look) {
  const float old = glm::smoothstep(28.0F, 80.0F, look.age);
  if (old <= 0.0F || at.p.z < 60.0F || at.p.y > -25.0F || at.p.y < -105.0F) return 0.0F;
  constexpr std::array<glm::vec2, 5> kNasolabial = {{{17.5F, -36}, {22, -43}, {28, -53}, {33, -63}, {35.5F, -72}}};
  constexpr std::array<glm::vec2, 3> kMarionette = {{{28.5F, -71}, {30, -79}, {29.5F, -88}}};
  const glm::vec2 p(std::abs(at.p.x) + 0.9F * noise(at.p / 9.0F, look.seed + 170), at.p.y);
  const glm::vec2 upper = toLine(p, kNasolabial), lower = toLine(p, kMarionette);
  const auto ends = [](float along) {
    return glm::smoothstep(0.0F, 0.15F, along) * (1.0F - glm::smoothstep(0.6F, 1.0F, along));
  };
  return old * (0.95F * ends(upper.y) * fold(upper.x, 1.9F) + 0.5F * ends(lower.y) * fold(lower.x, 1.4F));
}

float neck(const SkinPlace& at, const Look& look) {
  if (at[Neck] <= 0.0F) return 0.0F;
  constexpr float kSpacing = 19.0F;
  const float height = at.p.y + 0.12F * at.p.z + 4.0F * noise(at.p / 40.0F, look.seed + 160);
  const float off = height - kSpacing * std::round(height / kSpacing);
  const float broken = glm::smoothstep(-0.2F, 0.5F, noise(at.p / 33.0F, look.seed + 161));
  return (0.006F + 0.3F * glm::smoothstep(30.0F, 80.0F, look.age)) * at[Neck] * broken * fold(off, 1.1F);
}

}  // namespace

float reliefHeight(const SkinPlace& at, const HeadRegions& curves, const Look& look, float texel) {
  if (at[Hidden] >= 1.0F) return 0.0F;
  const float height = pores(at, look, texel) + net(at, look, texel) + lips(at, curves, look, texel) +
                       forehead(at, curves, look) + eyes(at, look) + mouthFolds(at, look) + neck(at, look);
  return height * (1.0F - at[Hidden]) * (1.0F - 0.8F * std::max(at[LidMargin], at[Caruncle]));
}

float fineRelief(const SkinPlace& at) {
  const float smooth = std::max({0.75F * at[Lips], 0.55F * at[Ear], 0.5F * at[UpperLid], 0.4F * at[LowerLid]});
  const float strong = 0.62F + 0.38F * std::max({at[Cheek], at[NoseTip], at[Chin], 0.8F * at[Forehead]});
  return strong * (1.0F - smooth) * (1.0F - std::max({at[LidMargin], at[Caruncle], at[Hidden]}));
}

}  // namespace dermis::skin
