// Large maps come in slices beside the frames, and look the same as those that a frame uploads.
#include <cmath>

#include "core/scene/primitives.h"
#include "gpu/frame_support.h"
#include "passes/texture_pixels.h"

namespace dermis::test {
namespace {

/// A checker of two greys, `side` texels wide, in squares of `square`.
std::shared_ptr<const Image> checker(int side, int square) {
  auto image = std::make_shared<Image>();
  image->width = image->height = side;
  image->channels = 3;
  image->pixels.resize(image->rowBytes() * static_cast<std::size_t>(side));
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x)
      for (int c = 0; c < 3; ++c)
        image->pixels[(static_cast<std::size_t>(y) * static_cast<std::size_t>(side) + static_cast<std::size_t>(x)) * 3 +
                      static_cast<std::size_t>(c)] =
            static_cast<std::byte>((x / square + y / square) % 2 == 0 ? 230 : 60);
  image->name = "checker";
  return image;
}

class TextureJobs : public FrameTest {
 protected:
  static ResolvedScene plane() { return sceneOf(makePlane(), emissive(glm::vec3(1.0F)), glm::vec3(0.0F)); }
};

TEST_F(TextureJobs, AFrameWaitsForNoLargeMap) {
  makeRenderer();
  ResolvedScene scene = plane();
  setMap(scene, TextureSlot::Emissive, checker(16, 4));
  show(scene);
  ASSERT_TRUE(m_renderer->renderFrame(request(scene)));
  const auto before = m_renderer->statistics().texturesUploaded;
  const Image small = m_renderer->readAov(Aov::Beauty);

  setMap(scene, TextureSlot::Emissive, checker(1024, 256));
  m_renderer->setScene(std::make_shared<const ResolvedScene>(scene));
  ASSERT_TRUE(m_renderer->renderFrame(request(scene)));
  EXPECT_EQ(m_renderer->statistics().texturesUploaded, before) << "a frame uploaded a map of 3 MiB";
  // The map before it stands in.
  EXPECT_EQ(largestDifference(m_renderer->readAov(Aov::Beauty), small), 0.0F);

  int slices = 0;
  while (m_renderer->runJobs(0.0)) ++slices;
  EXPECT_GE(slices, 2);
  ASSERT_TRUE(m_renderer->renderFrame(request(scene)));
  EXPECT_EQ(m_renderer->statistics().texturesUploaded, before + 1);
  const Image large = m_renderer->readAov(Aov::Beauty);
  // The same four by four squares.
  for (const int x : {6, 18, 30, 42})
    for (const int y : {6, 18, 30, 42})
      EXPECT_THAT(pixel(large, x, y), IsColour(glm::vec3(pixel(small, x, y)), 0.002F)) << x << ' ' << y;
}

TEST_F(TextureJobs, CancellingTheJobsLeavesTheMapToTheNextFrame) {
  makeRenderer();
  ResolvedScene scene = plane();
  show(scene);
  setMap(scene, TextureSlot::Emissive, checker(1024, 256));
  m_renderer->setScene(std::make_shared<const ResolvedScene>(scene));
  m_renderer->cancelJobs();
  ASSERT_TRUE(m_renderer->renderFrame(request(scene)));
  EXPECT_NEAR(pixel(m_renderer->readAov(Aov::Beauty), 6, 6).r, std::pow((230.0F / 255.0F + 0.055F) / 1.055F, 2.4F),
              0.01F);
}

TEST(Mips, AreMeansOfLinearLight) {
  const auto image = imageOf(2, 2, 3, PixelType::U8, {1, 1, 1, /**/ 0, 0, 0, /**/ 0, 0, 0, /**/ 1, 1, 1});
  const Image srgb = halved(*image, true);
  ASSERT_EQ(srgb.width, 1);
  // Half the light is code 188.
  EXPECT_NEAR(std::to_integer<int>(srgb.pixels[0]), 188, 1);
  EXPECT_NEAR(std::to_integer<int>(halved(*image, false).pixels[0]), 128, 1);
  const Image strip = halved(*imageOf(5, 1, 1, PixelType::Float, {1, 3, 5, 7, 100}), false);
  ASSERT_EQ(strip.width, 2);
  EXPECT_EQ(strip.height, 1);
  EXPECT_FLOAT_EQ(pixel(strip, 0, 0).r, 2.0F);
  EXPECT_FLOAT_EQ(pixel(strip, 1, 0).r, 6.0F);
}

}  // namespace
}  // namespace dermis::test
