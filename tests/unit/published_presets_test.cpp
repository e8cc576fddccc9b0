// The numbers of the built-in presets, worked out again from the coefficients that were published.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <glm/glm.hpp>

#include "core/builtin/maps.h"
#include "core/io/asset_loader.h"
#include "core/material/builtin_presets.h"

namespace dermis {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

Material builtin(const std::string& id) {
  Warnings warnings;
  const Result<Material> material = loadBuiltinPreset(id, warnings);
  EXPECT_TRUE(material) << id;
  EXPECT_THAT(warnings, IsEmpty()) << id;
  return material.value_or(Material{});
}

/// Jensen et al. 2001, "A Practical Model for Subsurface Light Transport", figure 5: reduced scattering and absorption
/// in 1/mm, diffuse reflectance.
struct Measured {
  glm::dvec3 scattering, absorption, reflectance;
  [[nodiscard]] glm::dvec3 diffuseMeanFreePath() const {
    return 1.0 / glm::sqrt(3.0 * absorption * (absorption + scattering));
  }
};
const Measured kSkin1{{0.74, 0.88, 1.01}, {0.032, 0.17, 0.48}, {0.44, 0.22, 0.13}};
const Measured kSkin2{{1.09, 1.59, 1.79}, {0.013, 0.070, 0.145}, {0.63, 0.44, 0.34}};
const Measured kMarble{{2.19, 2.62, 3.00}, {0.0021, 0.0041, 0.0071}, {0.83, 0.79, 0.75}};
const Measured kWholeMilk{{2.55, 3.21, 3.77}, {0.0011, 0.0024, 0.014}, {0.91, 0.88, 0.76}};

void expectLengths(const Material& material, const glm::dvec3& mm, double relative) {
  EXPECT_EQ(material.parameters.subsurfaceRadiusReading, RadiusReading::DiffuseMeanFreePath);
  for (int c = 0; c < 3; ++c)
    EXPECT_NEAR(static_cast<double>(material.parameters.subsurfaceRadiusMm[c]), mm[c], relative * mm[c])
        << material.name << " channel " << c;
}

TEST(PublishedPresets, SkinTonesHaveTheLengthsOfTheMeasuredSkins) {
  for (const char* tone : {"i", "ii", "iii"})
    expectLengths(builtin(std::string("skin_tone_") + tone), kSkin2.diffuseMeanFreePath(), 0.003);
  for (const char* tone : {"iv", "v", "vi"})
    expectLengths(builtin(std::string("skin_tone_") + tone), kSkin1.diffuseMeanFreePath(), 0.005);
  expectLengths(Material{}, kSkin1.diffuseMeanFreePath(), 0.005);
}

TEST(PublishedPresets, MarbleAndMilkAreTheMeasuredOnes) {
  const std::pair<const char*, Measured> rows[] = {{"marble", kMarble}, {"milk", kWholeMilk}};
  for (const auto& [id, measured] : rows) {
    const Material material = builtin(id);
    expectLengths(material, measured.diffuseMeanFreePath(), 0.005);
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(static_cast<double>(material.parameters.baseAlbedo.rgb[c]), measured.reflectance[c], 1e-6) << id;
  }
  EXPECT_EQ(builtin("marble").parameters.specularIor, 1.5F);
  EXPECT_EQ(builtin("milk").parameters.specularIor, 1.3F);
}

/// Single-scattering albedo of a medium of this surface albedo (Chiang et al. 2016, "Practical and Controllable
/// Subsurface Scattering for Production Path Tracing", eq. 1), and the surface albedo that gives it.
double scatteringAlbedo(double a) { return 1.0 - std::exp(-5.09406 * a + 2.61188 * a * a - 4.31805 * a * a * a); }
double surfaceAlbedo(double scattering) {
  double low = 0.0, high = 1.0;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (scatteringAlbedo(middle) < scattering ? low : high) = middle;
  }
  return low;
}

/// Skin tone I with another share of blood.
void expectBlood(const char* id, double share) {
  // Molar extinction of haemoglobin in 1/cm per mole/litre (Prahl, tabulated from Gratzer and Kollias) at 620, 550, 460
  // nm.
  const glm::dvec3 oxygenated(942.0, 43016.0, 44480.0);
  const glm::dvec3 without(6509.6, 53412.0, 23388.8);
  const glm::dvec3 bloodPerMm = std::log(10.0) * (0.75 * oxygenated + 0.25 * without) * (150.0 / 64500.0) / 10.0;
  const MaterialParameters tone = builtin("skin_tone_i").parameters;
  const MaterialParameters changed = builtin(id).parameters;
  for (int c = 0; c < 3; ++c) {
    const double alpha = scatteringAlbedo(static_cast<double>(tone.baseAlbedo.rgb[c]));
    const double path = static_cast<double>(tone.subsurfaceRadiusMm[c]) * std::sqrt(3.0 * (1.0 - alpha));
    const double scattering = alpha / path;
    const double absorption = (1.0 - alpha) / path + share * bloodPerMm[c];
    EXPECT_NEAR(static_cast<double>(changed.baseAlbedo.rgb[c]), surfaceAlbedo(scattering / (scattering + absorption)),
                1e-3)
        << id << " channel " << c;
    const double length = 1.0 / std::sqrt(3.0 * absorption * (absorption + scattering));
    EXPECT_NEAR(static_cast<double>(changed.subsurfaceRadiusMm[c]), length, 5e-3 * length) << id << " channel " << c;
  }
}

TEST(PublishedPresets, FlushedAndPaleHaveMoreAndLessBlood) {
  expectBlood("skin_flushed", 0.003);
  expectBlood("skin_pale_thin", -0.001);
}

TEST(PublishedPresets, EachSaysWhereItsNumbersComeFrom) {
  for (const char* id : {"marble", "milk", "skin_tone_i", "skin_tone_vi"})
    EXPECT_THAT(builtin(id).metadata.at("notes").get<std::string>(), HasSubstr("Jensen et al. 2001")) << id;
  for (const char* id : {"skin_elderly", "skin_freckled", "wax", "jade"})
    EXPECT_THAT(builtin(id).metadata.at("notes").get<std::string>(),
                testing::ContainsRegex("[Cc]hosen by eye|are chosen by eye"))
        << id;
}

TEST(PublishedPresets, FrecklesAreSpotsOnAnUntouchedGroundAndTile) {
  const auto image = builtinMap("freckles");
  ASSERT_NE(image, nullptr);
  ASSERT_EQ(image->pixels.size(), image->rowBytes() * static_cast<std::size_t>(image->height));
  EXPECT_EQ(builtinMap("moles"), nullptr);
  const auto at = [&](int x, int y, int c) {
    return std::to_integer<int>(
        image->pixels[static_cast<std::size_t>(y) * image->rowBytes() + static_cast<std::size_t>(3 * x + c)]);
  };
  int untouched = 0, spots = 0, seam = 0, inside = 0;
  for (int y = 0; y < image->height; ++y) {
    for (int x = 0; x < image->width; ++x) {
      EXPECT_GE(at(x, y, 0), at(x, y, 1));  // melanin takes most of the blue
      EXPECT_GE(at(x, y, 1), at(x, y, 2));
      untouched += at(x, y, 1) >= 250 ? 1 : 0;
      spots += at(x, y, 1) < 235 ? 1 : 0;  // a sixth of the light is gone
    }
    seam = std::max(seam, std::abs(at(image->width - 1, y, 1) - at(0, y, 1)));
    for (int x = 0; x + 1 < image->width; ++x) inside = std::max(inside, std::abs(at(x + 1, y, 1) - at(x, y, 1)));
  }
  const int texels = image->width * image->height;
  EXPECT_GT(untouched, texels / 2);
  EXPECT_GT(spots, texels / 100);
  EXPECT_LT(spots, texels / 10);
  EXPECT_LE(seam, inside);
}

TEST(PublishedPresets, TheFreckledPresetFindsItsMapWithoutAFile) {
  const Material material = builtin("skin_freckled");
  Warnings warnings;
  const auto map = resolveTexture(material.texture(TextureSlot::Albedo).path, {}, warnings);
  ASSERT_TRUE(map) << map.error().message;
  EXPECT_EQ((*map)->channels, 3);
  const auto missing = resolveTexture("builtin:moles", {}, warnings);
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().kind, Error::Kind::Input);
}

}  // namespace
}  // namespace dermis
