#include "core/builtin/head/asymmetry.h"

#include "core/builtin/head/lids.h"
#include "core/builtin/head/sdf.h"

namespace dermis::sculpt {
namespace {

glm::vec3 freeShift(const glm::vec3& p) {
  glm::vec3 shift(0.0F);
  const float front = ramp(10.0F, 95.0F, p.z);
  shift.x += 0.9F * std::sin(0.017F * (p.y + 45.0F)) * front;  // the middle line is no straight line
  shift.y += 0.009F * p.x * front;                             // the left side sits higher
  shift.y += 0.9F * bell(p.x - 25, 13) * bell(p.y + 69, 13) * bell(p.z - 90, 25);  // left corner of the mouth up
  shift.y += 0.9F * bell(p.x + 34, 17) * bell(p.y - 23, 9) * bell(p.z - 90, 22);   // right brow up
  shift.y -= 1.3F * ramp(48, 72, -p.x) * ramp(-80, -40, p.y);                      // right ear lower
  shift.x -= 0.8F * ramp(72, 88, -p.x);                                            // and further out
  shift.x += 0.6F * bell(p.x, 14) * bell(p.y + 37, 11) * bell(p.z - 114, 14);      // tip of the nose to the left
  shift.z += 0.7F * bell(p.x - 60, 26) * bell(p.y + 66, 26) * bell(p.z - 25, 40);  // left angle of the jaw forwards
  return shift;
}

}  // namespace

glm::vec3 asymmetrical(const glm::vec3& p) {
  constexpr float kStiff = 18.0F, kFree = 30.0F;  // mm from the eye's centre
  const glm::vec3 eye(p.x < 0.0F ? -kEyeCentre.x : kEyeCentre.x, kEyeCentre.y, kEyeCentre.z);
  const float stiff = fade(kStiff, kFree, glm::distance(p, eye));
  if (stiff <= 0.0F) return p + freeShift(p);
  return p + glm::mix(freeShift(p), freeShift(eye), stiff);
}

glm::vec3 asymmetricalNormal(const glm::vec3& p, const glm::vec3& normal) {
  constexpr float kDelta = 0.3F;
  const glm::vec3 axis = std::abs(normal.x) > 0.9F ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
  const glm::vec3 a = glm::normalize(glm::cross(axis, normal)), b = glm::cross(normal, a), here = asymmetrical(p);
  return glm::normalize(glm::cross(asymmetrical(p + kDelta * a) - here, asymmetrical(p + kDelta * b) - here));
}

}  // namespace dermis::sculpt
