#include "core/builtin/head/profile.h"

namespace dermis::sculpt {

Profile::Profile(std::initializer_list<glm::vec2> points) {
  for (const glm::vec2& p : points) m_knots.push_back({p.x, p.y, 0.0F});
  const std::size_t last = m_knots.size() - 1;
  const auto secant = [&](std::size_t i) {
    return (m_knots[i + 1].y - m_knots[i].y) / (m_knots[i + 1].x - m_knots[i].x);
  };
  m_knots[0].slope = secant(0);
  m_knots[last].slope = secant(last - 1);
  for (std::size_t i = 1; i < last; ++i) {
    const float before = secant(i - 1), after = secant(i);
    m_knots[i].slope = before * after <= 0.0F ? 0.0F : 2.0F * before * after / (before + after);
  }
}

float Profile::operator()(float x) const {
  if (x <= m_knots.front().x) return m_knots.front().y;
  if (x >= m_knots.back().x) return m_knots.back().y;
  std::size_t i = 0;
  while (x > m_knots[i + 1].x) ++i;
  const Knot& a = m_knots[i];
  const Knot& b = m_knots[i + 1];
  const float width = b.x - a.x, t = (x - a.x) / width, t2 = t * t, t3 = t2 * t;
  return (2.0F * t3 - 3.0F * t2 + 1.0F) * a.y + (t3 - 2.0F * t2 + t) * width * a.slope + (3.0F * t2 - 2.0F * t3) * b.y +
         (t3 - t2) * width * b.slope;
}

}  // namespace dermis::sculpt
