// Area lights converge to the integral over the light: what a plane receives, how its shadows fade, what a metal
// reflects. Every reference integrates radiance over the light here, in double precision.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/scene/primitives.h"
#include "gpu/shadow_support.h"
#include "lighting/light_point.h"
#include "reference/microfacet.h"
#include "reference/quadrature.h"
#include "reference/sphere_view.h"

namespace dermis::test {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kUnitsPerMm = 0.01;

/// Lambert's, exactly: nothing is reflected at the surface, nothing goes through.
Material matte() {
  Material material = materialOf(ShadingModel::Skin);
  material.parameters.baseAlbedo.rgb = glm::vec3(1.0F);
  material.parameters.specularIntensity = 0.0F;
  material.parameters.subsurfaceWeight = 0.0F;
  material.parameters.transmissionWeight = 0.0F;
  return material;
}

/// ∫ L(y) f(direction) dω over what a point sees of the light; f holds the cosine.
template <class F>
double overLight(const Light& light, const dvec3& point, const F& f, std::size_t nodes = 24) {
  const auto u = reference::gaussLegendre(nodes);
  const dvec3 centre(light.position);
  double sum = 0.0;
  if (light.type == LightType::Sphere) {
    const double radius = static_cast<double>(light.radiusMm) * kUnitsPerMm;
    const double radiance = static_cast<double>(light.intensity) / (kPi * radius * radius);
    const dvec3 axis = glm::normalize(centre - point);
    const dvec3 x = glm::normalize(glm::cross(std::abs(axis.y) < 0.9 ? dvec3(0, 1, 0) : dvec3(1, 0, 0), axis));
    const dvec3 y = glm::cross(axis, x);
    const double distance = glm::length(centre - point);
    const double least = std::sqrt(1.0 - radius * radius / (distance * distance));
    for (const auto& a : u)
      for (std::size_t j = 0; j < 4 * nodes; ++j) {
        const double cosine = least + (1.0 - least) * a.x, sine = std::sqrt(1.0 - cosine * cosine);
        const double phi = 2.0 * kPi * (static_cast<double>(j) + 0.5) / static_cast<double>(4 * nodes);
        const dvec3 direction = cosine * axis + sine * (std::cos(phi) * x + std::sin(phi) * y);
        sum += a.weight / static_cast<double>(4 * nodes) * 2.0 * kPi * (1.0 - least) * radiance * f(direction);
      }
    return sum;
  }
  const glm::dvec2 size = glm::dvec2(light.sizeMm) * kUnitsPerMm;
  const double radiance = static_cast<double>(light.intensity) / (size.x * size.y);
  const dvec3 shines = glm::normalize(dvec3(light.direction));
  const dvec3 x = glm::normalize(glm::cross(dvec3(0, 1, 0), shines)), y = glm::cross(shines, x);
  for (const auto& a : u)
    for (const auto& b : u) {
      const dvec3 offset = centre + (a.x - 0.5) * size.x * x + (b.x - 0.5) * size.y * y - point;
      const double squared = glm::dot(offset, offset);
      const dvec3 direction = offset / std::sqrt(squared);
      const double cosine = std::max(glm::dot(-direction, shines), 0.0);
      sum += a.weight * b.weight * size.x * size.y * radiance * cosine / squared * f(direction);
    }
  return sum;
}

/// Irradiance of the ground at a point; the awning (`height` ≥ 0) stands in the way.
double onGround(const Light& light, const dvec3& point, double height, std::size_t nodes = 24) {
  return overLight(
      light, point,
      [&](const dvec3& direction) {
        if (direction.z <= 0.0) return 0.0;
        if (height >= 0.0) {
          const dvec3 at = point + direction * (height / direction.z);
          if (at.x > -1.5 && at.x < -0.6 && std::abs(at.y) < 1.0) return 0.0;
        }
        return direction.z;
      },
      nodes);
}

Light sphereLight() {
  Light light = lampOf(LightType::Sphere);
  light.radiusMm = 30.0F;
  light.position = {-1.5F, 0.0F, 1.6F};
  return light;
}
Light rectLight() {
  Light light = lampOf(LightType::Rect);
  light.sizeMm = {60.0F, 30.0F};
  light.position = {-1.5F, 0.0F, 1.6F};
  light.direction = {1.0F, 0.2F, -1.0F};
  return light;
}

class LightArea : public ShadowTest {
 protected:
  static ResolvedScene groundUnder(const Light& light, bool awninged) {
    ResolvedScene scene = litFromAbove(awninged ? both(ground(), awning(0.5)) : ground(), light);
    for (ResolvedMaterial& slot : scene.slots) slot.material = matte();
    return scene;
  }
};

TEST_F(LightArea, PlaneReceivesTheIntegral) {
  m_size = {24, 24};
  for (Light light : {sphereLight(), rectLight()}) {
    light.shadow = false;
    const Image image = still(groundUnder(light, false), 256);
    double worst = 0.0;
    for (int y = 1; y < 24; y += 5)
      for (int x = 1; x < 24; x += 5) {
        const double want = onGround(light, {across(x), -across(y), 0.0}, -1.0) / kPi;
        const double got = static_cast<double>(pixel(image, x, y).g);
        worst = std::max(worst, std::abs(got / want - 1.0));
      }
    EXPECT_LT(worst, 0.01) << "type " << static_cast<int>(light.type);
    ::testing::Test::RecordProperty("irradiance of type " + std::to_string(static_cast<int>(light.type)),
                                    std::to_string(worst) + " off at worst");
  }
}

// Across the awning's edge light fades as more of the lamp is hidden.
TEST_F(LightArea, PenumbraIsTheIntegralOfWhatIsSeen) {
  m_size = {64, 64};
  for (const Light& light : {sphereLight(), rectLight()}) {
    const Image image = still(groundUnder(light, true), 256);
    double squares = 0.0, worst = 0.0, most = 0.0;
    int between = 0;
    for (int x = 0; x < 64; ++x) {
      // What the awning itself hides from the camera ends at −0.6.
      const double want = onGround(light, {across(x), -across(32), 0.0}, 0.5, 100) / kPi;
      const double got = static_cast<double>(pixel(image, x, 32).g);
      const double open = onGround(light, {across(x), -across(32), 0.0}, -1.0) / kPi;
      most = std::max(most, open);
      if (want > 0.1 * open && want < 0.9 * open) ++between;
      squares += (got - want) * (got - want);
      worst = std::max(worst, std::abs(got - want));
    }
    const double rmse = std::sqrt(squares / 64.0) / most;
    EXPECT_GT(between, 8) << "a penumbra, type " << static_cast<int>(light.type);
    EXPECT_LT(rmse, 0.008) << "type " << static_cast<int>(light.type);
    EXPECT_LT(worst / most, 0.025) << "type " << static_cast<int>(light.type);
    ::testing::Test::RecordProperty("penumbra of type " + std::to_string(static_cast<int>(light.type)),
                                    std::to_string(rmse) + " RMSE, " + std::to_string(worst / most) + " at worst");
  }
}

/// A gold ball under the light, from the reference's lobes.
struct Ball {
  reference::Layer layer;
  explicit Ball(double roughness) : layer(dvec3(0.04), {{roughness, 1.0}}, dvec3(glm::vec3(1.0F, 0.7F, 0.3F)), 1.0) {}
  [[nodiscard]] double red(const Light& light, const reference::SpherePoint& at) const {
    return overLight(light, at.normal, [&](const dvec3& direction) {
      const double cosine = glm::dot(direction, at.normal);
      return cosine > 0.0 ? cosine * layer.brdf(at.normal, at.view, direction).x : 0.0;
    });
  }
};

class LightHighlight : public LightArea {
 protected:
  static ResolvedScene ballUnder(const Light& light, double roughness) {
    ResolvedScene scene = sceneOf(makeSphere(160), materialOf(ShadingModel::MetallicRoughness), glm::vec3(0.0F));
    MaterialParameters& p = scene.slots[0].material.parameters;
    p.baseAlbedo.rgb = {1.0F, 0.7F, 0.3F};
    p.baseMetallic = 1.0F;
    p.specularPerceptualRoughness = static_cast<float>(roughness);
    scene.scene.lights = {light};
    return scene;
  }
  static Light lamp(LightType type) {
    Light light;
    light.type = type;
    light.position = {1.2F, 1.0F, 2.0F};
    light.direction = {-1.2F, -1.0F, -2.0F};
    light.intensity = 3.0F;
    light.radiusMm = 30.0F;
    light.sizeMm = {60.0F, 40.0F};
    light.shadow = false;
    return light;
  }
  /// Largest difference from the reference over the ball's lit face, and the largest value of it.
  struct Found {
    double worst = 0.0, most = 0.0, energy = 0.0, wanted = 0.0;
  };
  Found compare(const Image& image, const ResolvedScene& scene, const Ball& ball, int step) const {
    Found found;
    for (int y = 0; y < m_size.y; y += step)
      for (int x = 0; x < m_size.x; x += step) {
        const auto at = reference::sphereUnderPixel(scene.camera, m_size.x, m_size.y, x, y);
        if (!at || glm::dot(at->normal, at->view) < 0.25) continue;
        const double want = ball.red(scene.scene.lights[0], *at);
        const double got = static_cast<double>(pixel(image, x, y).r);
        found.worst = std::max(found.worst, std::abs(got - want));
        found.most = std::max(found.most, want);
        found.energy += got;
        found.wanted += want;
      }
    return found;
  }
};

TEST_F(LightHighlight, ConvergesToTheIntegral) {
  m_size = {72, 72};
  for (const LightType type : {LightType::Sphere, LightType::Rect})
    for (const double roughness : {0.3, 0.5}) {
      const ResolvedScene scene = ballUnder(lamp(type), roughness);
      const Found found = compare(still(scene, 128), scene, Ball(roughness), 6);
      EXPECT_LT(found.worst, 0.05 * found.most) << "type " << static_cast<int>(type) << ", roughness " << roughness;
      EXPECT_NEAR(found.energy, found.wanted, 0.02 * found.wanted) << "type " << static_cast<int>(type);
      ::testing::Test::RecordProperty(
          "highlight of type " + std::to_string(static_cast<int>(type)) + " at " + std::to_string(roughness),
          std::to_string(found.worst / found.most) + " of the peak at worst");
    }
}

// One picture without samples: as wide, as bright and as strong, about.
TEST_F(LightHighlight, OneSampleIsNear) {
  m_size = {72, 72};
  for (const double roughness : {0.3, 0.5}) {
    const ResolvedScene scene = ballUnder(lamp(LightType::Sphere), roughness);
    const Found found = compare(still(scene, 1), scene, Ball(roughness), 6);
    EXPECT_LT(found.worst, 0.25 * found.most) << "roughness " << roughness;
    EXPECT_NEAR(found.energy, found.wanted, 0.1 * found.wanted) << "roughness " << roughness;
    ::testing::Test::RecordProperty("one sample at " + std::to_string(roughness),
                                    std::to_string(found.worst / found.most) + " of the peak at worst");
  }
}

// ---- the points themselves

// What the points send to a place is the integral, for places all over what they were made for and even inside the
// light's own size from it.
TEST(LightPoints, MeanIsTheIrradianceOfTheLight) {
  Light light = sphereLight();
  for (const float radius : {5.0F, 30.0F, 120.0F}) {
    light.radiusMm = radius;
    light.position = {0.0F, 0.0F, 2.0F};
    const Bounds lit{{-1.0F, -1.0F, -0.2F}, {1.0F, 1.0F, 0.2F}};
    const LightCap cap = litCap(light, 100.0F, std::span(&lit, 1));
    for (const dvec3& place : {dvec3(0.0), dvec3(0.9, 0.9, 0.1), dvec3(-0.5, 0.2, -0.2)}) {
      double sum = 0.0;
      constexpr int kCount = 1 << 14;
      for (int i = 0; i < kCount; ++i) {
        const LightPoint point = pointOf(light, 100.0F, cap, lightNumbers(i), kCount);
        const dvec3 offset = dvec3(point.position) - place;
        const double squared = glm::dot(offset, offset);
        const dvec3 l = offset / std::sqrt(squared);
        const double facing = std::max(glm::dot(dvec3(point.direction), -l), 0.0);
        sum += static_cast<double>(light.intensity * point.intensityScale) * facing * std::max(l.z, 0.0) / squared;
      }
      const double want = overLight(light, place, [](const dvec3& d) { return std::max(d.z, 0.0); });
      EXPECT_NEAR(sum / kCount / want, 1.0, 0.002) << "radius " << radius;
    }
  }
}

TEST(LightPoints, NumbersAreStratified) {
  EXPECT_EQ(lightNumbers(0, {0.5F, 0.5F}), glm::vec2(0.5F, 0.5F));
  EXPECT_NEAR(lightNumbers(0, {0.29F, 0.0F}).x, 0.29F, 1e-6F);
  for (const int start : {0, 64, 192}) {
    // Every elementary interval of 64 in a row holds one: 64 × 1, 8 × 8, 1 × 64, ….
    for (int across = 0; across <= 6; ++across) {
      std::vector<int> hits(64, 0);
      for (int i = start; i < start + 64; ++i) {
        const glm::vec2 u = lightNumbers(i);
        ASSERT_TRUE(u.x >= 0.0F && u.x < 1.0F && u.y >= 0.0F && u.y < 1.0F);
        const int column = static_cast<int>(u.x * static_cast<float>(1 << across));
        const int row = static_cast<int>(u.y * static_cast<float>(1 << (6 - across)));
        ++hits[static_cast<std::size_t>(row * (1 << across) + column)];
      }
      EXPECT_EQ(*std::max_element(hits.begin(), hits.end()), 1) << start << ", " << across;
    }
  }
}

}  // namespace
}  // namespace dermis::test
