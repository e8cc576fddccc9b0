// What reaches the display and files: encoding, alpha, dither.
#include <cmath>
#include <cstring>
#include <set>

#include "core/scene/primitives.h"
#include "gpu/frame_support.h"

namespace dermis::test {
namespace {

class FrameDisplay : public FrameTest {
 protected:
  /// The value of the picture's middle in a file, 0..1.
  glm::vec4 inFile(const std::string& view, PixelType type, float stops = 0.0F) {
    ViewSettings settings;
    settings.transform = view;
    settings.exposureStops = stops;
    const Image image = m_renderer->readDisplay(settings, type);
    EXPECT_EQ(image.channels, 4);
    EXPECT_EQ(image.type, type);
    glm::vec4 value(0.0F);
    const std::size_t index = (static_cast<std::size_t>(image.height / 2) * static_cast<std::size_t>(image.width) +
                               static_cast<std::size_t>(image.width / 2)) *
                              4;
    for (std::size_t c = 0; c < 4; ++c) {
      std::uint16_t wide = 0;
      if (type == PixelType::U16) std::memcpy(&wide, &image.pixels[2 * (index + c)], 2);
      value[static_cast<int>(c)] = type == PixelType::U16 ? static_cast<float>(wide) / 65535.0F
                                                          : static_cast<float>(image.pixels[index + c]) / 255.0F;
    }
    return value;
  }
};

TEST_F(FrameDisplay, RawWritesValuesAsTheyAre) {
  still(sceneOf(makePlane(), emissive({0.2F, 0.4F, 2.0F}), glm::vec3(0.0F)));
  EXPECT_THAT(inFile("Raw", PixelType::U16, 3.0F), IsColour(glm::vec3(0.2F, 0.4F, 1.0F), 2e-4F));
  EXPECT_THAT(inFile("Raw", PixelType::U8), IsColour(glm::vec3(51.0F / 255.0F, 102.0F / 255.0F, 1.0F), 1e-6F));
}

TEST_F(FrameDisplay, TheSeedsCurves) {
  still(sceneOf(makePlane(), emissive({0.2F, 0.5F, 3.0F}), glm::vec3(0.0F)));
  const auto thesis = [](float c) { return std::pow(c / (c + 1.0F), 1.0F / 2.2F); };
  EXPECT_THAT(inFile("Thesis", PixelType::U16), IsColour(glm::vec3(thesis(0.2F), thesis(0.5F), thesis(3.0F)), 1e-3F));
  EXPECT_THAT(inFile("Thesis", PixelType::U16, 1.0F),
              IsColour(glm::vec3(thesis(0.4F), thesis(1.0F), thesis(6.0F)), 1e-3F));
  const auto gamma = [](float c) { return std::min(std::pow(c, 1.0F / 2.2F), 1.0F); };
  EXPECT_THAT(inFile("Gamma 2.2", PixelType::U16), IsColour(glm::vec3(gamma(0.2F), gamma(0.5F), 1.0F), 1e-3F));
}

TEST_F(FrameDisplay, FilesHaveUnassociatedAlpha) {
  Material glass = emissive(glm::vec3(0.5F));
  glass.parameters.metallicRoughnessAlphaMode = AlphaMode::Blend;
  glass.parameters.metallicRoughnessOpacity = 0.25F;
  const Image beauty = still(sceneOf(makePlane(), glass, glm::vec3(0.0F)));
  EXPECT_NEAR(pixel(beauty, 24, 24).r, 0.125F, 1e-3F);
  EXPECT_NEAR(pixel(beauty, 24, 24).a, 0.25F, 1e-3F);
  const glm::vec4 file = inFile("Raw", PixelType::U16);
  EXPECT_NEAR(file.r, 0.5F, 1e-3F);
  EXPECT_NEAR(file.a, 0.25F, 1e-3F);
}

TEST_F(FrameDisplay, OnlyTheWindowIsDithered) {
  const ResolvedScene scene = sceneOf(makePlane(), emissive(glm::vec3(0.2F)), glm::vec3(0.0F));
  still(scene);
  const Window window(m_size);
  FrameRequest frame = request(scene);
  frame.framebuffer = window.framebuffer.id();
  const auto codes = [&](const std::string& view) {
    frame.view.transform = view;
    m_renderer->renderFrame(frame);
    std::set<int> found;
    const auto values = window.read();
    for (std::size_t i = 0; i < values.size(); i += 4) found.insert(values[i]);
    return found;
  };
  // 255 · thesis(0.2) = 113.5…: two neighbouring codes share the plane.
  const std::set<int> dithered = codes("Thesis");
  EXPECT_EQ(dithered.size(), 2U);
  EXPECT_EQ(*dithered.rbegin() - *dithered.begin(), 1);
  EXPECT_EQ(codes("Raw"), (std::set<int>{51}));
  const Image file = m_renderer->readDisplay({.transform = "Thesis"}, PixelType::U8);
  std::set<int> inFile;
  for (std::size_t i = 0; i < file.pixels.size(); i += 4) inFile.insert(std::to_integer<int>(file.pixels[i]));
  EXPECT_EQ(inFile.size(), 1U);
}

TEST_F(FrameDisplay, TheBakedViewIsCloseToTheExactOne) {
  const ResolvedScene scene = sceneOf(makePlane(), emissive({0.4F, 0.15F, 0.05F}), glm::vec3(0.0F));
  still(scene);
  const glm::vec4 exact = inFile("ACES", PixelType::U16);
  const Window window(m_size);
  FrameRequest frame = request(scene);
  frame.framebuffer = window.framebuffer.id();
  frame.exactDisplay = false;
  frame.view.transform = "ACES";
  m_renderer->renderFrame(frame);
  const auto values = window.read();
  const std::size_t middle = std::size_t{4} * (24 * 48 + 24);
  for (int c = 0; c < 3; ++c)
    EXPECT_NEAR(values[middle + static_cast<std::size_t>(c)] / 255.0F, exact[c], 1.6F / 255.0F) << c;
}

TEST_F(FrameDisplay, AnUnknownViewIsSaidAndShownAnyway) {
  const ResolvedScene scene = sceneOf(makePlane(), emissive(glm::vec3(0.2F)), glm::vec3(0.0F));
  still(scene);
  EXPECT_GT(inFile("No Such View", PixelType::U8).r, 0.1F);
  EXPECT_FALSE(m_renderer->takeMessages().empty());
}

}  // namespace
}  // namespace dermis::test
