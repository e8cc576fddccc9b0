// Tiles of a UDIM set, read from files: all of them, made alike.
#include "core/io/udim.h"

#include <gmock/gmock.h>

#include "core/image/image_tiles.h"
#include "core/io/asset_loader.h"
#include "core/io/importer.h"
#include "import/fixtures.h"
#include "unit/temporary_folder.h"

namespace dermis::test {
namespace {

using testing::HasSubstr;

class UdimFiles : public testing::Test {
 protected:
  TemporaryFolder folder;
  Warnings warnings;

  /// A tile of one value; the last of two or four channels is 1.
  void put(const std::string& name, int side, int channels, PixelType type, float value) {
    static const std::vector<std::vector<std::string>> kNames = {
        {"Y"}, {"Y", "A"}, {"R", "G", "B"}, {"R", "G", "B", "A"}};
    ImageLayer layer{"", kNames.at(static_cast<std::size_t>(channels - 1)), {}};
    Image& image = layer.image;
    image.width = image.height = side;
    image.channels = channels;
    image.type = type;
    image.pixels.resize(image.rowBytes() * static_cast<std::size_t>(side));
    for (std::size_t i = 0; i < image.pixels.size() / bytesPerChannel(type); ++i) {
      std::byte* at = image.pixels.data() + i * bytesPerChannel(type);
      if (type == PixelType::U8) *at = static_cast<std::byte>(value * 255.0F);
      const auto wide = static_cast<std::uint16_t>(value * 65535.0F);
      if (type == PixelType::U16) std::memcpy(at, &wide, sizeof wide);
      if (type == PixelType::Float) std::memcpy(at, &value, sizeof value);
    }
    const auto written = (*importer())->writeImage(folder / name, {layer}, {});
    ASSERT_TRUE(written) << written.error().message;
  }
  Result<Image> read(const char* set, std::size_t most = kMostUdimBytes) {
    return readUdimSet(folder / set, **importer(), most, warnings, {});
  }
  static float value(const Image& set, std::size_t tile, int x, int y, std::size_t channel) {
    const Image one = tileOf(set, tile);
    const std::size_t at =
        (static_cast<std::size_t>(y) * static_cast<std::size_t>(one.width) + static_cast<std::size_t>(x)) *
            static_cast<std::size_t>(one.channels) +
        channel;
    if (one.type == PixelType::U8) return static_cast<float>(std::to_integer<int>(one.pixels[at])) / 255.0F;
    std::uint16_t wide = 0;
    std::memcpy(&wide, one.pixels.data() + at * 2, 2);
    return static_cast<float>(wide) / 65535.0F;
  }
};

TEST_F(UdimFiles, AllTilesAreReadInOrder) {
  put("s.1011.png", 4, 3, PixelType::U8, 0.6F);
  put("s.1001.png", 4, 3, PixelType::U8, 0.2F);
  put("s.1003.png", 4, 3, PixelType::U8, 0.4F);
  const auto set = read("s.<UDIM>.png");
  ASSERT_TRUE(set) << set.error().message;
  EXPECT_EQ(set->tiles, (std::vector<int>{1001, 1003, 1011}));
  EXPECT_EQ(set->width, 4);
  EXPECT_EQ(tileHeight(*set), 4);
  EXPECT_EQ(set->name, "s.<UDIM>.png");
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_NEAR(value(*set, i, 3, 3, 2), 0.2F + 0.2F * static_cast<float>(i), 0.005F) << i;
  EXPECT_TRUE(warnings.empty());
}

TEST_F(UdimFiles, TilesThatDifferAreMadeAlike) {
  put("s.1001.png", 8, 1, PixelType::U8, 0.2F);
  put("s.1002.png", 4, 4, PixelType::U16, 0.4F);
  put("s.1003.png", 8, 3, PixelType::U8, 0.6F);
  const auto set = read("s.1002.png");
  ASSERT_TRUE(set) << set.error().message;
  EXPECT_EQ(set->channels, 4);
  EXPECT_EQ(set->type, PixelType::U16);
  EXPECT_EQ(set->width, 8);
  for (std::size_t i = 0; i < 3; ++i)
    for (const std::size_t channel : {std::size_t{0}, std::size_t{2}})
      EXPECT_NEAR(value(*set, i, 7, 7, channel), 0.2F + 0.2F * static_cast<float>(i), 0.005F) << i;
  EXPECT_NEAR(value(*set, 0, 0, 0, 3), 1.0F, 1e-6F);
  EXPECT_NEAR(value(*set, 1, 0, 0, 3), 0.4F, 0.005F);
}

TEST_F(UdimFiles, TooLargeSetsAreReadSmallerWithOneSentence) {
  for (const char* name : {"s.1001.png", "s.1002.png", "s.1012.png"}) put(name, 32, 1, PixelType::U8, 0.5F);
  const auto set = read("s.<UDIM>.png", 1000);
  ASSERT_TRUE(set) << set.error().message;
  EXPECT_EQ(set->width, 16);
  EXPECT_EQ(tileHeight(*set), 16);
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_THAT(warnings[0], HasSubstr("3 tiles of 32 × 32"));
  EXPECT_THAT(warnings[0], HasSubstr("16 × 16"));
}

TEST_F(UdimFiles, WhatCantBeReadIsSaid) {
  EXPECT_THAT(read("none.<UDIM>.png").error().message, HasSubstr("none of them"));
  put("s.1001.exr", 2, 3, PixelType::Float, 0.5F);
  put("s.1002.exr", 2, 3, PixelType::Float, 0.5F);
  folder.write("s.1003.exr", "not a picture");
  EXPECT_THAT(read("s.<UDIM>.exr").error().message, HasSubstr("s.1003.exr"));
  put("t.1001.png", 2, 1, PixelType::U8, 0.5F);
  put("t.1002.png", 2, 1, PixelType::U8, 0.5F);
  folder.write("t.1101.png", "past the last row");
  ASSERT_TRUE(read("t.<UDIM>.png"));
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_THAT(warnings[0], HasSubstr("1101"));
}

TEST_F(UdimFiles, ATextureIsTheSetThatItsPathNames) {
  put("s.1001.png", 2, 1, PixelType::U8, 0.5F);
  put("s.1002.png", 2, 1, PixelType::U8, 0.5F);
  put("alone.1001.png", 2, 1, PixelType::U8, 0.5F);
  ResolveOptions options;
  options.cache = std::make_shared<AssetCache>();
  const auto set = resolveTexture(folder / "s.<UDIM>.png", options, warnings);
  ASSERT_TRUE(set);
  EXPECT_EQ((*set)->tiles.size(), 2U);
  EXPECT_EQ(*resolveTexture(folder / "s.1001.png", options, warnings), *set);
  EXPECT_TRUE((*resolveTexture(folder / "alone.1001.png", options, warnings))->tiles.empty());
}

}  // namespace
}  // namespace dermis::test
