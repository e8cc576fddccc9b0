// toSharedExponent(): against the nearest of all that the format holds.
#include "lighting/shared_exponent.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

namespace dermis {
namespace {

/// EXT_texture_shared_exponent's own definition, in doubles.
std::array<double, 3> unpacked(std::uint32_t word) {
  const double step = std::exp2(static_cast<int>(word >> 27U) - 15 - 9);
  return {(word & 511U) * step, (word >> 9U & 511U) * step, (word >> 18U & 511U) * step};
}

std::uint32_t packed(float r, float g, float b) {
  std::uint32_t word = 0;
  toSharedExponent(std::array{r, g, b, 1.0F}, &word);
  return word;
}

TEST(SharedExponent, EachChannelIsWithinHalfAStepOfTheLargestsExponent) {
  std::mt19937 random(11);
  std::uniform_real_distribution<float> stops(-30.0F, 15.99F);
  std::uniform_real_distribution<float> ratio(0.0F, 1.0F);
  for (int i = 0; i < 300'000; ++i) {
    const float largest = std::exp2(stops(random));
    std::array<float, 3> value = {largest, largest * ratio(random), largest * std::exp2(-16.0F * ratio(random))};
    std::rotate(value.begin(), value.begin() + i % 3, value.end());
    // Half of 2⁻⁸ of the power of two below the largest channel; never finer than half of 2⁻²⁴.
    const double below = std::exp2(std::floor(std::log2(static_cast<double>(largest))));
    const double bound = std::max(below * 0x1p-9, 0x1p-25) * (1.0 + 1e-6);
    const auto back = unpacked(packed(value[0], value[1], value[2]));
    for (std::size_t c = 0; c < 3; ++c)
      ASSERT_NEAR(back[c], static_cast<double>(value[c]), 2.0 * bound)
          << value[0] << ' ' << value[1] << ' ' << value[2];
    // A largest channel that rounds up to the next power of two takes its exponent, and steps of twice the size.
    const bool carried =
        back[static_cast<std::size_t>(std::max_element(value.begin(), value.end()) - value.begin())] >= 2.0 * below;
    if (carried) continue;
    for (std::size_t c = 0; c < 3; ++c) ASSERT_NEAR(back[c], static_cast<double>(value[c]), bound);
  }
}

TEST(SharedExponent, WhatTheFormatHoldsIsKeptExactly) {
  for (std::uint32_t exponent = 0; exponent < 32; ++exponent) {
    for (std::uint32_t mantissa = 256; mantissa < 512; ++mantissa) {
      const std::uint32_t word = mantissa | (mantissa / 3) << 9U | (511U - mantissa) << 18U | exponent << 27U;
      const auto value = unpacked(word);
      ASSERT_EQ(packed(static_cast<float>(value[0]), static_cast<float>(value[1]), static_cast<float>(value[2])), word);
    }
  }
}

TEST(SharedExponent, RoundingIsUnbiased) {
  // The mean of many values keeps far below a step: what makes an environment's irradiance right.
  std::mt19937 random(3);
  std::uniform_real_distribution<float> value(1.0F, 2.0F);
  double sum = 0.0;
  double kept = 0.0;
  for (int i = 0; i < 200'000; ++i) {
    const float v = value(random);
    sum += static_cast<double>(v);
    kept += unpacked(packed(v, 0.0F, 0.0F))[0];
  }
  EXPECT_NEAR(kept / sum, 1.0, 2e-5);
}

TEST(SharedExponent, EndsAreKept) {
  EXPECT_EQ(packed(0.0F, 0.0F, 0.0F), 0U);
  EXPECT_EQ(unpacked(packed(kSharedExponentMax, 1.0F, 0.0F))[0], static_cast<double>(kSharedExponentMax));
  EXPECT_EQ(unpacked(packed(1e30F, 0.0F, 0.0F))[0], static_cast<double>(kSharedExponentMax));
  EXPECT_EQ(unpacked(packed(0x1p-24F, 0.0F, 0.0F))[0], 0x1p-24);
}

}  // namespace
}  // namespace dermis
