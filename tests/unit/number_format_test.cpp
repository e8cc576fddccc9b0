#include "core/base/number_format.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <random>

namespace dermis {
namespace {

TEST(NumberFormat, WritesTheShortestDecimal) {
  EXPECT_EQ(shortestDecimal(0.45F), "0.45");
  EXPECT_EQ(shortestDecimal(1.0F), "1");
  EXPECT_EQ(shortestDecimal(-20.0F), "-20");
  EXPECT_EQ(shortestDecimal(0.1F), "0.1");
  EXPECT_EQ(shortestDecimal(0.1), "0.1");
  EXPECT_EQ(shortestDecimal(3.4028235e38F), "3.4028235e+38");
}

TEST(NumberFormat, KeepsTheSignOfZeroThroughJson) { EXPECT_EQ(shortestDecimal(-0.0F), "-0.0"); }

TEST(NumberFormat, EveryFloatReadsBackAsItself) {
  std::mt19937 random(1);
  for (int i = 0; i < 300000; ++i) {
    const auto value = std::bit_cast<float>(static_cast<std::uint32_t>(random()));
    if (!std::isfinite(value)) continue;
    const auto back = parseFloat(shortestDecimal(value));
    ASSERT_TRUE(back.has_value()) << shortestDecimal(value);
    ASSERT_EQ(std::bit_cast<std::uint32_t>(*back), std::bit_cast<std::uint32_t>(value));
    ASSERT_EQ(static_cast<float>(widened(value)), value);
  }
}

TEST(NumberFormat, WidenedPrintsLikeTheFloat) {
  for (const float value : {0.45F, 0.1F, 1.376F, 1e-7F, 7.41F, 123456.79F})
    EXPECT_EQ(shortestDecimal(widened(value)), shortestDecimal(value));
}

TEST(NumberFormat, ParsesOnlyWholeFiniteNumbers) {
  EXPECT_EQ(parseFloat(" 0.5 "), 0.5F);
  EXPECT_EQ(parseFloat("1e-60"), 0.0F);
  EXPECT_EQ(parseFloat("-2"), -2.0F);
  for (const char* text : {"", " ", "x", "0.5x", "0,5", "nan", "inf", "-inf", "1e60", "1e999", "0x10", "1 2", "--1"})
    EXPECT_FALSE(parseFloat(text).has_value()) << text;
}

TEST(NumberFormat, ParsesCommaLists) {
  EXPECT_THAT(parseFloatList("0.9, 0.5,0.2").value(), testing::ElementsAre(0.9F, 0.5F, 0.2F));
  EXPECT_THAT(parseFloatList("1").value(), testing::ElementsAre(1.0F));
  for (const char* text : {"", ",", "1,", ",1", "1,,2", "1;2"}) EXPECT_FALSE(parseFloatList(text).has_value()) << text;
}

}  // namespace
}  // namespace dermis
