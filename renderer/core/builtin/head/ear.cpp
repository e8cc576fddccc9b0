#include "core/builtin/head/ear.h"

#include "core/builtin/head/sdf.h"

namespace dermis::sculpt {

Ear::Ear()
    : m_origin(70.0F, -15.5F, -1.5F),
      m_helix({{{9.5F, -1.5F, -9.6F}, 1.5F},
               {{5.0F, 2, -7.6F}, 2.5F},
               {{1.2F, 6, -3.0F}, 2.8F},
               {{-0.8F, 12, 1.2F}, 2.6F},
               {{0.2F, 19, 2.4F}, 2.7F},
               {{3.5F, 25.2F, 2.8F}, 2.9F},
               {{9, 28.2F, 2.8F}, 3.0F},
               {{15.5F, 28.2F, 2.6F}, 3.0F},
               {{21.5F, 24.6F, 2.4F}, 2.9F},
               {{25.4F, 18, 2.2F}, 2.8F},
               {{26.8F, 9.5F, 1.6F}, 2.7F},
               {{25.6F, -0.5F, 0.9F}, 2.5F},
               {{22.2F, -10, 0.1F}, 2.3F},
               {{18.8F, -17, -0.4F}, 2.1F},
               {{15.6F, -23, -0.9F}, 1.9F},
               {{12.6F, -28, -0.8F}, 1.8F}}) {
  const float tilt = glm::radians(12.0F), turnedOut = glm::radians(27.0F);
  const glm::vec3 side(1, 0, 0), back(0, -std::sin(tilt), -std::cos(tilt));
  m_u = {0, std::cos(tilt), -std::sin(tilt)};
  m_v = back * std::cos(turnedOut) + side * std::sin(turnedOut);
  m_w = side * std::cos(turnedOut) - back * std::sin(turnedOut);
}

glm::vec3 Ear::local(const glm::vec3& q) const {
  const glm::vec3 off = q - m_origin;
  return {glm::dot(off, m_v), glm::dot(off, m_u), glm::dot(off, m_w)};
}

float Ear::join(float head, const glm::vec3& q) const {
  constexpr float kReach = 62.0F;
  if (q.x < 40.0F || glm::distance(q, m_origin) > kReach) return head;
  const glm::vec3 at = local(q);
  if (EarMap::beyond(at.x, at.y) > 6.0F) return head;
  const EarMap::Sample map = m_map.at(at.x, at.y);
  const float flat = m_map.steepness(at.x, at.y);
  // The slope belongs to the height alone: taken over the thickness too, steep walls would thin to nothing.
  float ear = std::abs(at.z - map.height) * flat - 0.5F * map.thickness;
  ear = smoothMax(ear, map.outline + 0.6F, 2.2F);
  ear = smoothMin(ear, m_helix.tube(at), 2.8F);
  const glm::vec3 tragus = turned(at - glm::vec3(-0.9F, -4.0F, 0.6F), -0.50F, 0.0F);
  ear = smoothMin(ear, ellipsoid(tragus, glm::vec3(0.0F), {4.9F, 5.2F, 1.9F}), 2.8F);
  // The concha goes into the skull, above the plate.
  const float hollow = smoothMax(map.concha + 0.4F, map.height + 0.35F * map.thickness / flat - at.z, 1.5F);
  const float joined = smoothMin(smoothMax(head, -hollow, 1.2F), ear, 3.0F);
  const float canal = capsule(at, {-0.6F, -3.2F, -8.5F}, {-1.6F, -2.4F, -19.0F}, 3.1F, 2.4F);
  return smoothMax(joined, -canal, 1.2F);
}

}  // namespace dermis::sculpt
