// The built-in head's skin: its colours against published spectra, its maps against what they promise.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <functional>

#include "core/builtin/maps.h"
#include "core/builtin/skin/head_maps.h"
#include "core/builtin/skin/noise.h"
#include "core/builtin/skin/pigments.h"
#include "core/builtin/skin/skin_detail.h"

namespace dermis {
namespace {

using namespace skin;
using testing::HasSubstr;

TEST(SkinPigments, BloodHasItsPublishedIsosbesticPoints) {
  // Zijlstra, Buursma & van Assendelft 2000: with and without oxygen blood absorbs the same at 500, 529, 545, 570 and
  // 584 nm; between them the two cross. The table has 10 nm steps.
  for (const double nm : {500.0, 529.0, 570.0})
    EXPECT_NEAR(bloodAbsorption(nm, 1.0) / bloodAbsorption(nm, 0.0), 1.0, 0.05) << nm;
  EXPECT_GT(bloodAbsorption(577.0, 1.0), bloodAbsorption(577.0, 0.0));
  EXPECT_LT(bloodAbsorption(557.0, 1.0), bloodAbsorption(557.0, 0.0));
  EXPECT_GT(bloodAbsorption(660.0, 0.0) / bloodAbsorption(660.0, 1.0), 8.0) << "what pulse oximeters live on";
}

TEST(SkinPigments, FairSkinReflectsAsMeasured) {
  // Fair, untanned skin: 30 to 45 % at 550 nm, 50 to 70 % at 650 nm, and blood's double dip (Angelopoulou 2001,
  // "Understanding the Color of Human Skin"; the W of its figure 2: 542 and 577 nm are darker than 560).
  const Pigments fair{0.02, 0.01, 0.75};
  EXPECT_NEAR(skinReflectance(550.0, fair), 0.375, 0.075);
  EXPECT_NEAR(skinReflectance(650.0, fair), 0.60, 0.10);
  EXPECT_GT(skinReflectance(560.0, fair), skinReflectance(542.0, fair));
  EXPECT_GT(skinReflectance(560.0, fair), skinReflectance(577.0, fair));
  const Pigments dark{0.3, 0.01, 0.75};
  EXPECT_LT(skinReflectance(550.0, dark), 0.1);
}

TEST(SkinPigments, MoreOfEitherIsDarkerAndBloodIsRed) {
  glm::dvec3 last(2.0);
  for (const double melanin : {0.005, 0.02, 0.08, 0.3}) {
    const glm::dvec3 albedo = skinAlbedo({melanin, 0.01, 0.75});
    for (int c = 0; c < 3; ++c) {
      EXPECT_LT(albedo[c], last[c]);
      EXPECT_GE(albedo[c], 0.0);
      EXPECT_LE(albedo[c], 1.0);
    }
    last = albedo;
  }
  const glm::dvec3 pale = skinAlbedo({0.02, 0.003, 0.75}), red = skinAlbedo({0.02, 0.05, 0.75});
  EXPECT_GT((red.r / red.g) / (pale.r / pale.g), 1.3);
}

TEST(SkinPigments, TheTableIsTheModel) {
  const AlbedoTable table;
  for (const double melanin : {0.003, 0.021, 0.17})
    for (const double blood : {0.0017, 0.013, 0.06})
      for (const double oxygen : {0.0, 1.0}) {
        const glm::dvec3 exact = skinAlbedo({melanin, blood, oxygen});
        const glm::vec3 read =
            table.at(static_cast<float>(melanin), static_cast<float>(blood), static_cast<float>(oxygen));
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(read[c], exact[c], 0.004) << melanin << " " << blood;
      }
}

TEST(SkinPigments, PigmentsAreFoundAgainFromTheirColour) {
  for (const Pigments& known : {Pigments{0.01, 0.006, 0.75}, Pigments{0.05, 0.02, 0.75}, Pigments{0.12, 0.01, 0.75}}) {
    const Pigments found = pigmentsOf(skinAlbedo(known));
    EXPECT_NEAR(found.melanin / known.melanin, 1.0, 0.03);
    EXPECT_NEAR(found.blood / known.blood, 1.0, 0.03);
  }
}

TEST(SkinNoise, IsSmoothCentredAndTheSameForTheSameSeed) {
  double sum = 0.0, most = 0.0, steepest = 0.0;
  constexpr int kCount = 20000;
  for (int i = 0; i < kCount; ++i) {
    const glm::vec3 p(0.173F * static_cast<float>(i), 0.311F * static_cast<float>(i % 977),
                      -0.071F * static_cast<float>(i));
    const auto value = static_cast<double>(noise(p, 5));
    sum += value;
    most = std::max(most, std::abs(value));
    steepest = std::max(steepest, std::abs(static_cast<double>(noise(p + glm::vec3(1e-3F, 0, 0), 5)) - value));
    ASSERT_EQ(noise(p, 5), noise(p, 5));
  }
  EXPECT_NEAR(sum / kCount, 0.0, 0.02);
  EXPECT_GT(most, 0.7);
  EXPECT_LT(most, 1.2);
  EXPECT_LT(steepest, 0.01);
  EXPECT_NE(noise({0.3F, 0.4F, 0.5F}, 5), noise({0.3F, 0.4F, 0.5F}, 6));
}

TEST(HeadMapNames, SettingsAreReadAndMistakesNamed) {
  const auto request = parseHeadMap("head_albedo?tone=4.5&age=60&freckles=0.3&seed=7&size=1024");
  ASSERT_TRUE(request);
  EXPECT_EQ(request->look.tone, 4.5F);
  EXPECT_EQ(request->look.age, 60.0F);
  EXPECT_EQ(request->look.seed, 7U);
  EXPECT_EQ(request->size, 1024);
  const auto why = [](std::string_view name) {
    const auto id = builtinMapId("builtin:" + std::string(name));
    return id ? std::string() : id.error().message;
  };
  EXPECT_EQ(why("freckles"), "");
  EXPECT_EQ(why("head_normal"), "");
  EXPECT_EQ(why("skin_detail"), "");
  EXPECT_EQ(why("head_region?region=crows_feet"), "");
  EXPECT_THAT(why("head_region?region=tail"), HasSubstr("there are lips, nose"));
  EXPECT_THAT(why("head_nose"), HasSubstr("is not a map"));
  EXPECT_THAT(why("head_albedo?agee=4"), HasSubstr("has no setting \"agee\"; there are tone, melanin"));
  EXPECT_THAT(why("head_albedo?age"), HasSubstr("without a value"));
  EXPECT_THAT(why("head_albedo?age=old"), HasSubstr("no number from 1 to 100"));
  EXPECT_THAT(why("head_albedo?tone=7"), HasSubstr("no number from 1 to 6"));
  EXPECT_THAT(why("head_albedo?seed=1.5"), HasSubstr("seed"));
  EXPECT_THAT(why("head_albedo?size=1000"), HasSubstr("power of two"));
}

/// Maps of few texels: enough for means and slopes.
class SkinMaps : public testing::Test {
 protected:
  static const HeadAtlas& atlas() {
    static const HeadAtlas kAtlas = rasteriseHead(*builtinHead(HeadLevel::Low), 320);
    return kAtlas;
  }
  static double linear(std::byte code) {
    const double v = std::to_integer<int>(code) / 255.0;
    return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
  }
  static double value16(const Image& image, std::size_t index) {
    std::uint16_t code = 0;
    std::memcpy(&code, image.pixels.data() + 2 * index, sizeof code);
    return code / 65535.0;
  }
  /// Over the texels inside charts where `weight` is above one half.
  template <class Weight>
  static glm::dvec3 mean(const Image& image, const Weight& weight) {
    glm::dvec3 sum(0.0);
    double count = 0.0;
    for (std::size_t i = 0; i < atlas().rest.size(); ++i) {
      if (atlas().covered[i] != 2 || !weight(atlas().rest[i])) continue;
      for (std::size_t c = 0; c < 3; ++c) sum[static_cast<int>(c)] += linear(image.pixels[3 * i + c]);
      count += 1.0;
    }
    return sum / count;
  }
  static glm::dvec3 mean(const Image& image) {
    return mean(image, [](const glm::vec3&) { return true; });
  }
};

TEST_F(SkinMaps, TheMeanOfATonesFaceIsTheTonesAlbedoAndNothingGivesMoreThanItGets) {
  for (const float tone : {1.0F, 2.0F, 3.0F, 4.0F, 5.0F, 6.0F}) {
    Look look;
    look.tone = tone;
    look.stubble = 0.0F;  // hair is no skin
    const Image image = makeHeadAlbedo(atlas(), look);
    const glm::dvec3 found = mean(image), wanted = toneAlbedo(tone);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(found[c] / wanted[c], 1.0, 0.04) << tone << " " << c;
    for (const std::byte code : image.pixels) ASSERT_LE(std::to_integer<int>(code), 252) << tone;
  }
}

TEST_F(SkinMaps, RelativeMapsTimesTheToneAreTheAbsoluteOnes) {
  Look look;
  look.tone = 3.0F;
  const Image absolute = makeHeadAlbedo(atlas(), look), relative = makeHeadAlbedo(atlas(), look, true);
  const glm::dvec3 one = toneAlbedo(3.0) * static_cast<double>(kMostRelative);
  std::size_t clipped = 0;
  for (std::size_t i = 0; i < absolute.pixels.size(); ++i) {
    const double ratio = linear(relative.pixels[i]);
    if (ratio == 1.0) {
      ++clipped;
      continue;
    }
    ASSERT_NEAR(ratio * one[static_cast<int>(i % 3)], linear(absolute.pixels[i]), 0.01);
  }
  EXPECT_LT(clipped, absolute.pixels.size() / 100);
}

TEST_F(SkinMaps, LipsAreRedderCheeksFlushAndFrecklesDarken) {
  const HeadRegions regions;
  const auto in = [&](HeadRegion region) {
    return [&regions, region](const glm::vec3& p) { return regions.at(p)[region] > 0.6F; };
  };
  Look look;
  look.flush = 0.0F;
  look.freckles = 0.0F;
  look.stubble = 0.0F;
  const Image plain = makeHeadAlbedo(atlas(), look);
  const auto redness = [](const glm::dvec3& c) { return c.r / c.g; };
  EXPECT_GT(redness(mean(plain, in(HeadRegion::Lips))), 1.25 * redness(mean(plain)));
  look.flush = 1.0F;
  const Image flushed = makeHeadAlbedo(atlas(), look);
  EXPECT_GT(redness(mean(flushed, in(HeadRegion::Cheek))), 1.15 * redness(mean(plain, in(HeadRegion::Cheek))));
  look.flush = 0.0F;
  look.freckles = 1.0F;
  const Image freckled = makeHeadAlbedo(atlas(), look);
  EXPECT_LT(mean(freckled, in(HeadRegion::Cheek)).g, 0.97 * mean(plain, in(HeadRegion::Cheek)).g);
  look.freckles = 0.0F;
  look.melanin = 3.0F;
  EXPECT_LT(mean(makeHeadAlbedo(atlas(), look)).g, 0.8 * mean(plain).g);
}

TEST_F(SkinMaps, StubbleShadesScalpAndBeardAndBluesThem) {
  const HeadRegions regions;
  const auto grown = [&](const glm::vec3& p) {
    const RegionWeights at = regions.at(p);
    return at[HeadRegion::Scalp] > 0.95F && at[HeadRegion::Ear] < 0.01F;
  };
  const auto bearded = [&](const glm::vec3& p) { return regions.at(p)[HeadRegion::Beard] > 0.95F; };
  const auto bare = [&](const glm::vec3& p) {
    const RegionWeights at = regions.at(p);
    return at[HeadRegion::Scalp] <= 0.0F && at[HeadRegion::Beard] <= 0.0F;
  };
  Look look;
  std::vector<Image> images;
  for (const float stubble : {0.0F, 0.5F, 1.0F}) {
    look.stubble = stubble;
    images.push_back(makeHeadAlbedo(atlas(), look));
  }
  for (const auto& where : {std::function<bool(const glm::vec3&)>(grown), {bearded}}) {
    const glm::dvec3 none = mean(images[0], where), some = mean(images[1], where), full = mean(images[2], where);
    EXPECT_LT(some.g, 0.95 * none.g);
    EXPECT_LT(full.g, 0.95 * some.g);
    EXPECT_GT(full.g, 0.3 * none.g) << "shaved, not a beard";
    EXPECT_GT(full.b / full.r, none.b / none.r);
  }
  EXPECT_EQ(mean(images[2], bare), mean(images[0], bare));
}

TEST_F(SkinMaps, TheSameLookGivesTheSameBytesAndAnotherSeedOthers) {
  Look look;
  const Image first = makeHeadAlbedo(atlas(), look), second = makeHeadAlbedo(atlas(), look);
  EXPECT_EQ(first.pixels, second.pixels);
  const HeadMaps a = makeHeadRelief(atlas(), look), b = makeHeadRelief(atlas(), look);
  for (std::size_t i = 1; i < kHeadMapCount; ++i) EXPECT_EQ(a.images.at(i).pixels, b.images.at(i).pixels) << i;
  look.seed = 2;
  EXPECT_NE(makeHeadAlbedo(atlas(), look).pixels, first.pixels);
}

TEST_F(SkinMaps, NormalsAreTheSlopesOfTheDisplacement) {
  Look look;
  look.age = 75.0F;
  const HeadMaps maps = makeHeadRelief(atlas(), look);
  const Image& normal = maps.images.at(static_cast<std::size_t>(HeadMap::Normal));
  const Image& height = maps.images.at(static_cast<std::size_t>(HeadMap::Displacement));
  const auto size = static_cast<std::size_t>(atlas().size);
  double product = 0.0, ofNormals = 0.0, ofHeights = 0.0, error = 0.0;
  for (std::size_t y = 1; y + 1 < size; ++y)
    for (std::size_t x = 1; x + 1 < size; ++x) {
      const std::size_t i = y * size + x;
      bool inside = true;
      for (const std::size_t n : {i, i - 1, i + 1, i - size, i + size}) inside = inside && atlas().covered[n] == 2;
      const float across = glm::distance(atlas().rest[i + 1], atlas().rest[i - 1]);
      const float along = glm::distance(atlas().rest[i + size], atlas().rest[i - size]);
      if (!inside || std::max(across, along) > 6.0F * atlas().millimetresPerTexel) continue;
      const double mm = static_cast<double>(kHeadReliefMm);
      const glm::dvec2 slope(mm * (value16(height, i + 1) - value16(height, i - 1)) / static_cast<double>(across),
                             mm * (value16(height, i - size) - value16(height, i + size)) / static_cast<double>(along));
      const glm::dvec3 n =
          2.0 * glm::dvec3(value16(normal, 3 * i), value16(normal, 3 * i + 1), value16(normal, 3 * i + 2)) - 1.0;
      ASSERT_NEAR(glm::length(n), 1.0, 1e-3);
      ASSERT_GT(n.z, 0.3);
      const glm::dvec2 read(-n.x / n.z, -n.y / n.z);
      product += glm::dot(read, slope);
      ofNormals += glm::dot(read, read);
      ofHeights += glm::dot(slope, slope);
      error = std::max(error, glm::length(read - slope));
    }
  EXPECT_GT(ofHeights, 0.0);
  EXPECT_GT(product / std::sqrt(ofNormals * ofHeights), 0.999);
  EXPECT_LT(error, 0.01);
}

TEST_F(SkinMaps, AgeDeepensLinesAndTheWetPartsShine) {
  const HeadRegions regions;
  const auto deepest = [&](float age) {
    Look look;
    look.age = age;
    const HeadMaps maps = makeHeadRelief(atlas(), look);
    const Image& height = maps.images.at(static_cast<std::size_t>(HeadMap::Displacement));
    double least = 0.5;
    for (std::size_t i = 0; i < atlas().rest.size(); ++i)
      if (atlas().covered[i] == 2 && regions.at(atlas().rest[i])[HeadRegion::Forehead] > 0.8F)
        least = std::min(least, value16(height, i));
    return (0.5 - least) * static_cast<double>(kHeadReliefMm);
  };
  const double young = deepest(20.0F), old = deepest(80.0F);
  EXPECT_LT(young, 0.15);
  EXPECT_GT(old, 0.2);
  EXPECT_LT(old, 0.8);
  SkinPlace place;
  place.regions.of[static_cast<std::size_t>(HeadRegion::LidMargin)] = 1.0F;
  EXPECT_LT(skinRoughness(place, Look{}), 0.3F);
  EXPECT_GT(skinRoughness(SkinPlace{}, Look{}), 0.4F);
}

TEST_F(SkinMaps, RegionsArePainted) {
  const Image lips = makeHeadRegion(atlas(), HeadRegion::Lips);
  const HeadRegions regions;
  for (std::size_t i = 0; i < atlas().rest.size(); ++i) {
    const double wanted =
        atlas().covered[i] == 0 ? 0.0 : 255.0 * static_cast<double>(regions.at(atlas().rest[i])[HeadRegion::Lips]);
    ASSERT_NEAR(std::to_integer<int>(lips.pixels[i]), wanted, 0.51);
  }
}

TEST_F(SkinMaps, EarsAreThinTheSkullIsThickAndFoldsAreHidden) {
  const std::shared_ptr<const Head> head = builtinHead(HeadLevel::Low);
  const Image thickness = makeHeadBaked(*head, HeadMap::Thickness, atlas().size);
  const Image occlusion = makeHeadBaked(*head, HeadMap::Occlusion, atlas().size);
  ASSERT_FALSE(thickness.pixels.empty());
  const HeadRegions regions;
  struct Sum {
    double thickness = 0.0, open = 0.0, count = 0.0;
  };
  Sum lobe, skull, canthus;
  for (std::size_t i = 0; i < atlas().rest.size(); ++i) {
    if (atlas().covered[i] != 2) continue;
    const glm::vec3 p = atlas().rest[i];
    const RegionWeights at = regions.at(p);
    Sum* of = nullptr;
    if (at[HeadRegion::Ear] > 0.9F && p.y < -30.0F) of = &lobe;
    if (p.y > 90.0F) of = &skull;
    if (at[HeadRegion::Caruncle] > 0.3F) of = &canthus;
    if (of == nullptr) continue;
    of->thickness += static_cast<double>(kHeadThickestMm) * value16(thickness, i);
    of->open += std::to_integer<int>(occlusion.pixels[i]) / 255.0;
    of->count += 1.0;
  }
  EXPECT_LT(lobe.thickness / lobe.count, 8.0);
  EXPECT_GT(lobe.thickness / lobe.count, 2.0);
  EXPECT_NEAR(skull.thickness / skull.count, static_cast<double>(kHeadThickestMm), 0.01);
  EXPECT_GT(skull.open / skull.count, 0.99);
  EXPECT_LT(canthus.open / canthus.count, 0.8);
}

TEST(SkinDetail, RepeatsAndIsAsRoughAsSkin) {
  const Image tile = makeSkinDetail();
  const auto size = static_cast<std::size_t>(tile.width);
  const auto normal = [&](std::size_t x, std::size_t y) {
    glm::dvec3 n;
    for (std::size_t c = 0; c < 3; ++c)
      n[static_cast<int>(c)] = std::to_integer<int>(tile.pixels[3 * (y * size + x) + c]) / 127.5 - 1.0;
    return n;
  };
  // Over the border it is as smooth as inside.
  const auto step = [&](std::size_t x) {
    double sum = 0.0;
    for (std::size_t y = 0; y < size; ++y) sum += glm::distance(normal(x, y), normal((x + 1) % size, y));
    return sum / static_cast<double>(size);
  };
  double inside = 0.0;
  for (std::size_t x = 100; x < 120; ++x) inside += step(x) / 20.0;
  EXPECT_NEAR(step(size - 1) / inside, 1.0, 0.5);
  double slope2 = 0.0;
  for (std::size_t y = 0; y < size; ++y)
    for (std::size_t x = 0; x < size; ++x) {
      const glm::dvec3 n = normal(x, y);
      ASSERT_GT(n.z, 0.3);
      slope2 += (n.x * n.x + n.y * n.y) / (n.z * n.z) / static_cast<double>(size * size);
    }
  EXPECT_GT(std::sqrt(slope2), 0.05);
  EXPECT_LT(std::sqrt(slope2), 0.35);
}

}  // namespace
}  // namespace dermis
