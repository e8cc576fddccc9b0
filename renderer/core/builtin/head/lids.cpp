#include "core/builtin/head/lids.h"

#include "core/builtin/head/sdf.h"

namespace dermis::sculpt {

Lids::Lids()
    : m_upper({{-24, -4.2F},
               {-16, -2.6F},
               {-14.2F, -1.6F},
               {-11.5F, 0.5F},
               {-7, 2.6F},
               {-1.5F, 3.5F},
               {5, 3.2F},
               {10, 2.3F},
               {13.5F, 0.9F},
               {17, -0.8F},
               {24, -4}}),
      m_lower({{-24, 1.2F},
               {-16, -1.8F},
               {-14.2F, -2.6F},
               {-11.5F, -3.3F},
               {-7, -4.4F},
               {0, -5.3F},
               {6, -4.9F},
               {10.5F, -2.9F},
               {13.5F, 0.6F},
               {17, 3},
               {24, 7}}),
      // How far back the fissure goes: to the eyeball, but shallower in the corners.
      m_floor({{-20, 79.5F},
               {-15.5F, 78.3F},
               {-13, 76.9F},
               {-11.4F, 76.1F},
               {-9, 78.2F},
               {-6, 79},
               {6, 79},
               {9, 77.6F},
               {11.3F, 76.0F},
               {13.5F, 76.6F},
               {18, 77.2F}}) {}

float Lids::opening(const glm::vec3& q) const {
  constexpr float kSlope = 0.88F;  // the edges run at an angle: the distance to them is less than the height
  const float x = q.x - kEyeCentre.x, y = q.y - kEyeCentre.y;
  return smoothMax((y - m_upper(x)) * kSlope, (m_lower(x) - y) * kSlope, 0.6F);
}

float Lids::swell(float face, const glm::vec3& q) const {
  if (q.z < 40.0F || std::abs(q.y) > 30.0F) return face;
  return smoothMin(face, glm::distance(q, kEyeCentre) - kLidRadius, 6.0F);
}

float Lids::cut(float face, const glm::vec3& q) const {
  if (q.z < 55.0F || std::abs(q.y) > 24.0F || q.x > 60.0F) return face;
  const float fissure = smoothMax(opening(q), m_floor(q.x - kEyeCentre.x) - q.z, 1.0F);
  const float caruncle = ellipsoid(q, {kEyeCentre.x - 12.9F, kEyeCentre.y - 1.5F, 77.2F}, {2.2F, 1.5F, 1.9F});
  const float lids = smoothMin(smoothMax(face, -fissure, 0.9F), caruncle, 1.0F);
  return smoothMax(lids, kEyeRadius + kLidGap - glm::distance(q, kEyeCentre), 0.5F);
}

}  // namespace dermis::sculpt
