// Which part of the face a point is: what maps and materials are made from.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <string_view>

#include "core/builtin/head/brow.h"
#include "core/builtin/head/ear.h"
#include "core/builtin/head/lids.h"
#include "core/builtin/head/lips.h"
#include "core/builtin/head/profile.h"

namespace dermis {

enum class HeadRegion : std::uint8_t {
  Lips,     ///< the red of both lips
  Nose,     ///< bridge, tip and wings
  NoseTip,  ///< tip and wings alone
  Cheek,    ///< where it flushes
  Chin,
  Forehead,
  TZone,  ///< the oily part: forehead, nose, chin
  Brow,   ///< where the eyebrow grows
  UpperLid,
  LowerLid,
  LidMargin,  ///< between the lashes and the eyeball: wet
  Caruncle,   ///< the eye's inner corner: wet
  UnderEye,   ///< thin, dark skin below the lower lid
  CrowsFeet,
  Ear,
  Scalp,
  Beard,  ///< where it grows, lips left out
  Neck,
  Chest,  ///< shoulders and below the neck
  Hidden  ///< in nostrils, behind the lids, between the lips, the base
};
inline constexpr std::size_t kHeadRegionCount = 20;
/// "lips", "nose", "nose_tip", …
[[nodiscard]] std::string_view headRegionName(HeadRegion region);

struct RegionWeights {
  std::array<float, kHeadRegionCount> of{};  ///< 0..1 each; regions overlap
  [[nodiscard]] float operator[](HeadRegion region) const { return of[static_cast<std::size_t>(region)]; }
};

/// Evaluates the parameters that sculpt the head, so its borders are where the form has them.
class HeadRegions {
 public:
  HeadRegions();
  /// At a rest position: millimetres, before asymmetry (Head::rest, HeadAtlas::rest).
  [[nodiscard]] RegionWeights at(const glm::vec3& rest) const;

  // Curves that wrinkles, lashes and hairs follow; heights in mm at |x| mm.
  [[nodiscard]] float mouthLine(float x) const { return m_lips.line(x); }
  [[nodiscard]] float browHeight(float x) const { return m_brow.height(x); }
  [[nodiscard]] const sculpt::Lids& lids() const { return m_lids; }

 private:
  [[nodiscard]] float lips(const glm::vec3& q) const;
  [[nodiscard]] float ear(const glm::vec3& q) const;
  /// Distance to the hairline, mm, negative on the face.
  [[nodiscard]] float overHairline(float y, float angle) const;
  void eyes(const glm::vec3& q, RegionWeights& weights) const;
  sculpt::Lips m_lips;
  sculpt::Lids m_lids;
  sculpt::Ear m_ear;
  sculpt::Brow m_brow;
  sculpt::Profile m_hairline, m_beardLine;  ///< heights over the angle about the vertical axis, 0 in front
};

}  // namespace dermis
