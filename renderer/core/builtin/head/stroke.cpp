#include "core/builtin/head/stroke.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/builtin/head/sdf.h"

namespace dermis::sculpt {
namespace {

glm::vec3 catmullRom(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const glm::vec3& d, float t) {
  return 0.5F * (2.0F * b + (c - a) * t + (2.0F * a - 5.0F * b + 4.0F * c - d) * t * t +
                 (3.0F * b - a - 3.0F * c + d) * t * t * t);
}

float nearestOn(const glm::vec3& p, const glm::vec3& a, const glm::vec3& b) {
  const glm::vec3 along = b - a;
  return glm::clamp(glm::dot(p - a, along) / glm::dot(along, along), 0.0F, 1.0F);
}

}  // namespace

Stroke::Stroke(const std::vector<StrokePoint>& points, int piecesPerSpan) {
  if (points.size() == 1) m_points = points;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const StrokePoint& before = points[i == 0 ? 0 : i - 1];
    const StrokePoint& a = points[i];
    const StrokePoint& b = points[i + 1];
    const StrokePoint& after = points[std::min(i + 2, points.size() - 1)];
    const int pieces = piecesPerSpan + (i + 2 == points.size() ? 1 : 0);
    for (int k = 0; k < pieces; ++k) {
      const float t = static_cast<float>(k) / static_cast<float>(piecesPerSpan), eased = ramp(0.0F, 1.0F, t);
      m_points.push_back({catmullRom(before.place, a.place, b.place, after.place, t),
                          glm::mix(a.radius, b.radius, eased), glm::mix(a.amount, b.amount, eased)});
    }
  }
  glm::vec3 low(std::numeric_limits<float>::max()), high(std::numeric_limits<float>::lowest());
  for (const StrokePoint& point : m_points) {
    low = glm::min(low, point.place);
    high = glm::max(high, point.place);
  }
  m_centre = 0.5F * (low + high);
  for (const StrokePoint& point : m_points)
    m_reach = std::max(m_reach, glm::distance(point.place, m_centre) + point.radius);
}

float Stroke::raise(const glm::vec3& p) const {
  const glm::vec3 off = p - m_centre;
  if (glm::dot(off, off) > m_reach * m_reach) return 0.0F;
  float strongest = 0.0F;
  const auto dab = [&](const glm::vec3& place, float radius, float amount) {
    const glm::vec3 d = p - place;
    const float t = glm::dot(d, d) / (radius * radius);
    if (t >= 1.0F) return;
    const float value = squared(1.0F - t) * amount;
    if (std::abs(value) > std::abs(strongest)) strongest = value;
  };
  if (m_points.size() == 1) dab(m_points[0].place, m_points[0].radius, m_points[0].amount);
  for (std::size_t i = 0; i + 1 < m_points.size(); ++i) {
    const StrokePoint& a = m_points[i];
    const StrokePoint& b = m_points[i + 1];
    const float h = nearestOn(p, a.place, b.place);
    dab(glm::mix(a.place, b.place, h), glm::mix(a.radius, b.radius, h), glm::mix(a.amount, b.amount, h));
  }
  return strongest;
}

float Stroke::tube(const glm::vec3& p) const {
  constexpr float kFar = 12.0F;
  const float away = glm::distance(p, m_centre) - m_reach;
  if (away > kFar) return away;
  float nearest = std::numeric_limits<float>::max();
  for (std::size_t i = 0; i + 1 < m_points.size(); ++i) {
    const StrokePoint& a = m_points[i];
    const StrokePoint& b = m_points[i + 1];
    const float h = nearestOn(p, a.place, b.place);
    nearest = std::min(nearest, glm::distance(p, glm::mix(a.place, b.place, h)) - glm::mix(a.radius, b.radius, h));
  }
  return nearest;
}

float raisedBy(const std::vector<Stroke>& strokes, const glm::vec3& p) {
  float sum = 0.0F;
  for (const Stroke& stroke : strokes) sum += stroke.raise(p);
  return sum;
}

}  // namespace dermis::sculpt
