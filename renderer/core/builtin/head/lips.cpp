#include "core/builtin/head/lips.h"

#include "core/builtin/head/sdf.h"

namespace dermis::sculpt {

Lips::Lips()
    : m_line({{0, -68.9F},
              {3.8F, -68.5F},
              {8.5F, -67.6F},
              {15.2F, -68.0F},
              {20.9F, -68.3F},
              {24.7F, -68.8F},
              {32.3F, -69.6F}}),
      m_upper({{0, -62.3F},
               {1.9F, -61.7F},
               {5.2F, -60.6F},
               {8.5F, -61.2F},
               {15.2F, -64.0F},
               {20.9F, -66.9F},
               {24.7F, -68.5F},
               {32.3F, -69.6F}}),
      m_lower({{0, -78.2F},
               {5.7F, -78.0F},
               {11.4F, -76.5F},
               {17.1F, -73.8F},
               {21.8F, -70.9F},
               {24.7F, -69.0F},
               {32.3F, -69.6F}}),
      m_upperAmount(
          {{0, 4.5F}, {4.8F, 4.9F}, {11.4F, 4.1F}, {17.1F, 2.5F}, {20.9F, 1.2F}, {25.2F, 0.1F}, {28.5F, 0}, {38, 0}}),
      m_lowerAmount(
          {{0, 4.1F}, {5.7F, 4.5F}, {11.4F, 4.0F}, {17.1F, 2.5F}, {21.4F, 1.1F}, {25.2F, 0.1F}, {28.5F, 0}, {38, 0}}),
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
  height += 0.35F * bell(p.y - (m_upper(x) + 0.5F), 1.3F) * fade(10.5F, 19.0F, x);  // the white roll
  height -= 2.3F * bell(over, 0.9F) * fade(17.0F, 27.5F, x);                        // the slit
  return height * ramp(60.0F, 80.0F, p.z);
}

}  // namespace dermis::sculpt
