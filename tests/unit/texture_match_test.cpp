// File names that people give their maps, and what a folder of them becomes.
#include "core/material/texture_match.h"

#include <gtest/gtest.h>

#include <optional>

namespace dermis {
namespace {

std::optional<TextureMatch> one(const char* name) {
  const TextureMatches matches = matchTextures({name}, "head", {"head", "eye"});
  if (matches.maps.empty()) return std::nullopt;
  return matches.maps.front();
}

TEST(TextureMatch, KnowsTheNamesThatToolsAndPeopleGive) {
  const std::pair<const char*, TextureSlot> kNames[] = {
      {"head_albedo.png", TextureSlot::Albedo},
      {"Head_BaseColor.png", TextureSlot::Albedo},
      {"HEAD-Base-Colour_4K.tif", TextureSlot::Albedo},
      {"head.diffuse.jpg", TextureSlot::Albedo},
      {"head_col_sRGB.png", TextureSlot::Albedo},
      {"Head Normal OpenGL 16bit.png", TextureSlot::Normal},
      {"head_nrm.png", TextureSlot::Normal},
      {"headDetailNormal.png", TextureSlot::DetailNormal},
      {"head_micro_nrm.png", TextureSlot::DetailNormal},
      {"head_detail_mask.png", TextureSlot::DetailMask},
      {"head_roughness_2k.exr", TextureSlot::Roughness},
      {"faceroughness.png", TextureSlot::Roughness},
      {"head_Spec.png", TextureSlot::Specular},
      {"head-cavity.png", TextureSlot::Cavity},
      {"headAO.png", TextureSlot::Occlusion},
      {"head_ambient_occlusion.png", TextureSlot::Occlusion},
      {"head_disp.exr", TextureSlot::Displacement},
      {"head_height_1024.png", TextureSlot::Displacement},
      {"Head_Thickness.png", TextureSlot::Thickness},
      {"head_sss.png", TextureSlot::Subsurface},
      {"head_metalness.png", TextureSlot::Metallic},
      {"albedo_head.png", TextureSlot::Albedo},
      {"albedo.png", TextureSlot::Albedo},
  };
  for (const auto& [name, texture] : kNames) {
    const auto match = one(name);
    ASSERT_TRUE(match) << name;
    EXPECT_EQ(match->texture, texture) << name;
    EXPECT_FALSE(match->invert) << name;
    EXPECT_FALSE(match->flipGreen) << name;
  }
}

TEST(TextureMatch, LeavesOrdinaryNamesAlone) {
  for (const char* name : {"IMG_2041.jpg", "specimen.png", "chaos.png", "column.png", "reference photo.png", "4k.png"})
    EXPECT_FALSE(one(name)) << name;
}

TEST(TextureMatch, KnowsDirectXAndGloss) {
  EXPECT_TRUE(one("head_normal_dx.png")->flipGreen);
  EXPECT_TRUE(one("Head_NormalDirectX.png")->flipGreen);
  const auto gloss = one("head_gloss.png");
  EXPECT_EQ(gloss->texture, TextureSlot::Roughness);
  EXPECT_TRUE(gloss->invert);
}

TEST(TextureMatch, ASlotTakesItsOwnFilesAndNotAnothers) {
  const std::vector<std::filesystem::path> files = {"m/eye_albedo.png", "m/head_albedo.png", "m/shared_normal.png"};
  const TextureMatches head = matchTextures(files, "head", {"head", "eye", "lens"});
  ASSERT_EQ(head.maps.size(), 2U);
  EXPECT_EQ(head.maps[0].path, "m/head_albedo.png");
  EXPECT_EQ(head.maps[1].path, "m/shared_normal.png");
  EXPECT_EQ(head.leftOver, (std::vector<std::filesystem::path>{"m/eye_albedo.png"}));
  EXPECT_EQ(matchTextures(files, "eye", {"head", "eye", "lens"}).maps[0].path, "m/eye_albedo.png");
}

TEST(TextureMatch, TheLargerAndDeeperCopyWins) {
  const TextureMatches matches = matchTextures(
      {"head_albedo_1k.png", "head_albedo_4k.jpg", "head_albedo_4k.tif", "head_rough.jpg", "head_rough.exr"}, "head",
      {});
  ASSERT_EQ(matches.maps.size(), 2U);
  EXPECT_EQ(matches.maps[0].path, "head_albedo_4k.tif");
  EXPECT_EQ(matches.maps[1].path, "head_rough.exr");
  EXPECT_EQ(matches.leftOver.size(), 3U);
}

}  // namespace
}  // namespace dermis
