// The edge of a half-lit plane against the profile's own integral, whatever the resolution, the angle and the camera.
#include <cmath>

#include "gpu/subsurface_support.h"

namespace dermis::test {
namespace {

Material gaussianSkin() {
  Material material = bareSkin();
  material.parameters.subsurfaceProfile = DiffusionFamily::Gaussians;
  return material;
}
DiffusionProfile profileOf(const Material& material) { return DiffusionProfile::of(material, glm::vec3(0.5F)); }

class SubsurfaceEdge : public SubsurfaceTest {
 protected:
  static constexpr double kReachMm = 3.5;
  static constexpr double kWidthMm = 20.0;

  double disc(const ResolvedScene& scene, const Material& material, double mmPerPixel, const std::string& name) {
    const Image picture = still(scene, 32);
    return errorOfEdge(acrossTheMiddle(picture, mmPerPixel), profileOf(material), kReachMm, mmPerPixel, "disc_" + name);
  }
  double separable(const ResolvedScene& scene, const Material& material, double mmPerPixel, const std::string& name) {
    const Image picture = moving(scene);
    return errorOfEdge(acrossTheMiddle(picture, mmPerPixel), profileOf(material), kReachMm, 0.0, "separable_" + name);
  }
};

TEST_F(SubsurfaceEdge, BothFamiliesAtThreeResolutions) {
  for (const auto& [family, material] : {std::pair<std::string, Material>{"burley", bareSkin()},
                                         std::pair<std::string, Material>{"gaussians", gaussianSkin()}})
    for (const int size : {160, 220, 320}) {
      m_size = {size, size};
      const std::string name = family + "_" + std::to_string(size);
      const ResolvedScene scene = stepScene(material, static_cast<float>(kWidthMm));
      EXPECT_LE(disc(scene, material, kWidthMm / size, name), 0.005) << name;
      EXPECT_LE(separable(scene, material, kWidthMm / size, name), 0.02) << name;
    }
}

// The edge runs along the other axis.
TEST_F(SubsurfaceEdge, Upright) {
  m_size = {160, 160};
  ResolvedScene scene = stepScene(bareSkin(), static_cast<float>(kWidthMm));
  scene.camera.up = {-1.0F, 0.0F, 0.0F};
  const auto upright = [&](const Image& image) {
    Image turned = image;
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x) {
        const glm::vec4 value = pixel(image, y, image.height - 1 - x);
        std::memcpy(turned.pixels.data() + (static_cast<std::size_t>(y * image.width + x)) * 16, &value, 16);
      }
    // Whichever way round: the lit half on the right.
    return turned;
  };
  for (const bool isMoving : {false, true}) {
    Image picture = upright(isMoving ? moving(scene) : still(scene, 32));
    auto points = acrossTheMiddle(picture, kWidthMm / 160);
    if (points.front().colour.r > points.back().colour.r)
      for (EdgePoint& point : points) point.x = -point.x;
    EXPECT_LE(errorOfEdge(points, profileOf(bareSkin()), kReachMm, isMoving ? 0.0 : kWidthMm / 160,
                          isMoving ? "separable_upright" : "disc_upright"),
              isMoving ? 0.02 : 0.005);
  }
}

// Lengths stay millimetres on a surface seen at 45°, tilted across the edge and along it.
TEST_F(SubsurfaceEdge, SeenAtFortyFiveDegrees) {
  m_size = {200, 200};
  for (const bool acrossEdge : {true, false}) {
    ResolvedScene scene = stepScene(bareSkin(), static_cast<float>(kWidthMm));
    const float a = 5.0F * std::sqrt(0.5F);
    scene.camera.position = acrossEdge ? glm::vec3(a, 0.0F, a) : glm::vec3(0.0F, a, a);
    const double mmPerPixel = kWidthMm / m_size.x * (acrossEdge ? std::sqrt(2.0) : 1.0);
    const std::string name = acrossEdge ? "tilted_across" : "tilted_along";
    EXPECT_LE(disc(scene, bareSkin(), mmPerPixel, name), 0.005) << name;
    EXPECT_LE(separable(scene, bareSkin(), mmPerPixel, name), 0.02) << name;
  }
}

// The width between a quarter and three quarters, at 45° and at half the resolution, within 3 %.
TEST_F(SubsurfaceEdge, WidthsAreMillimetres) {
  const auto width = [](const std::vector<EdgePoint>& points, int channel) {
    const auto crossing = [&](double level) {
      for (std::size_t i = 1; i < points.size(); ++i) {
        const double low = points[i - 1].colour[channel], high = points[i].colour[channel];
        if (low < level && high >= level)
          return points[i - 1].x + (level - low) / (high - low) * (points[i].x - points[i - 1].x);
      }
      return 0.0;
    };
    return crossing(0.9) - crossing(0.1);
  };
  Material material = bareSkin();
  material.parameters.subsurfaceRadiusMm = {0.6F, 0.5F, 0.4F};
  const DiffusionProfile profile = profileOf(material);
  const float a = 5.0F * std::sqrt(0.5F);
  for (const int size : {240, 120})
    for (const bool tilted : {false, true}) {
      m_size = {size, size};
      ResolvedScene scene = stepScene(material, 36.0F);
      if (tilted) scene.camera.position = {a, 0.0F, a};
      const auto points = acrossTheMiddle(still(scene, 32), 36.0 / size * (tilted ? std::sqrt(2.0) : 1.0), 16);
      for (int c = 0; c < 3; ++c) {
        double exact = 0.0;  // where the profile's own edge passes a tenth, by halving
        double low = 0.0, high = 20.0;
        for (int i = 0; i < 50; ++i) {
          exact = 0.5 * (low + high);
          (profile.edgeSpread(-exact)[c] > 0.1 ? low : high) = exact;
        }
        const double seen = width(points, c);
        std::printf("  %d pixels, %s, channel %d: %.3f mm, exactly %.3f\n", size, tilted ? "45 degrees" : "frontal", c,
                    seen, 2.0 * exact);
        EXPECT_NEAR(seen, 2.0 * exact, 0.03 * 2.0 * exact) << size << tilted << c;
      }
    }
}

TEST_F(SubsurfaceEdge, PerspectiveOfAnyAngle) {
  m_size = {160, 160};
  for (const float degrees : {10.0F, 60.0F}) {
    ResolvedScene scene = stepScene(bareSkin(), static_cast<float>(kWidthMm));
    scene.camera.orthographicHeight.reset();
    scene.camera.verticalFovDegrees = degrees;
    scene.camera.position = {0.0F, 0.0F, 1.0F / std::tan(glm::radians(0.5F * degrees))};
    const std::string name = "perspective_" + std::to_string(static_cast<int>(degrees));
    EXPECT_LE(disc(scene, bareSkin(), kWidthMm / m_size.x, name), 0.005) << name;
    EXPECT_LE(separable(scene, bareSkin(), kWidthMm / m_size.x, name), 0.02) << name;
  }
}

// A radius under a pixel fades to Lambert: what a pixel's light does within the pixel is not known, which near the edge
// costs at most 2 % of the plateau and vanishes with the radius. Without any length the picture is the one without
// diffusion.
TEST_F(SubsurfaceEdge, UnderAPixel) {
  m_size = {60, 60};
  for (const float scale : {0.5F, 0.1F, 0.01F}) {
    Material material = bareSkin();
    material.parameters.subsurfaceScale = scale;
    const ResolvedScene scene = stepScene(material, static_cast<float>(kWidthMm));
    EXPECT_LE(disc(scene, material, kWidthMm / 60, "scale_" + std::to_string(scale)), scale < 0.05F ? 0.002 : 0.02)
        << scale;
  }
  Material none = bareSkin();
  none.parameters.subsurfaceScale = 0.0F;
  Material lambert = bareSkin();
  lambert.parameters.subsurfaceWeight = 0.0F;
  const Image a = still(stepScene(none, 24.0F), 4), b = still(stepScene(lambert, 24.0F), 4);
  EXPECT_LE(largestDifference(a, b), 1e-4F);
  EXPECT_LE(largestDifference(moving(stepScene(none, 24.0F)), moving(stepScene(lambert, 24.0F))), 2e-3F);
}

// A profile that reaches over half the picture: 24 d of the widest channel are 54 of 60 mm; most of it 20.
TEST_F(SubsurfaceEdge, HalfTheScreen) {
  m_size = {120, 120};
  Material material = bareSkin();
  material.parameters.subsurfaceRadiusMm = {2.25F, 1.0F, 0.5F};
  ResolvedScene scene = stepScene(material, 120.0F);
  scene.camera.orthographicHeight = 1.0F;  // the middle 60 mm
  const Image picture = still(scene, 32);
  const auto points = acrossTheMiddle(picture, 0.5, 16);
  // Light from beyond the picture's border is not seen: near the middle that misses little.
  EXPECT_LE(errorOfEdge(points, profileOf(material), 8.0, 0.5, "disc_half_the_screen"), 0.02);
}

}  // namespace
}  // namespace dermis::test
