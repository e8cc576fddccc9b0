#include "core/light_rig/rig_shapes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dermis {
namespace {

/// A place on the element's face in metres from its centre, across and upright.
struct FacePoint {
  glm::vec2 p;
  glm::vec2 slope;  ///< tangents of the angles, across and upright, at which the subject is seen from there
};

/// A lamp's face in space, ready for many rays.
class Face {
 public:
  explicit Face(const RigElement& e) {
    m_centre = rigDirection(e.azimuthDegrees, e.elevationDegrees) * e.distanceM;
    m_normal = glm::normalize(e.aimM - m_centre);
    // A face that looks straight up or down has its upper edge away from the camera.
    const glm::vec3 up = std::abs(m_normal.y) < 0.9999F ? glm::vec3(0, 1, 0) : glm::vec3(0, 0, -1);
    const glm::vec3 right = glm::normalize(glm::cross(up, m_normal));  // the subject's
    const glm::vec3 upright = glm::cross(m_normal, right);
    const float roll = glm::radians(e.rollDegrees);
    m_right = std::cos(roll) * right + std::sin(roll) * upright;
    m_up = std::cos(roll) * upright - std::sin(roll) * right;
  }

  [[nodiscard]] const glm::vec3& centre() const { return m_centre; }

  /// False where the ray misses the front of the face's plane. `stretch`: metres on the face of one radian, at most.
  bool hit(const glm::vec3& direction, FacePoint& point, float& stretch) const {
    const float cosine = -glm::dot(direction, m_normal);
    const float along = -glm::dot(m_centre, m_normal);
    if (cosine <= 1e-4F || along <= 0.0F) return false;
    const float t = along / cosine;
    const glm::vec3 offset = direction * t - m_centre;
    point.p = {glm::dot(offset, m_right), glm::dot(offset, m_up)};
    point.slope = glm::vec2(glm::dot(direction, m_right), glm::dot(direction, m_up)) / cosine;
    stretch = t / cosine;
    return true;
  }

 private:
  glm::vec3 m_centre, m_normal, m_right, m_up;
};

float smoothStep(float x) {
  const float t = std::clamp(x, 0.0F, 1.0F);
  return t * t * (3.0F - 2.0F * t);
}

/// Distance to a rectangle with round corners, negative inside.
float rectangleDistance(const glm::vec2& p, const glm::vec2& half, float corner) {
  const glm::vec2 q = glm::abs(p) - half + corner;
  return glm::length(glm::max(q, glm::vec2(0.0F))) + std::min(std::max(q.x, q.y), 0.0F) - corner;
}

/// What a grid of square black cells lets through: a cell's opening, shifted by the ray's slope over the cell's depth.
float gridTransmission(const glm::vec2& slope, float cutoffDegrees) {
  const glm::vec2 open = glm::max(1.0F - glm::abs(slope) / std::tan(glm::radians(cutoffDegrees)), glm::vec2(0.0F));
  return open.x * open.y;
}

float metres(float degrees, float distance) { return 2.0F * distance * std::tan(glm::radians(degrees) / 2.0F); }

glm::vec2 halfSize(const RigElement& e) {
  constexpr float kMetre = 1.0F;
  if (e.type == RigElementType::Disc || e.type == RigElementType::Ring)
    return glm::vec2(e.diameterDegrees ? metres(*e.diameterDegrees, e.distanceM) : e.diameterM.value_or(kMetre)) / 2.0F;
  if (e.sizeDegrees)
    return glm::vec2(metres(e.sizeDegrees->x, e.distanceM), metres(e.sizeDegrees->y, e.distanceM)) / 2.0F;
  return e.sizeM.value_or(glm::vec2(kMetre)) / 2.0F;
}

/// Distance to the nearest edge (negative inside the light) and the radiance there, before edges are softened.
struct Profile {
  float distance;
  float value;
};
using ProfileFunction = std::function<Profile(const glm::vec2& p)>;

ProfileFunction rectangle(const RigElement& e, const glm::vec2& half) {
  const float corner = e.cornerShare * std::min(half.x, half.y);
  // Real boxes are brightest before the lamp and fall off towards the frame.
  return [=, edge = e.edgeShare](const glm::vec2& p) {
    const glm::vec2 q = p / half;
    return Profile{rectangleDistance(p, half, corner), 1.0F + (edge - 1.0F) * std::min(0.5F * glm::dot(q, q), 1.0F)};
  };
}

ProfileFunction disc(const RigElement& e, float radius) {
  return [=, edge = e.edgeShare](const glm::vec2& p) {
    const float r = glm::length(p);
    return Profile{r - radius, 1.0F + (edge - 1.0F) * std::min(r * r / (radius * radius), 1.0F)};
  };
}

ProfileFunction ring(const RigElement& e, float radius) {
  const float middle = 0.5F * radius * (1.0F + e.innerShare);
  const float half = 0.5F * radius * (1.0F - e.innerShare);
  return [=, edge = e.edgeShare](const glm::vec2& p) {
    const float across = std::abs(glm::length(p) - middle);
    const float share = across / half;
    return Profile{across - half, 1.0F + (edge - 1.0F) * std::min(share * share, 1.0F)};
  };
}

ProfileFunction window(const RigElement& e, const glm::vec2& half) {
  const glm::vec2 pane = 2.0F * half / e.panes;
  const glm::vec2 glass = 0.5F * (pane - e.barShare * std::min(pane.x, pane.y));
  return [=, lower = e.lowerShare, panes = e.panes](const glm::vec2& p) {
    // The pane whose middle is nearest.
    const glm::vec2 cell = glm::clamp(glm::floor((p + half) / pane), glm::vec2(0.0F), panes - 1.0F);
    const glm::vec2 fromMiddle = p + half - (cell + 0.5F) * pane;
    const float height = std::clamp(0.5F + 0.5F * p.y / half.y, 0.0F, 1.0F);
    return Profile{rectangleDistance(fromMiddle, glass, 0.0F), lower + (1.0F - lower) * height};
  };
}

}  // namespace

RigShape lampShape(const RigElement& e) {
  const glm::vec2 half = halfSize(e);
  ProfileFunction profile;
  float reach = half.x;
  float finest = 2.0F * std::min(half.x, half.y);
  float softOver = std::min(half.x, half.y);
  switch (e.type) {
    case RigElementType::Disc:
      profile = disc(e, half.x);
      break;
    case RigElementType::Ring:
      profile = ring(e, half.x);
      finest = softOver = half.x * (1.0F - e.innerShare);
      break;
    case RigElementType::Window: {
      profile = window(e, half);
      reach = glm::length(half);
      const glm::vec2 pane = 2.0F * half / e.panes;
      finest = std::max(e.barShare, 0.02F) * std::min(pane.x, pane.y);
      softOver = 0.5F * std::min(pane.x, pane.y);
      break;
    }
    default:
      profile = rectangle(e, half);
      reach = glm::length(half);
      break;
  }
  const Face face(e);
  const float soft = e.softShare * softOver;
  RigShape shape;
  shape.axis = glm::normalize(face.centre());
  shape.coneAngle = reach < e.distanceM ? std::asin(reach / e.distanceM) : std::numbers::pi_v<float>;
  shape.finest = finest / e.distanceM;
  shape.sample = [=, grid = e.gridDegrees](const glm::vec3& direction) {
    FacePoint point;
    float stretch = 0.0F;
    if (!face.hit(direction, point, stretch)) return ShapeSample{};
    const Profile at = profile(point.p);
    ShapeSample sample;
    sample.edge = std::abs(at.distance) / stretch;
    if (at.distance >= 0.0F) return sample;
    sample.value = at.value * (soft > 0.0F ? smoothStep(-at.distance / soft) : 1.0F);
    if (grid) sample.value *= gridTransmission(point.slope, *grid);
    return sample;
  };
  return shape;
}

RigShape discShape(const glm::vec3& axis, float radiusAngle) {
  RigShape shape;
  shape.axis = axis;
  shape.coneAngle = radiusAngle;
  shape.finest = 2.0F * radiusAngle;
  shape.sample = [=](const glm::vec3& direction) {
    // The chord is precise where the cosine is not.
    const float angle = 2.0F * std::asin(std::min(glm::distance(direction, axis) / 2.0F, 1.0F));
    return ShapeSample{angle <= radiusAngle ? 1.0F : 0.0F, std::abs(angle - radiusAngle)};
  };
  return shape;
}

}  // namespace dermis
