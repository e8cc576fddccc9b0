// The views that a few arithmetic instructions do exactly: Raw, sRGB, and the two seeds' curves. Private to
// renderer/colour.
#pragma once

#include <array>
#include <cmath>
#include <string_view>

namespace dermis {

/// A curve applied to each channel, on the CPU and as the GLSL text of `float curve(float c)`.
struct SimpleCurve {
  std::string_view name;
  float (*apply)(float);
  std::string_view glsl;
};

/// IEC 61966-2-1, amendment 1: the sRGB encoding, its linear part carried on below zero and its power above one.
inline float encodeSrgb(float c) { return c <= 0.0031308F ? 12.92F * c : 1.055F * std::pow(c, 1.0F / 2.4F) - 0.055F; }

inline constexpr std::array<SimpleCurve, 4> kSimpleCurves = {{
    {"Raw", [](float c) { return c; }, "return c;"},
    {"sRGB", encodeSrgb, "return c <= 0.0031308 ? 12.92 * c : 1.055 * pow(c, 1.0 / 2.4) - 0.055;"},
    // "Physically Based Skin rendering Using OpenGL" (2024): Reinhard's curve, then the power.
    {"Thesis",
     [](float c) {
       const float positive = std::fmax(c, 0.0F);
       return std::pow(positive / (positive + 1.0F), 1.0F / 2.2F);
     },
     "float p = max(c, 0.0); return pow(p / (p + 1.0), 1.0 / 2.2);"},
    {"Gamma 2.2", [](float c) { return std::pow(std::fmax(c, 0.0F), 1.0F / 2.2F); },
     "return pow(max(c, 0.0), 1.0 / 2.2);"},
}};

}  // namespace dermis
