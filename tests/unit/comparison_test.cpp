// Differences of images, and FLIP against values that follow from its definition.
#include "core/image/comparison.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

namespace dermis {
namespace {

Image uniform(int width, int height, std::vector<std::uint8_t> pixel) {
  Image image{width, height, static_cast<int>(pixel.size()), PixelType::U8, {}, "test"};
  for (int i = 0; i < width * height; ++i)
    for (const std::uint8_t v : pixel) image.pixels.push_back(static_cast<std::byte>(v));
  return image;
}

Image floats(const std::vector<float>& values) {
  Image image{static_cast<int>(values.size()), 1, 1, PixelType::Float, {}, "floats"};
  image.pixels.resize(values.size() * sizeof(float));
  std::memcpy(image.pixels.data(), values.data(), image.pixels.size());
  return image;
}

double flipOf(std::vector<std::uint8_t> a, std::vector<std::uint8_t> b) {
  const auto result = compareImages(uniform(48, 32, std::move(a)), uniform(48, 32, std::move(b)), 0.0);
  EXPECT_TRUE(result);
  return result ? result->flip : -1.0;
}

TEST(Comparison, FlipOfUniformColours) {
  EXPECT_EQ(flipOf({90, 40, 200}, {90, 40, 200}), 0.0);
  // Green against blue spans the scale: its end is defined by them (section 4.1.3 of the paper).
  EXPECT_NEAR(flipOf({0, 255, 0}, {0, 0, 255}), 1.0, 1e-4);
  // Black against white: HyAB = 100, so 0.95 + 0.05 (100^0.7 − 0.4 c) / (0.6 c) with c = 203.2^0.7.
  const double c = std::pow(203.2, 0.7);
  EXPECT_NEAR(flipOf({0, 0, 0}, {255, 255, 255}), 0.95 + 0.05 * (std::pow(100.0, 0.7) - 0.4 * c) / (0.6 * c), 1e-3);
}

TEST(Comparison, FlipSeesAnEdgeThatMoved) {
  Image a = uniform(64, 32, {200, 200, 200});
  Image b = a;
  const auto paint = [](Image& image, int from) {
    for (int y = 0; y < image.height; ++y)
      for (int x = from; x < image.width; ++x)
        for (int k = 0; k < 3; ++k)
          image.pixels[static_cast<std::size_t>((y * image.width + x) * 3 + k)] = std::byte{30};
  };
  paint(a, 32);
  paint(b, 36);
  const auto result = compareImages(a, b, 0.0);
  ASSERT_TRUE(result);
  const auto at = [&](int x) { return result->flipMap[static_cast<std::size_t>(16 * 64 + x)]; };
  EXPECT_GT(at(34), 0.4F);
  EXPECT_LT(at(4), 0.01F);
  EXPECT_LT(at(60), 0.01F);
}

TEST(Comparison, CountsMeanMaximumAndFailingShare) {
  const auto result = compareImages(floats({0.0F, 1.0F, 2.0F, 3.0F}), floats({0.0F, 1.5F, 2.0F, 3.01F}), 0.1);
  ASSERT_TRUE(result);
  EXPECT_NEAR(result->mean, 0.51 / 4.0, 1e-6);
  EXPECT_NEAR(result->maximum, 0.5, 1e-6);
  EXPECT_DOUBLE_EQ(result->failing, 0.25);
}

TEST(Comparison, ANumberAgainstNoneIsInfinitelyFar) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const auto alike = compareImages(floats({nan, 1.0F}), floats({nan, 1.0F}), 0.0);
  const auto apart = compareImages(floats({nan, 1.0F}), floats({0.0F, 1.0F}), 0.0);
  ASSERT_TRUE(alike && apart);
  EXPECT_EQ(alike->maximum, 0.0);
  EXPECT_TRUE(std::isinf(apart->maximum));
}

TEST(Comparison, SizesMustAgreeAndAlphaMayBeMissing) {
  EXPECT_FALSE(compareImages(uniform(2, 2, {1, 2, 3}), uniform(2, 3, {1, 2, 3}), 0.0));
  const auto opaque = compareImages(uniform(4, 4, {1, 2, 3}), uniform(4, 4, {1, 2, 3, 255}), 0.0);
  ASSERT_TRUE(opaque);
  EXPECT_EQ(opaque->maximum, 0.0);
}

}  // namespace
}  // namespace dermis
