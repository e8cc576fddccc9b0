#include "core/builtin/head/lips.h"

#include "core/builtin/head/sdf.h"

namespace dermis::sculpt {

Lips::Lips()
    : m_line({{0, -68.9F}, {4, -68.5F}, {9, -67.6F}, {16, -68.0F}, {22, -68.3F}, {26, -68.8F}, {34, -69.6F}}),
      m_upper({{0, -62.3F},
               {2, -61.7F},
               {5.5F, -60.6F},
               {9, -61.2F},
               {16, -64.0F},
               {22, -66.9F},
               {26, -68.5F},
               {34, -69.6F}}),
      m_lower({{0, -78.2F}, {6, -78.0F}, {12, -76.5F}, {18, -73.8F}, {23, -70.9F}, {26, -69.0F}, {34, -69.6F}}),
      m_upperAmount({{0, 4.5F}, {5, 4.9F}, {12, 4.1F}, {19, 2.6F}, {24, 1.2F}, {30, 0}, {40, 0}}),
      m_lowerAmount({{0, 4.1F}, {6, 4.5F}, {12, 4.0F}, {18, 2.7F}, {23, 1.3F}, {29.5F, 0}, {40, 0}}),
      // Only part of the height is there where the lips touch: the full height would make a beak.
      m_upperSection({{0, 0.42F},
                      {0.14F, 0.70F},
                      {0.36F, 0.96F},
                      {0.58F, 1.0F},
                      {0.82F, 0.78F},
                      {1.0F, 0.50F},
                      {1.2F, 0.32F},
                      {1.6F, 0.16F},
                      {2.3F, 0},
                      {4, 0}}),
      m_lowerSection({{0, 0.36F},
                      {0.12F, 0.62F},
                      {0.32F, 0.93F},
                      {0.52F, 1.0F},
                      {0.78F, 0.78F},
                      {1.0F, 0.38F},
                      {1.3F, 0.10F},
                      {1.7F, 0},
                      {4, 0}}) {}

float Lips::raise(const glm::vec3& p) const {
  if (p.z < 60.0F || p.y > -48.0F || p.y < -92.0F) return 0.0F;
  const float x = roundAbs(p.x, 0.7F);
  if (x > 36.0F) return 0.0F;
  const float line = m_line(x), over = p.y - line;
  // Heights of the lips, kept off zero in the corners.
  const float upper = std::sqrt(squared(m_upper(x) - line) + 2.4F);
  const float lower = std::sqrt(squared(line - m_lower(x)) + 2.4F);
  const float isUpper = ramp(-0.35F, 0.35F, over);
  float height = isUpper * m_upperAmount(x) * m_upperSection(std::max(over / upper, 0.0F)) +
                 (1.0F - isUpper) * m_lowerAmount(x) * m_lowerSection(std::max(-over / lower, 0.0F));
  height += 0.35F * bell(p.y - (m_upper(x) + 0.5F), 1.3F) * fade(14.0F, 23.0F, x);  // the white roll
  height -= 2.3F * bell(over, 0.9F) * fade(16.0F, 26.5F, x);                        // the slit
  return height * ramp(60.0F, 80.0F, p.z);
}

}  // namespace dermis::sculpt
