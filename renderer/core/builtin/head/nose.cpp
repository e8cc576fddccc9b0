#include "core/builtin/head/nose.h"

#include "core/builtin/head/sdf.h"

namespace dermis::sculpt {
namespace {

bool far(const glm::vec3& p) { return p.z < 70.0F || p.y > 25.0F || p.y < -62.0F || std::abs(p.x) > 34.0F; }

}  // namespace

Nose::Nose()
    : m_dorsum({{{0, 9, 86}, 5.0F},
                {{0, 1, 86.2F}, 5.0F},
                {{0, -9, 92.6F}, 4.3F},
                {{0, -16, 97.2F}, 4.4F},
                {{0, -27, 104.6F}, 5.0F},
                {{0, -35, 109.6F}, 6.0F}}),
      m_flank({{{2.6F, 2, 76.5F}, 4.6F},
               {{4.0F, -10, 78.5F}, 5.8F},
               {{5.4F, -22, 84.5F}, 6.9F},
               {{7.4F, -33, 94.6F}, 6.3F}}),
      m_columella(
          {{{0, -40.2F, 114}, 4.0F}, {{0, -44.0F, 108.4F}, 3.3F}, {{0, -46.5F, 101}, 3.8F}, {{0, -47.5F, 96}, 4.5F}}),
      m_rim({{{5.4F, -42.2F, 111}, 1.9F},
             {{9.6F, -43.8F, 107.4F}, 2.1F},
             {{11.8F, -45.2F, 102.6F}, 2.2F},
             {{12.2F, -45.4F, 98}, 2.4F}}) {}

float Nose::bridge(const glm::vec3& p) const {
  return smoothMin(m_dorsum.tube(p), m_flank.tube(mirrored(p, 2.0F)), 20.0F);
}

float Nose::lobule(const glm::vec3& p) const {
  const glm::vec3 q = mirrored(p, 1.0F);
  float d = ellipsoid(p, {0, -35.5F, 108.6F}, {8.6F, 8.4F, 11.4F});
  d = smoothMin(d, ellipsoid(q, {3.4F, -36.4F, 113.2F}, {4.7F, 5, 5.6F}), 5.0F);  // the two domes of the tip
  const glm::vec3 wing = turned(q - glm::vec3(11.5F, -40.2F, 100.4F), 0.42F, 0.22F);
  d = smoothMin(d, ellipsoid(wing, glm::vec3(0.0F), {4.9F, 7, 10.6F}), 6.5F);
  // Without it the wall round the nostril would thin out to a knife's edge.
  d = smoothMin(d, m_rim.tube(q), 3.0F);
  return smoothMin(d, m_columella.tube(p), 3.0F);
}

float Nose::join(float face, const glm::vec3& p) const {
  if (far(p)) return face;
  const float d = smoothMin(face, bridge(p), glm::mix(10.0F, 14.0F, fade(-20.0F, 4.0F, p.y)));
  // The wing runs into the flank above it; behind and below it stands apart.
  return smoothMin(d, lobule(p), glm::mix(11.0F, 6.5F, fade(-42.0F, -30.0F, p.y)));
}

float Nose::nostril(const glm::vec3& q) {
  const glm::vec3 hole = turned(q - glm::vec3(6.7F, -43, 103.0F), 0.40F, -0.30F);
  const float opening = ellipsoid(hole, glm::vec3(0.0F), {3.0F, 9, 5.3F});
  return smoothMin(opening, capsule(q, {6.2F, -39, 101}, {5.4F, -33, 94}, 3.0F, 2.6F), 2.0F);
}

float Nose::cutNostrils(float face, const glm::vec3& q) const {
  if (q.z < 70.0F || q.y > -20.0F || q.y < -60.0F || q.x > 26.0F) return face;
  return smoothMax(face, -nostril(q), 1.8F);
}

}  // namespace dermis::sculpt
