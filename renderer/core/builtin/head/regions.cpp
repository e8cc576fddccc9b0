#include "core/builtin/head/regions.h"

#include <cmath>

#include "core/builtin/head/nose.h"
#include "core/builtin/head/sdf.h"

namespace dermis {
namespace {

using namespace sculpt;

constexpr std::array<std::string_view, kHeadRegionCount> kNames = {
    "lips",       "nose",     "nose_tip",  "cheek",      "chin", "forehead", "t_zone", "brow", "upper_lid", "lower_lid",
    "lid_margin", "caruncle", "under_eye", "crows_feet", "ear",  "scalp",    "beard",  "neck", "chest",     "hidden"};

float blob(const glm::vec3& p, const glm::vec3& centre, const glm::vec3& widths) {
  const glm::vec3 off = (p - centre) / widths;
  return std::exp(-glm::dot(off, off));
}

}  // namespace

std::string_view headRegionName(HeadRegion region) { return kNames[static_cast<std::size_t>(region)]; }

HeadRegions::HeadRegions()
    // Level over the forehead, back at its corners, forward to the temples, down before the ear as a whisker.
    : m_hairline({{0, 73},
                  {0.3F, 74},
                  {0.55F, 77},
                  {0.76F, 75},
                  {0.85F, 68},
                  {0.91F, 46},
                  {1.0F, 35},
                  {1.14F, 31},
                  {1.22F, 20},
                  {1.28F, -2},
                  {1.36F, -16},
                  {1.55F, -24},
                  {1.8F, -40},
                  {2.3F, -68},
                  {3.1416F, -84}}),
      m_beardLine(
          {{0, -48}, {0.2F, -51}, {0.45F, -57}, {0.7F, -52}, {0.95F, -40}, {1.2F, -22}, {1.35F, -8}, {1.5F, 4}}) {}

float HeadRegions::lips(const glm::vec3& q) const {
  constexpr float kHalfWidth = 27.0F;
  if (q.z < 75.0F || q.x > kHalfWidth) return 0.0F;
  const float inside = std::min(m_lips.upperBorder(q.x) + 0.3F - q.y, q.y - m_lips.lowerBorder(q.x) + 0.2F);
  // The red runs out before the corner does.
  return ramp(-0.5F, 0.5F, inside) * fade(23.8F, kHalfWidth, q.x);
}

float HeadRegions::ear(const glm::vec3& q) const {
  if (q.x < 50.0F) return 0.0F;
  const glm::vec3 at = m_ear.local(q);
  if (EarMap::beyond(at.x, at.y) > 0.0F) return 0.0F;
  const EarMap::Sample map = m_ear.map().at(at.x, at.y);
  return fade(-2.0F, 2.0F, map.outline) * ramp(-10.0F, -6.0F, at.z - map.height) * ramp(-3.0F, 1.0F, at.x);
}

void HeadRegions::eyes(const glm::vec3& q, RegionWeights& weights) const {
  const glm::vec3 off = q - kEyeCentre;
  const float reach = glm::length(off);
  if (reach > 40.0F || q.z < 50.0F) return;
  const auto set = [&](HeadRegion region, float value) { weights.of[static_cast<std::size_t>(region)] = value; };
  const float open = m_lids.opening(q);
  const float outer = fade(kLidRadius + 2.0F, kLidRadius + 6.0F, reach);
  const float middle = 0.5F * (m_lids.upperEdge(off.x) + m_lids.lowerEdge(off.x));
  const float upper = ramp(-0.5F, 0.5F, off.y - middle);
  const float caruncle = blob(q, {kEyeCentre.x - 12.9F, kEyeCentre.y - 1.5F, 78.0F}, {2.6F, 1.9F, 2.6F});
  set(HeadRegion::Caruncle, caruncle);
  // The margin: the lid's wall in the opening, from the eyeball to its outer edge.
  const float wall = fade(0.35F, 0.9F, std::abs(open)) * ramp(kEyeRadius - 0.5F, kEyeRadius + 0.3F, reach) *
                     fade(kLidRadius - 0.3F, kLidRadius + 0.4F, reach) * ramp(-15.5F, -13.0F, off.x) *
                     fade(14.0F, 16.0F, off.x);
  set(HeadRegion::LidMargin, wall * (1.0F - caruncle));
  const float lid = outer * ramp(-0.2F, 0.8F, open);
  set(HeadRegion::UpperLid, lid * upper * fade(9.0F, 12.5F, off.y));
  set(HeadRegion::LowerLid, lid * (1.0F - upper) * ramp(-12.0F, -9.0F, off.y));
  set(HeadRegion::UnderEye, blob(q, {27, -13, 84}, {13, 6, 14}) * ramp(0.5F, 2.0F, open));
  set(HeadRegion::CrowsFeet, blob(q, {54, -2, 66}, {10, 10, 16}));
  const float behind = std::max(ramp(1.0F, 2.5F, open), fade(kEyeCentre.z, kEyeCentre.z + 3.0F, q.z));
  set(HeadRegion::Hidden, fade(kEyeRadius + 0.4F, kEyeRadius + 0.9F, reach) * behind);
}

float HeadRegions::overHairline(float y, float angle) const {
  constexpr float kStep = 0.02F, kRadius = 72.0F;  // of the head at the temples
  const float slope = (m_hairline(angle + kStep) - m_hairline(angle - kStep)) / (2.0F * kStep * kRadius);
  return (y - m_hairline(angle)) / std::hypot(1.0F, slope);
}

RegionWeights HeadRegions::at(const glm::vec3& rest) const {
  const glm::vec3 q(std::abs(rest.x), rest.y, rest.z);
  const float angle = std::atan2(q.x, q.z + 8.0F);
  RegionWeights weights;
  const auto set = [&](HeadRegion region, float value) {
    weights.of[static_cast<std::size_t>(region)] = glm::clamp(value, 0.0F, 1.0F);
  };
  const float lip = lips(q), ofEar = ear(q);
  set(HeadRegion::Lips, lip);
  set(HeadRegion::Ear, ofEar);
  const float tip = std::max(blob(q, {0, -37, 115}, {12, 10, 14}), 0.9F * blob(q, {14, -40, 99}, {6, 9, 11}));
  set(HeadRegion::NoseTip, tip);
  const float bridge =
      fade(9.0F, 15.0F, q.x) * ramp(-48.0F, -42.0F, q.y) * fade(2.0F, 12.0F, q.y) * ramp(78.0F, 88.0F, q.z);
  set(HeadRegion::Nose, std::max(tip, bridge));
  set(HeadRegion::Cheek, blob(q, {42, -33, 78}, {21, 19, 32}));
  set(HeadRegion::Chin, blob(q, {0, -103, 97}, {20, 13, 18}));
  const float forehead =
      ramp(22.0F, 34.0F, q.y) * fade(m_hairline(angle) - 10.0F, m_hairline(angle), q.y) * fade(0.75F, 1.0F, angle);
  set(HeadRegion::Forehead, forehead);
  set(HeadRegion::TZone,
      std::max({forehead * fade(30.0F, 48.0F, q.x), fade(12.0F, 20.0F, q.x) * ramp(14.0F, 24.0F, q.y) * forehead,
                std::max(tip, bridge), 0.8F * weights[HeadRegion::Chin],
                fade(12.0F, 22.0F, q.x) * ramp(0.0F, 12.0F, q.y) * fade(24.0F, 36.0F, q.y) * ramp(80.0F, 92.0F, q.z)}));
  set(HeadRegion::Brow, fade(0.5F, 1.25F, std::abs(q.y - m_brow.height(q.x)) / m_brow.halfWidth(q.x)) *
                            ramp(7.0F, 11.0F, q.x) * fade(50.0F, 57.0F, q.x) * ramp(50.0F, 60.0F, q.z));
  set(HeadRegion::Scalp, ramp(-7.0F, 9.0F, overHairline(q.y, angle)) * (1.0F - ofEar));
  const float below = fade(-10.0F, 5.0F, q.y - m_beardLine(angle)) * fade(1.4F, 1.6F, angle);
  // On the throat it ends along a line from over the larynx up to behind the lobe.
  const float above = ramp(-134.0F, -108.0F, q.y + 0.5F * (q.z - 50.0F));
  set(HeadRegion::Beard, below * above * (1.0F - lip) * (1.0F - tip) * (1.0F - ofEar));
  const float jaw = glm::mix(-86.0F, -116.0F, ramp(10.0F, 84.0F, q.z));
  const float neck = fade(jaw - 10.0F, jaw + 4.0F, q.y), chest = fade(-196.0F, -168.0F, q.y + 0.12F * q.x);
  set(HeadRegion::Neck, neck * (1.0F - chest));
  set(HeadRegion::Chest, chest);
  eyes(q, weights);
  const float slit =
      bell(q.y - m_lips.line(q.x), 0.45F) * lip * ramp(0.0F, 1.0F, 1.0F - std::abs(q.y - m_lips.line(q.x)));
  const float nostril =
      q.z > 85.0F && q.y < -25.0F ? fade(-0.6F, 0.6F, Nose::nostril(q)) * ramp(-47.0F, -42.0F, q.y) : 0.0F;
  set(HeadRegion::Hidden, std::max({weights[HeadRegion::Hidden], slit, nostril, fade(-219.0F, -214.0F, q.y)}));
  return weights;
}

}  // namespace dermis
