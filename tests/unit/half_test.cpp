// halfOf(): against the nearest of all halves, searched.
#include "core/base/half.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/packing.hpp>
#include <random>
#include <vector>

namespace dermis {
namespace {

TEST(Half, EveryHalfIsItself) {
  for (std::uint32_t bits = 0; bits < 0x10000U; ++bits) {
    const auto half = static_cast<std::uint16_t>(bits);
    const float value = glm::unpackHalf1x16(half);
    if (std::isnan(value)) continue;
    ASSERT_EQ(halfOf(value), half) << value;
  }
}

TEST(Half, AValueBetweenTwoTakesTheNearer) {
  std::vector<double> halves;
  for (std::uint32_t bits = 0; bits < 0x7C00U; ++bits)
    halves.push_back(static_cast<double>(glm::unpackHalf1x16(static_cast<std::uint16_t>(bits))));
  std::mt19937 random(7);
  const auto check = [&](float value) {
    const auto next = std::ranges::upper_bound(halves, static_cast<double>(std::abs(value)));
    const auto above = static_cast<std::uint32_t>(next - halves.begin());
    const double low = static_cast<double>(std::abs(value)) - halves[above - 1];
    const double high = above < halves.size() ? halves[above] - static_cast<double>(std::abs(value)) : 1e9;
    const std::uint32_t nearest = low < high ? above - 1 : high < low ? above : above & ~1U;
    ASSERT_EQ(halfOf(value), nearest | (std::signbit(value) ? 0x8000U : 0U)) << value;
  };
  for (int i = 0; i < 100'000; ++i) {
    const float exponent = std::uniform_real_distribution<float>(-27.0F, 15.9F)(random);
    check((i % 2 == 0 ? 1.0F : -1.0F) * std::exp2(exponent));
  }
  // Halfway between two, to the even one.
  for (std::size_t i = 0; i + 1 < halves.size(); i += 7) check(static_cast<float>(0.5 * (halves[i] + halves[i + 1])));
}

TEST(Half, WhatIsTooLargeIsInfinite) {
  EXPECT_EQ(halfOf(65504.0F), 0x7BFF);
  EXPECT_EQ(halfOf(65519.0F), 0x7BFF);
  EXPECT_EQ(halfOf(65520.0F), 0x7C00);
  EXPECT_EQ(halfOf(-1e30F), 0xFC00);
}

}  // namespace
}  // namespace dermis
