// Maps: pixel types, colour, orientation, channels, the driver's limit, the cache.
#include <cmath>

#include "core/scene/primitives.h"
#include "gpu/frame_support.h"
#include "passes/texture_pixels.h"
#include "passes/texture_upload.h"

namespace dermis::test {
namespace {

float linearFromSrgb(float c) { return c <= 0.04045F ? c / 12.92F : std::pow((c + 0.055F) / 1.055F, 2.4F); }

class FrameTextures : public FrameTest {
 protected:
  /// A plane that shows its emissive map.
  static ResolvedScene plane() { return sceneOf(makePlane(), emissive(glm::vec3(1.0F)), glm::vec3(0.0F)); }
  static TextureBinding inSpace(const char* space) {
    TextureBinding binding;
    binding.colorSpace = space;
    return binding;
  }
};

TEST_F(FrameTextures, FirstRowIsAboveAndFirstColumnLeft) {
  ResolvedScene scene = plane();
  setMap(scene, TextureSlot::Emissive,
         imageOf(2, 2, 3, PixelType::U8, {1, 0, 0, /**/ 0, 1, 0, /**/ 0, 0, 1, /**/ 1, 1, 1}));
  const Image image = still(scene);
  EXPECT_THAT(pixel(image, 12, 12), IsColour(glm::vec3(1, 0, 0), 0.06F));
  EXPECT_THAT(pixel(image, 36, 12), IsColour(glm::vec3(0, 1, 0), 0.06F));
  EXPECT_THAT(pixel(image, 12, 36), IsColour(glm::vec3(0, 0, 1), 0.06F));
  EXPECT_THAT(pixel(image, 36, 36), IsColour(glm::vec3(1, 1, 1), 0.06F));
}

TEST_F(FrameTextures, EveryPixelTypeInEveryHandling) {
  constexpr float kValue = 0.4F;
  for (const PixelType type : {PixelType::U8, PixelType::U16, PixelType::Half, PixelType::Float})
    for (const int channels : {1, 2, 3, 4})
      for (const char* space : {"", "srgb", "linear", "raw"}) {
        ResolvedScene scene = plane();
        std::vector<float> values(static_cast<std::size_t>(channels), kValue);
        if (channels == 2 || channels == 4) values.back() = 1.0F;
        TextureBinding binding;
        if (*space != '\0') binding.colorSpace = space;
        setMap(scene, TextureSlot::Emissive, imageOf(1, 1, channels, type, values), binding);
        // Colours are sRGB when 8-bit and linear when float unless the slot says otherwise.
        const std::string word = space;
        const bool decoded = word == "srgb" || (word.empty() && type == PixelType::U8);
        const bool either = word.empty() && type == PixelType::U16;  // 16-bit integers: either is a fair reading
        const glm::vec4 shown = pixel(still(scene), 24, 24);
        const std::string what = "type " + std::to_string(static_cast<int>(type)) + ", " + std::to_string(channels) +
                                 " channels, \"" + word + "\"";
        if (either && std::abs(shown.r - kValue) < 0.003F) continue;
        const float expected = decoded || either ? linearFromSrgb(kValue) : kValue;
        EXPECT_THAT(shown, IsColour(glm::vec3(expected), 0.003F)) << what;
      }
}

TEST_F(FrameTextures, ScalarsChooseChannelScaleAndInvert) {
  ResolvedScene scene = sceneOf(makePlane(), materialOf(ShadingModel::Skin));
  m_renderer->keepAovs({Aov::Occlusion});
  const auto image = imageOf(1, 1, 4, PixelType::U8, {0.2F, 0.4F, 0.6F, 0.8F});
  const auto occlusion = [&](TextureChannel channel, bool invert, float scale) {
    TextureBinding binding;
    binding.channel = channel;
    binding.invert = invert;
    binding.scale = scale;
    setMap(scene, TextureSlot::Occlusion, image, binding);
    still(scene);
    return pixel(m_renderer->readAov(Aov::Occlusion), 24, 24).r;
  };
  EXPECT_NEAR(occlusion(TextureChannel::R, false, 1.0F), 0.2F, 2e-3F);
  EXPECT_NEAR(occlusion(TextureChannel::G, false, 1.0F), 0.4F, 2e-3F);
  EXPECT_NEAR(occlusion(TextureChannel::B, false, 1.0F), 0.6F, 2e-3F);
  EXPECT_NEAR(occlusion(TextureChannel::A, false, 1.0F), 0.8F, 2e-3F);
  EXPECT_NEAR(occlusion(TextureChannel::A, true, 1.0F), 0.2F, 2e-3F);
  EXPECT_NEAR(occlusion(TextureChannel::B, true, 0.5F), 0.2F, 2e-3F);
  EXPECT_NEAR(occlusion(TextureChannel::Luminance, false, 1.0F), 0.2126F * 0.2F + 0.7152F * 0.4F + 0.0722F * 0.6F,
              2e-3F);
  EXPECT_EQ(m_renderer->statistics().texturesUploaded, 6U) << "each channel in turn; inverting sends nothing";
}

TEST_F(FrameTextures, ScalarsOfEveryPixelTypeInEveryHandling) {
  m_renderer->keepAovs({Aov::Occlusion});
  const std::vector<float> values = {0.2F, 0.4F, 0.6F, 0.8F};
  for (const PixelType type : {PixelType::U8, PixelType::U16, PixelType::Half, PixelType::Float})
    for (const char* space : {"", "srgb"})
      for (const TextureChannel channel :
           {TextureChannel::R, TextureChannel::G, TextureChannel::B, TextureChannel::A}) {
        ResolvedScene scene = sceneOf(makePlane(), materialOf(ShadingModel::Skin));
        TextureBinding binding;
        if (*space != '\0') binding.colorSpace = space;
        binding.channel = channel;
        setMap(scene, TextureSlot::Occlusion, imageOf(1, 1, 4, type, values), binding);
        still(scene);
        const float value = values[static_cast<std::size_t>(channel)];
        const bool decoded = *space != '\0' && channel != TextureChannel::A;
        EXPECT_NEAR(pixel(m_renderer->readAov(Aov::Occlusion), 24, 24).r, decoded ? linearFromSrgb(value) : value,
                    3e-3F)
            << "type " << static_cast<int>(type) << ", \"" << space << "\", channel " << toString(channel);
      }
}

TEST(FrameTextureLevels, OneChannelAloneIsKeptOfAPackedMap) {
  const auto image = imageOf(2, 1, 4, PixelType::U8, {0.2F, 0.4F, 0.6F, 0.8F, 0.4F, 0.6F, 0.8F, 1.0F});
  TextureRecipe recipe;
  recipe.maximumSize = 16;
  recipe.channel = 2;
  const PreparedTexture prepared = prepareTexture(image, recipe);
  ASSERT_EQ(prepared.layers.size(), 1U);
  ASSERT_EQ(prepared.layers[0].size(), 2U) << "two mips";
  EXPECT_EQ(prepared.layers[0][0]->pixels, (std::vector<std::byte>{std::byte{153}, std::byte{204}}));
  ASSERT_EQ(prepared.layers[0][1]->pixels.size(), 1U);
  EXPECT_NEAR(std::to_integer<int>(prepared.layers[0][1]->pixels[0]), 178, 1);
}

TEST_F(FrameTextures, ThesisDecodesItsAlbedoItself) {
  ResolvedScene scene = sceneOf(makePlane(), materialOf(ShadingModel::Thesis));
  scene.slots[0].material.parameters.baseAlbedo.rgb = glm::vec3(1.0F);
  setMap(scene, TextureSlot::Albedo, imageOf(1, 1, 3, PixelType::U8, {0.4F, 0.4F, 0.4F}));
  const glm::vec4 eight = pixel(still(scene), 24, 24);
  const auto uploaded = m_renderer->statistics().texturesUploaded;
  setMap(scene, TextureSlot::Albedo, imageOf(1, 1, 3, PixelType::Float, {0.4F, 0.4F, 0.4F}));
  EXPECT_THAT(pixel(still(scene), 24, 24), IsColour(eight, 0.004F)) << "the raw value, whatever the file's type";
  EXPECT_EQ(m_renderer->statistics().texturesUploaded, uploaded + 1);
}

TEST_F(FrameTextures, TooLargeOnesAreReducedWithAMessage) {
  RendererOptions options;
  options.maximumTextureSize = 16;
  makeRenderer(options);
  ResolvedScene scene = plane();
  std::vector<float> checks;
  for (int y = 0; y < 20; ++y)
    for (int x = 0; x < 40; ++x) checks.push_back((x + y) % 2 == 0 ? 1.0F : 0.0F);
  setMap(scene, TextureSlot::Emissive, imageOf(40, 20, 1, PixelType::U8, checks));
  show(scene);
  EXPECT_TRUE(m_renderer->renderFrame(request(scene)));
  const Warnings messages = m_renderer->takeMessages();
  ASSERT_EQ(messages.size(), 1U);
  EXPECT_THAT(messages[0], ::testing::HasSubstr("test.png: 40 × 20"));
  EXPECT_THAT(messages[0], ::testing::HasSubstr("13 × 6"));
  EXPECT_NEAR(pixel(m_renderer->readAov(Aov::Beauty), 24, 24).r, 0.5F, 0.08F) << "the mean of light, not of codes";
}

TEST_F(FrameTextures, UnusedOnesAreReleased) {
  ResolvedScene scene = plane();
  setMap(scene, TextureSlot::Emissive, imageOf(2, 2, 1, PixelType::U8, {0, 1, 1, 0}));
  still(scene);
  EXPECT_EQ(m_renderer->statistics().residentTextures, 1U);
  for (int i = 0; i < 5; ++i) {
    setMap(scene, TextureSlot::Emissive, imageOf(2, 2, 1, PixelType::U8, {0, 1, 1, 1}));
    still(scene);
    EXPECT_EQ(m_renderer->statistics().residentTextures, 1U);
  }
  EXPECT_EQ(m_renderer->statistics().texturesReleased, 5U);
}

TEST_F(FrameTextures, WithoutTextureCoordinatesMapsAreLeftOut) {
  Model model = makePlane();
  model.hasUvs = false;
  for (glm::vec2& uv : model.uvs) uv = glm::vec2(0.0F);
  ResolvedScene scene = sceneOf(std::move(model), emissive(glm::vec3(1.0F)), glm::vec3(0.0F));
  setMap(scene, TextureSlot::Emissive, imageOf(1, 1, 1, PixelType::U8, {0.0F}));
  EXPECT_THAT(pixel(still(scene), 24, 24), IsColour(glm::vec3(1.0F), 1e-3F));
}

TEST(FrameTexturePixels, ReducingAveragesWholeAreas) {
  const auto image = imageOf(4, 2, 1, PixelType::Float, {0, 2, 4, 6, 2, 4, 6, 8});
  const Image small = reduced(*image, 2, false);
  ASSERT_EQ(small.width, 2);
  ASSERT_EQ(small.height, 1);
  EXPECT_FLOAT_EQ(pixel(small, 0, 0).r, 2.0F);
  EXPECT_FLOAT_EQ(pixel(small, 1, 0).r, 6.0F);
}

TEST(FrameTexturePixels, AlphaIsNeverDecoded) {
  const auto image = imageOf(1, 1, 4, PixelType::U16, {0.5F, 0.5F, 0.5F, 0.5F});
  const Image linear = toFloatRgba(srgbToLinear(*image));
  EXPECT_NEAR(pixel(linear, 0, 0).r, linearFromSrgb(0.5F), 1e-3F);
  EXPECT_NEAR(pixel(linear, 0, 0).a, 0.5F, 1e-3F);
}

}  // namespace
}  // namespace dermis::test
