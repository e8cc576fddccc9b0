// Between linear Rec.709 and what a screen shows of it.
#pragma once

#include <QColor>
#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

namespace dermis {

/// The sRGB transfer function, IEC 61966-2-1, of one linear value.
[[nodiscard]] inline float encodeSrgb(float linear) {
  return linear <= 0.0031308F ? 12.92F * linear : 1.055F * std::pow(linear, 1.0F / 2.4F) - 0.055F;
}
[[nodiscard]] inline float decodeSrgb(float encoded) {
  return encoded <= 0.04045F ? encoded / 12.92F : std::pow((encoded + 0.055F) / 1.055F, 2.4F);
}

/// How a linear colour looks on an sRGB screen, values above 1 cut off.
[[nodiscard]] inline QColor toScreen(const glm::vec3& linear) {
  const auto channel = [](float v) { return std::clamp(encodeSrgb(std::max(v, 0.0F)), 0.0F, 1.0F); };
  return QColor::fromRgbF(channel(linear.r), channel(linear.g), channel(linear.b));
}
[[nodiscard]] inline glm::vec3 fromScreen(const QColor& colour) {
  return {decodeSrgb(colour.redF()), decodeSrgb(colour.greenF()), decodeSrgb(colour.blueF())};
}

}  // namespace dermis
