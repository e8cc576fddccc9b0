// Sets of UDIM tiles: their names, their squares, where a place is read.
#include "core/io/udim.h"

#include <gtest/gtest.h>

#include "core/image/image_tiles.h"
#include "core/io/asset_loader.h"
#include "unit/temporary_folder.h"

namespace dermis {
namespace {

using std::filesystem::path;

TEST(UdimNames, ATileStandsForItsSet) {
  const test::TemporaryFolder folder;
  for (const char* name :
       {"skin.1001.png", "skin.1012.png", "head_1001_albedo.png", "head_1002_albedo.png", "old_u1_v1.tif",
        "old_u10_v2.tif", "alone.1001.png", "IMG_1043.jpg", "IMG_1044.jpg", "year2024.png", "long.10011.png"})
    folder.write(name, "tile");
  const std::pair<const char*, const char*> kSets[] = {{"skin.1012.png", "skin.<UDIM>.png"},
                                                       {"head_1002_albedo.png", "head_<UDIM>_albedo.png"},
                                                       {"old_u1_v1.tif", "old_<UVTILE>.tif"}};
  for (const auto& [tile, set] : kSets) EXPECT_EQ(udimSetOf(folder / tile), folder / set) << tile;
  for (const char* name : {"alone.1001.png", "IMG_1043.jpg", "year2024.png", "long.10011.png", "none.1001.png"})
    EXPECT_FALSE(udimSetOf(folder / name)) << name;
}

TEST(UdimNames, EveryTokenFindsTheTiles) {
  const test::TemporaryFolder folder;
  for (const char* name : {"skin.1001.png", "skin.1012.png", "skin.1100.png", "skin.1101.png", "skin.0999.png"})
    folder.write(name, "tile");
  folder.write("old_u2_v3.tif", "tile");
  for (const char* set : {"skin.<UDIM>.png", "skin.<udim>.png", "skin.%(UDIM)d.png", "skin.1001.png"}) {
    const auto tiles = udimTiles(folder / set);
    ASSERT_EQ(tiles.size(), 3U) << set;
    EXPECT_EQ(tiles[1].number, 1012) << set;
    EXPECT_EQ(tiles[1].file, folder / "skin.1012.png") << set;
    EXPECT_EQ(tiles[2].number, 1100) << set;
  }
  const auto mudbox = udimTiles(folder / "old_<UVTILE>.tif");
  ASSERT_EQ(mudbox.size(), 1U);
  EXPECT_EQ(mudbox[0].number, 1022);
  EXPECT_TRUE(hasUdimToken("a/skin.%(UDIM)d.exr"));
  EXPECT_FALSE(hasUdimToken("a<UDIM>/skin.exr"));
}

TEST(UdimNames, TheKeyOfAMapIsThatOfAllItsTiles) {
  const test::TemporaryFolder folder;
  const path first = folder.write("s.1001.png", "one"), second = folder.write("s.1002.png", "two");
  const std::string before = AssetCache::mapKey(folder / "s.<UDIM>.png");
  EXPECT_EQ(before, AssetCache::mapKey(first));
  EXPECT_NE(AssetCache::fileKey(first), AssetCache::fileKey(second));
  folder.write("s.1002.png", "longer");
  EXPECT_NE(AssetCache::mapKey(folder / "s.<UDIM>.png"), before);
  EXPECT_TRUE(AssetCache::mapKey(folder / "t.<UDIM>.png").empty());
}

TEST(UdimSquares, TenToARow) {
  EXPECT_EQ(udimSquare(1001), glm::ivec2(0, 0));
  EXPECT_EQ(udimSquare(1010), glm::ivec2(9, 0));
  EXPECT_EQ(udimSquare(1011), glm::ivec2(0, 1));
  EXPECT_EQ(udimSquare(1100), glm::ivec2(9, 9));
  EXPECT_EQ(udimNumber({9, 9}), 1100);
  for (const glm::ivec2 outside : {glm::ivec2(10, 0), glm::ivec2(-1, 0), glm::ivec2(0, -1), glm::ivec2(0, 10)})
    EXPECT_FALSE(udimNumber(outside));
}

TEST(UdimSquares, APlaceIsReadInItsTileAndOnAnEdgeInTheOneThatIsThere) {
  Image set;
  set.width = 1;
  set.channels = 1;
  set.tiles = {1001, 1002, 1013};
  set.height = 3;
  set.pixels.resize(3);
  const auto at = [&](float u, float v) { return tilePlace(set, {u, v}); };
  EXPECT_EQ(at(0.25F, 0.75F)->index, 0U);
  EXPECT_EQ(at(1.0F, 0.5F)->index, 1U);
  EXPECT_FLOAT_EQ(at(1.0F, 0.5F)->uv.x, 0.0F);
  EXPECT_EQ(at(2.5F, 1.5F)->index, 2U);
  // The upper edges of tiles that have no neighbour, and rounding below zero.
  EXPECT_EQ(at(2.0F, 0.5F)->index, 1U);
  EXPECT_FLOAT_EQ(at(2.0F, 0.5F)->uv.x, 1.0F);
  EXPECT_EQ(at(0.5F, 1.0F)->index, 0U);
  EXPECT_EQ(at(-1e-7F, 0.5F)->index, 0U);
  for (const glm::vec2 none : {glm::vec2(2.5F, 0.5F), glm::vec2(-0.5F, 0.5F), glm::vec2(11.0F, 0.5F)})
    EXPECT_FALSE(at(none.x, none.y)) << none.x;
  EXPECT_EQ(tileBits(set)[0], 0x1003U);
}

TEST(UdimSquares, AnEnlargedTileIsSmooth) {
  Image image;
  image.width = 2;
  image.height = 1;
  image.channels = 1;
  image.pixels = std::vector{std::byte{0}, std::byte{200}};
  const Image wide = resampled(image, 4, 2);
  const int kExpected[] = {0, 50, 150, 200};
  for (std::size_t i = 0; i < 8; ++i) EXPECT_EQ(std::to_integer<int>(wide.pixels[i]), kExpected[i % 4]) << i;
}

}  // namespace
}  // namespace dermis
