#include "core/builtin/head/sculpt.h"

#include "core/builtin/head/sdf.h"

namespace dermis::sculpt {
namespace {

/// The bust's cut: an elliptic wall that opens upwards and narrows towards a flat base.
float bustCut(const glm::vec3& p) {
  const float wall = (glm::length(glm::vec2(p.x / 120.0F, (p.z + 32.0F) / 92.0F)) - 1.0F) * 92.0F -
                     1.3F * smoothMax(0.0F, p.y + 170.0F, 30.0F) + 0.42F * smoothMax(0.0F, -172.0F - p.y, 40.0F);
  return smoothMax(wall, -(p.y + 222.0F), 18.0F);
}

/// Where the crease of the wing meets the cheek: the one stroke that is drawn in space.
Stroke alarGroove() {
  return Stroke({{{11, -32, 104.5F}, 5.0F, -0.05F},
                 {{14.5F, -32.2F, 99.5F}, 5.5F, -0.35F},
                 {{17.4F, -35.5F, 95.5F}, 5.0F, -1.1F},
                 {{18.2F, -41, 93.5F}, 4.5F, -1.7F},
                 {{17.0F, -46, 94.5F}, 4.0F, -0.9F}});
}

}  // namespace

Sculpt::Sculpt() {
  m_broad = dropped(broadStrokes());
  m_formed = true;
  m_fine = dropped(fineStrokes());
  m_fine.push_back(alarGroove());
}

float Sculpt::form(const glm::vec3& p) const {
  float d = m_base(p);
  if (!m_formed) return d;
  const glm::vec3 q = mirrored(p, 1.5F);
  d -= raisedBy(m_broad, q);
  d = m_lids.swell(d, q);
  return m_nose.join(d, p);
}

float Sculpt::operator()(const glm::vec3& p) const {
  constexpr float kNear = 45.0F, kLipsReach = 14.0F;
  float d = form(p);
  if (std::abs(d) < kNear) {
    const glm::vec3 q = mirrored(p, 1.0F);
    d -= raisedBy(m_fine, q);
    if (std::abs(d) < kLipsReach) d -= m_lips.raise(p);
    d = m_ear.join(d, {std::abs(p.x), p.y, p.z});
    d = m_nose.cutNostrils(d, q);
    d = m_lids.cut(d, q);
  }
  return smoothMax(d, bustCut(p), 40.0F);
}

Sculpt::Slope Sculpt::slope(const glm::vec3& p, float delta) const {
  // The corners of a tetrahedron: four values in place of six.
  const auto at = [&](float x, float y, float z) { return (*this)(p + delta * glm::vec3(x, y, z)); };
  const float a = at(1, -1, -1), b = at(-1, -1, 1), c = at(-1, 1, -1), d = at(1, 1, 1);
  return {glm::vec3(a - b - c + d, -a - b + c + d, -a + b - c + d) / (4.0F * delta), 0.25F * (a + b + c + d)};
}

glm::vec3 Sculpt::Slope::onSkin(const glm::vec3& p, float most) const {
  constexpr float kLeastSlope = 0.15F;  // where strokes have flattened the field
  const glm::vec3 step = gradient * (distance / std::max(glm::dot(gradient, gradient), kLeastSlope));
  const float length = glm::length(step);
  return p - (length > most ? step * (most / length) : step);
}

glm::vec3 Sculpt::dropFrom(DrawnFrom from, float across, float y) const {
  constexpr float kClose = 0.02F, kFrom = 135.0F, kTo = -100.0F;
  float depth = kFrom;
  const auto place = [&] {
    return from == DrawnFrom::Front ? glm::vec3(across, y, depth) : glm::vec3(depth, y, across);
  };
  for (float d = form(place()); d > kClose && depth > kTo; d = form(place())) depth -= std::max(0.6F * d, kClose);
  return place();
}

std::vector<Stroke> Sculpt::dropped(const std::vector<DrawnStroke>& drawn) const {
  std::vector<Stroke> strokes;
  for (const DrawnStroke& stroke : drawn) {
    std::vector<StrokePoint> points;
    for (const DrawnPoint& p : stroke.points)
      points.push_back({dropFrom(stroke.from, p.across, p.y), p.radius, p.amount});
    strokes.emplace_back(points);
  }
  return strokes;
}

}  // namespace dermis::sculpt
