// The embedded head as a form: human sizes, lids that keep off the eyeballs, the regions where they should be.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <limits>

#include "core/builtin/head/regions.h"
#include "core/builtin/head/sculpt.h"

namespace dermis {
namespace {

using namespace sculpt;

const Sculpt& theSculpt() {
  static const Sculpt sculpt;
  return sculpt;
}

/// The first place outwards-in along a line where the skin is met, as the distance travelled from `from`.
float skinAlong(const glm::vec3& from, const glm::vec3& direction) {
  float travelled = 0.0F;
  for (int i = 0; i < 4000; ++i) {
    const float d = theSculpt()(from + travelled * direction);
    if (d < 0.01F) break;
    travelled += std::max(0.4F * d, 0.01F);
  }
  return travelled;
}
float halfWidth(float y, float z) { return 140.0F - skinAlong({140, y, z}, {-1, 0, 0}); }
float front(float y) { return 160.0F - skinAlong({0, y, 160}, {0, 0, -1}); }
float back(float y) { return -160.0F + skinAlong({0, y, -160}, {0, 0, 1}); }
float largest(float from, float to, const std::function<float(float)>& at) {
  float most = std::numeric_limits<float>::lowest();
  for (float x = from; x <= to; x += 1.0F) most = std::max(most, at(x));
  return most;
}

/// Length of the skin's outline at a height, mm.
float circumference(float y) {
  constexpr int kSteps = 360;
  const glm::vec3 middle(0, y, -18);
  const auto at = [&](int step) {
    const float angle = glm::radians(static_cast<float>(step));
    const glm::vec3 out(std::sin(angle), 0, std::cos(angle));
    return middle + (150.0F - skinAlong(middle + 150.0F * out, -out)) * out;
  };
  float length = 0.0F;
  for (int step = 0; step < kSteps; ++step) length += glm::distance(at(step), at(step + 1));
  return length;
}

/// How far the ear reaches along its own length, which leans back by twelve degrees.
float earLength() {
  const float lean = glm::radians(12.0F);
  const glm::vec3 along(0, std::cos(lean), -std::sin(lean));
  float low = std::numeric_limits<float>::max(), high = std::numeric_limits<float>::lowest();
  for (float x = 75.0F; x < 96.0F; x += 1.0F)
    for (float z = -42.0F; z < 12.0F; z += 1.0F)
      for (float y = -56.0F; y < 20.0F; y += 1.0F) {
        if (theSculpt()({x, y, z}) > 0.0F) continue;
        const float place = glm::dot(along, glm::vec3(x, y, z));
        low = std::min(low, place);
        high = std::max(high, place);
      }
  return high - low;
}

/// Between the places where the borders of upper and lower lip meet.
float lipLength() {
  const Lips lips;
  float x = 0.0F;
  while (lips.upperBorder(x) - lips.lowerBorder(x) > 0.3F) x += 0.05F;
  return 2.0F * x;
}

/// From the root of the nose to the hairline, as a calliper measures it.
float foreheadHeight() {
  const HeadRegions regions;
  const auto skin = [](float y) { return glm::vec3(0.0F, y, front(y)); };
  float y = 40.0F;
  while (regions.at(skin(y))[HeadRegion::Scalp] < 0.5F) y += 0.1F;
  return glm::distance(skin(7.0F), skin(y));
}

struct Measure {
  const char* name;
  float value, intended;
  float mean, deviation;  ///< of adult men in the surveys that docs/head.md cites
};

TEST(HeadForm, SizesAreIntendedAndHuman) {
  const float crown = 160.0F - skinAlong({0, 160, -10}, {0, -1, 0});
  const float menton = -150.0F + skinAlong({0, -150, 84}, {0, 1, 0});
  const float sellion = front(5.0F);
  constexpr float kTragion = -15.0F;  // the notch over the tragus
  EXPECT_NEAR(crown - menton, 233.0F, 2.0F);
  const Measure measures[] = {
      {"head length", largest(15, 30, front) - -largest(10, 50, [](float y) { return -back(y); }), 198.5F, 200.2F,
       7.0F},
      {"head breadth", 2 * largest(35, 65, [](float y) { return halfWidth(y, -27); }), 154.5F, 154.4F, 5.5F},
      {"head circumference", circumference(26), 568.0F, 575.8F, 16.3F},
      {"bizygomatic breadth", 2 * largest(25, 55, [](float z) { return halfWidth(-17, z); }), 135.5F, 142.9F, 5.9F},
      {"bigonial breadth", 2 * halfWidth(-78, 16), 113.0F, 120.4F, 10.4F},
      {"menton to sellion", 5.0F - menton, 121.0F, 122.6F, 6.6F},
      {"interpupillary breadth", 2 * kEyeCentre.x, 63.0F, 64.1F, 3.2F},
      {"nose protrusion", largest(-40, -30, front) - front(-52), 19.6F, 21.1F, 2.7F},
      {"lip length", lipLength(), 51.8F, 51.1F, 4.2F},
      {"forehead height", foreheadHeight(), 69.0F, 67.1F, 7.5F},
      {"ear length", earLength(), 63.0F, 64.5F, 4.3F},
      {"tragion to the top of the head", crown - kTragion, 132.0F, 131.4F, 6.1F},
      {"neck circumference", circumference(-118), 372.0F, 397.8F, 25.1F},
  };
  for (const Measure& m : measures) {
    EXPECT_NEAR(m.value, m.intended, 1.0F) << m.name;
    EXPECT_NEAR(m.value, m.mean, 2.0F * m.deviation) << m.name << ": outside two deviations of the mean";
  }
  EXPECT_LT(sellion, front(22.0F)) << "the root of the nose lies behind the brow";
}

TEST(HeadForm, LidsKeepOffTheEyeball) {
  // No skin within the eyeball, whose surface is sampled at a millimetre, and air outside it by the whole gap.
  int lids = 0;
  for (float theta = 0.0F; theta < 180.0F; theta += 5.0F)
    for (float phi = 0.0F; phi < 360.0F; phi += 5.0F) {
      const float t = glm::radians(theta), p = glm::radians(phi);
      const glm::vec3 direction(std::sin(t) * std::cos(p), std::sin(t) * std::sin(p), std::cos(t));
      ASSERT_GT(theSculpt()(kEyeCentre + kEyeRadius * direction), 0.05F) << theta << " " << phi;
      const bool covered = theSculpt()(kEyeCentre + (kEyeRadius + 1.0F) * direction) < 0.0F;
      lids += covered && theta > 40.0F ? 1 : 0;
    }
  EXPECT_GT(lids, 500) << "the lids and the socket are there";
}

TEST(HeadForm, EarIsThin) {
  // Through the plate from outside, in the ear's own frame, behind the concha.
  const Ear& ear = theSculpt().ear();
  const auto place = [&](float v, float u, float w) {
    // Inverts Ear::local, whose axes are orthonormal.
    const glm::vec3 zero = ear.local(glm::vec3(0.0F));
    const glm::mat3 axes = glm::transpose(
        glm::mat3(ear.local({1, 0, 0}) - zero, ear.local({0, 1, 0}) - zero, ear.local({0, 0, 1}) - zero));
    return axes * (glm::vec3(v, u, w) - zero);
  };
  const auto thickness = [&](float v, float u) {
    float inside = 0.0F;
    for (float w = 8.0F; w > -8.0F; w -= 0.05F) {
      if (theSculpt()(place(v, u, w)) < 0.0F) inside += 0.05F;
      if (inside > 0.0F && theSculpt()(place(v, u, w)) > 0.0F) break;
    }
    return inside;
  };
  for (const glm::vec2 at : {glm::vec2(23.0F, 12.0F), {23.0F, 4.0F}, {14.0F, 24.0F}}) {
    EXPECT_GT(thickness(at.x, at.y), 1.5F) << at.x << " " << at.y;
    EXPECT_LT(thickness(at.x, at.y), 4.5F) << at.x << " " << at.y;
  }
  EXPECT_GT(thickness(6.0F, -24.0F), 3.0F) << "the lobe is thicker";
}

TEST(HeadForm, RegionsLieWhereTheFormHasThem) {
  const HeadRegions regions;
  const auto onSkin = [&](float x, float y) { return glm::vec3(x, y, 160.0F - skinAlong({x, y, 160}, {0, 0, -1})); };
  EXPECT_GT(regions.at(onSkin(6, -74))[HeadRegion::Lips], 0.9F);
  EXPECT_LT(regions.at(onSkin(6, -84))[HeadRegion::Lips], 0.05F);
  EXPECT_GT(regions.at(onSkin(0, -36))[HeadRegion::NoseTip], 0.8F);
  EXPECT_GT(regions.at(onSkin(-42, -33))[HeadRegion::Cheek], 0.7F);
  EXPECT_GT(regions.at(onSkin(0, 50))[HeadRegion::Forehead], 0.9F);
  EXPECT_GT(regions.at(onSkin(25, 20.5F))[HeadRegion::Brow], 0.5F);
  EXPECT_GT(regions.at({0, 112, 10})[HeadRegion::Scalp], 0.9F);
  EXPECT_GT(regions.at(onSkin(31.5F, 6.0F))[HeadRegion::UpperLid], 0.5F);
  EXPECT_GT(regions.at(onSkin(31.5F, -7.5F))[HeadRegion::LowerLid], 0.5F);
  EXPECT_GT(regions.at({53, -140, -10})[HeadRegion::Neck], 0.9F);
  EXPECT_GT(regions.at({85, 2, -18})[HeadRegion::Ear], 0.5F);
  for (float y = -200.0F; y < 120.0F; y += 8.0F) {
    const RegionWeights left = regions.at(onSkin(20, y)), right = regions.at(onSkin(20, y) * glm::vec3(-1, 1, 1));
    for (std::size_t i = 0; i < kHeadRegionCount; ++i) {
      ASSERT_EQ(left.of[i], right.of[i]) << headRegionName(static_cast<HeadRegion>(i));
      ASSERT_GE(left.of[i], 0.0F);
      ASSERT_LE(left.of[i], 1.0F);
    }
  }
}

}  // namespace
}  // namespace dermis
