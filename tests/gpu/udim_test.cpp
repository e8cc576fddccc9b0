// Maps of several tiles: every pixel shows what the CPU reads of its tile, at borders and however small it is.
#include <algorithm>
#include <cmath>

#include "core/image/image_tiles.h"
#include "core/scene/primitives.h"
#include "gpu/frame_support.h"

namespace dermis::test {
namespace {

/// `value(number, x, y)` of each texel, y from a tile's first row.
template <class Value>
std::shared_ptr<const Image> setOf(const std::vector<int>& numbers, int side, const Value& value) {
  std::vector<float> values;
  for (const int number : numbers)
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x) values.push_back(value(number, x, y));
  auto set =
      std::make_shared<Image>(*imageOf(side, side * static_cast<int>(numbers.size()), 1, PixelType::Float, values));
  set->tiles = numbers;
  return set;
}

/// −1..1, its texture coordinates 0..`extent`.
Model spread(glm::vec2 extent, int squares = 1) {
  Model model = squares == 1 ? makePlane() : planeOf(squares);
  for (glm::vec2& uv : model.uvs) uv *= extent;
  return model;
}

/// Some number 0..1 of its own for each texel.
float noise(int number, int x, int y) {
  return 0.5F + 0.5F * std::sin(static_cast<float>(number * 37 + x * 113 + y * 71));
}

/// Bilinear in one tile, clamped to its edges; 0 without a tile, as emission is.
float expected(const Image& set, glm::vec2 uv) {
  const auto place = tilePlace(set, uv);
  if (!place) return 0.0F;
  const Image tile = tileOf(set, place->index);
  const glm::vec2 at = place->uv * glm::vec2(tile.width, tile.height) - 0.5F;
  const glm::vec2 low = glm::floor(at);
  const auto texel = [&](float x, float y) {
    const int column = std::clamp(static_cast<int>(x), 0, tile.width - 1);
    const int row = std::clamp(static_cast<int>(y), 0, tile.height - 1);
    return pixel(tile, column, tile.height - 1 - row).r;
  };
  const glm::vec2 share = at - low;
  return glm::mix(glm::mix(texel(low.x, low.y), texel(low.x + 1, low.y), share.x),
                  glm::mix(texel(low.x, low.y + 1), texel(low.x + 1, low.y + 1), share.x), share.y);
}

class UdimPictures : public FrameTest {
 protected:
  /// The texture coordinates in the middle of a pixel.
  glm::vec2 uvAt(int x, int y, glm::vec2 extent) const {
    return (glm::vec2(x, m_size.y - 1 - y) + 0.5F) / glm::vec2(m_size) * extent;
  }
  Warnings messages;
  Image shown(const ResolvedScene& scene) {
    show(scene);
    EXPECT_TRUE(m_renderer->renderFrame(request(scene)));
    messages = m_renderer->takeMessages();
    return m_renderer->readAov(Aov::Beauty);
  }
};

TEST_F(UdimPictures, EachSquareShowsItsTileToTheBorder) {
  const glm::vec2 extent(3.0F, 2.0F);
  const auto set = setOf({1001, 1002, 1003, 1011, 1013}, 6, noise);
  // One quad, and a mesh dense enough to be drawn in two steps where GL is software.
  for (const int squares : {1, 72}) {
    ResolvedScene scene = sceneOf(spread(extent, squares), emissive(glm::vec3(1.0F)), glm::vec3(0.0F));
    setMap(scene, TextureSlot::Emissive, set);
    const Image image = shown(scene);
    // Said once.
    ASSERT_EQ(messages.size(), squares == 1 ? 1U : 0U);
    if (squares == 1) {
      EXPECT_THAT(messages[0], ::testing::HasSubstr("no tile for 1012"));
    }
    for (int y = 0; y < m_size.y; ++y)
      for (int x = 0; x < m_size.x; ++x)
        EXPECT_NEAR(pixel(image, x, y).r, expected(*set, uvAt(x, y, extent)), 0.006F)
            << x << ' ' << y << " of " << squares;
  }
}

TEST_F(UdimPictures, SmallTilesKeepToThemselves) {
  // Ten by ten tiles of 64 texels in 48 pixels: nothing of a tile's neighbours may get into its mips.
  std::vector<int> numbers;
  for (int number = kFirstUdim; number <= kLastUdim; ++number) numbers.push_back(number);
  const auto colour = [](int number, int, int) { return number % 2 == (number / 10) % 2 ? 1.0F : 0.25F; };
  const auto set = setOf(numbers, 64, colour);
  const glm::vec2 extent(10.0F);
  ResolvedScene scene = sceneOf(spread(extent), emissive(glm::vec3(1.0F)), glm::vec3(0.0F));
  setMap(scene, TextureSlot::Emissive, set);
  const Image image = shown(scene);
  EXPECT_TRUE(messages.empty());
  for (int y = 0; y < m_size.y; ++y)
    for (int x = 0; x < m_size.x; ++x) {
      const glm::ivec2 square(uvAt(x, y, extent));
      EXPECT_NEAR(pixel(image, x, y).r, colour(*udimNumber(square), 0, 0), 1e-3F) << x << ' ' << y;
    }
}

TEST_F(UdimPictures, AMipIsTheMeanOfItsOwnTexels) {
  // Four texels a pixel, exactly: each pixel is the mean of its sixteen.
  const glm::vec2 extent(3.0F, 3.0F);
  const auto set = setOf({1001, 1002, 1003, 1011, 1012, 1013, 1021, 1022, 1023}, 64, noise);
  ResolvedScene scene = sceneOf(spread(extent), emissive(glm::vec3(1.0F)), glm::vec3(0.0F));
  setMap(scene, TextureSlot::Emissive, set);
  const Image image = shown(scene);
  for (int y = 0; y < m_size.y; ++y)
    for (int x = 0; x < m_size.x; ++x) {
      const int number = *udimNumber({x / 16, (m_size.y - 1 - y) / 16});
      float mean = 0.0F;
      for (int i = 0; i < 16; ++i) mean += noise(number, (x % 16) * 4 + i % 4, (y % 16) * 4 + i / 4) / 16.0F;
      EXPECT_NEAR(pixel(image, x, y).r, mean, 0.004F) << x << ' ' << y;
    }
}

TEST_F(UdimPictures, OtherMapsOfTheMaterialStayAsTheyAre) {
  // A plain map beside a set repeats over all squares.
  const glm::vec2 extent(2.0F, 1.0F);
  ResolvedScene scene = sceneOf(spread(extent), materialOf(ShadingModel::Skin));
  m_renderer->keepAovs({Aov::Occlusion});
  setMap(scene, TextureSlot::Roughness, setOf({1001, 1002}, 2, [](int, int, int) { return 0.5F; }));
  const auto plain = imageOf(2, 2, 1, PixelType::U8, {0.2F, 0.8F, 0.4F, 0.6F});
  setMap(scene, TextureSlot::Occlusion, plain);
  show(scene);
  ASSERT_TRUE(m_renderer->renderFrame(request(scene)));
  const Image tiled = m_renderer->readAov(Aov::Occlusion);
  setMap(scene, TextureSlot::Roughness, nullptr);
  show(scene);
  ASSERT_TRUE(m_renderer->renderFrame(request(scene)));
  EXPECT_LT(largestDifference(tiled, m_renderer->readAov(Aov::Occlusion)), 1e-4F);
  EXPECT_EQ(m_renderer->statistics().texturesUploaded, 2U);
}

TEST_F(UdimPictures, NormalsAndHeightsAreReadByTile) {
  const glm::vec2 extent(3.0F, 1.0F);  // the third square has no tile
  ResolvedScene scene = sceneOf(spread(extent, 12), materialOf(ShadingModel::Skin));
  scene.slots[0].material.parameters.surfaceDisplacementMm = 10.0F;
  scene.slots[0].material.parameters.surfaceDisplacementMidlevel = 0.0F;
  m_renderer->keepAovs({Aov::Normal, Aov::Depth});
  setMap(scene, TextureSlot::Displacement,
         setOf({1001, 1002}, 4, [](int number, int, int) { return number == 1001 ? 1.0F : 3.0F; }));
  auto normals = std::make_shared<Image>(
      *imageOf(1, 2, 3, PixelType::Float, {0.5F + 0.3F, 0.5F, 0.5F + 0.4F, 0.5F - 0.3F, 0.5F, 0.5F + 0.4F}));
  normals->tiles = {1001, 1002};
  setMap(scene, TextureSlot::Normal, normals);
  show(scene);
  ASSERT_TRUE(m_renderer->renderFrame(request(scene)));
  const Image depth = m_renderer->readAov(Aov::Depth), normal = m_renderer->readAov(Aov::Normal);
  const float kHeights[] = {0.1F, 0.3F, 0.0F}, kSlopes[] = {0.6F, -0.6F, 0.0F};
  for (int square = 0; square < 3; ++square) {
    const int x = 8 + 16 * square;
    EXPECT_NEAR(pixel(depth, x, 24).r, 5.0F - kHeights[square], 1e-3F) << square;
    EXPECT_NEAR(pixel(normal, x, 24).r, kSlopes[square], 0.02F) << square;
  }
}

TEST_F(UdimPictures, AMovingPictureReadsThemToo) {
  // Dense enough for two steps, with a lamp that shines through what the thickness map says.
  ResolvedScene scene = sceneOf(spread(glm::vec2(2.0F, 1.0F), 72), materialOf(ShadingModel::Skin));
  scene.scene.lights = {pointLight({0.0F, 0.0F, 2.0F}, 6.0F)};
  const auto dark = setOf({1001, 1002}, 2, [](int number, int, int) { return number == 1001 ? 0.05F : 1.0F; });
  setMap(scene, TextureSlot::Albedo, dark);
  setMap(scene, TextureSlot::Thickness, dark);
  const std::vector<std::uint8_t> shown = movingPicture(scene, true);
  const auto red = [&](int x) {
    return int{shown[4 * (static_cast<std::size_t>(m_size.y / 2) * static_cast<std::size_t>(m_size.x) +
                          static_cast<std::size_t>(x))]};
  };
  EXPECT_GT(red(36), red(12) + 40) << red(12);
  EXPECT_GT(red(36), 60);
}

TEST_F(UdimPictures, EveryModelReadsThemInEverySlot) {
  const auto set = setOf({1001, 1002}, 2, [](int, int, int) { return 0.5F; });
  for (const ShadingModel model : {ShadingModel::Eye, ShadingModel::Thesis, ShadingModel::MetallicRoughness}) {
    ResolvedScene scene = sceneOf(spread(glm::vec2(2.0F, 1.0F)), materialOf(model));
    scene.slots[0].material.parameters.metallicRoughnessAlphaMode = AlphaMode::Mask;
    for (const TextureSlotRow& row : textureSlots()) setMap(scene, row.slot, set);
    scene.scene.lights = {pointLight({0.0F, 0.5F, 2.0F}, 4.0F)};
    const Image image = shown(scene);
    EXPECT_TRUE(messages.empty()) << messages.front();
    EXPECT_TRUE(std::isfinite(pixel(image, 12, 24).r));
  }
}

}  // namespace
}  // namespace dermis::test
