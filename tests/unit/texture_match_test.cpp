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
  ASSERT_EQ(head.leftOver.size(), 1U);
  EXPECT_EQ(head.leftOver[0].path, "m/eye_albedo.png");
  EXPECT_EQ(head.leftOver[0].why, TextureLeftOver::Why::OtherSlot);
  EXPECT_EQ(matchTextures(files, "eye", {"head", "eye", "lens"}).maps[0].path, "m/eye_albedo.png");
}

TEST(TextureMatch, TheLargerAndDeeperCopyWins) {
  const TextureMatches matches = matchTextures(
      {"head_albedo_1k.png", "head_albedo_4k.jpg", "head_albedo_4k.tif", "head_rough.jpg", "head_rough.exr"}, "head",
      {});
  ASSERT_EQ(matches.maps.size(), 2U);
  EXPECT_EQ(matches.maps[0].path, "head_albedo_4k.tif");
  EXPECT_EQ(matches.maps[1].path, "head_rough.exr");
  ASSERT_EQ(matches.leftOver.size(), 3U);
  for (const TextureLeftOver& left : matches.leftOver) EXPECT_EQ(left.why, TextureLeftOver::Why::Poorer);
}

TEST(TextureMatch, PackedMapsGiveEachChannelItsPlace) {
  using enum TextureChannel;
  struct Expected {
    const char* name;
    TextureChannel occlusion, roughness, metallic;
  };
  for (const Expected& e : {Expected{"head_ORM.png", R, G, B}, Expected{"head_arm_4k.png", R, G, B},
                            Expected{"Head_OcclusionRoughnessMetallic.png", R, G, B},
                            Expected{"head_occlusion_roughness_metallic.tga", R, G, B},
                            Expected{"head_MRAO.png", B, G, R}, Expected{"head-RMA-2k.png", B, R, G}}) {
    const TextureMatches matches = matchTextures({e.name}, "head", {"head"});
    ASSERT_EQ(matches.maps.size(), 3U) << e.name;
    EXPECT_EQ(matches.maps[0].texture, TextureSlot::Metallic) << e.name;
    EXPECT_EQ(matches.maps[0].channel, e.metallic) << e.name;
    EXPECT_EQ(matches.maps[1].texture, TextureSlot::Roughness) << e.name;
    EXPECT_EQ(matches.maps[1].channel, e.roughness) << e.name;
    EXPECT_EQ(matches.maps[2].texture, TextureSlot::Occlusion) << e.name;
    EXPECT_EQ(matches.maps[2].channel, e.occlusion) << e.name;
    EXPECT_TRUE(matches.leftOver.empty()) << e.name;
  }
  const TextureMatches gltf = matchTextures({"head_metallicRoughness.png"}, "head", {});
  ASSERT_EQ(gltf.maps.size(), 2U);
  EXPECT_EQ(gltf.maps[0].channel, B);
  EXPECT_EQ(gltf.maps[1].channel, G);
  const TextureMatches unity = matchTextures({"Head_MaskMap.png"}, "head", {});
  ASSERT_EQ(unity.maps.size(), 4U);
  EXPECT_EQ(unity.maps[2].texture, TextureSlot::Roughness);
  EXPECT_EQ(unity.maps[2].channel, A);
  EXPECT_TRUE(unity.maps[2].invert);
  for (const char* name : {"left_arm.png", "arm.png", "forearm_2k.png"}) EXPECT_FALSE(one(name)) << name;
}

TEST(TextureMatch, AMapOfItsOwnGoesBeforeAPackedOne) {
  const TextureMatches matches = matchTextures({"head_ORM_4k.png", "head_roughness.png"}, "head", {});
  ASSERT_EQ(matches.maps.size(), 3U);
  EXPECT_EQ(matches.maps[1].path, "head_roughness.png");
  EXPECT_EQ(matches.maps[2].path, "head_ORM_4k.png");
  EXPECT_TRUE(matches.leftOver.empty());
}

TEST(TextureMatch, OpacityIsKnownAndHasNoPlace) {
  for (const char* name : {"hair_opacity.png", "hair_Alpha_2k.png", "hair-mask.png"}) {
    const TextureMatches matches = matchTextures({name}, "hair", {});
    EXPECT_TRUE(matches.maps.empty()) << name;
    ASSERT_EQ(matches.leftOver.size(), 1U) << name;
    EXPECT_EQ(matches.leftOver[0].why, TextureLeftOver::Why::Opacity) << name;
  }
  EXPECT_EQ(one("head_detail_mask.png")->texture, TextureSlot::DetailMask);
  EXPECT_EQ(one("head_subsurface_mask.png")->texture, TextureSlot::Subsurface);
}

}  // namespace
}  // namespace dermis
