// skin, metallic_roughness, eye and lens on a sphere, pixel by pixel against the layer's twin; and each kind of light.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "gpu/sphere_fixture.h"

namespace dermis::test {
namespace {

using reference::Arriving;
using reference::Layer;

/// The reference's view of a light at a point of the unit sphere. materials.md and interfaces.md, Conventions.
Arriving arrivingFrom(const Light& light, const dvec3& point) {
  const dvec3 radiant = dvec3(light.color) * static_cast<double>(light.intensity);
  const dvec3 travels = glm::normalize(dvec3(light.direction));
  if (light.type == LightType::Directional) return {-travels, radiant};
  const dvec3 offset = dvec3(light.position) - point;
  const double squared = glm::dot(offset, offset);
  Arriving result{offset / std::sqrt(squared), radiant / squared};
  const double cosine = glm::dot(-result.toLight, travels);
  const auto cosineOf = [](float degrees) { return std::cos(static_cast<double>(degrees) * std::numbers::pi / 180.0); };
  if (light.type == LightType::Spot) {
    const double t =
        (cosine - cosineOf(light.outerDegrees)) / (cosineOf(light.innerDegrees) - cosineOf(light.outerDegrees));
    result.irradiance *= std::pow(std::clamp(t, 0.0, 1.0), 2.0);
  }
  if (light.type == LightType::Rect) result.irradiance *= std::max(cosine, 0.0);
  return result;
}

dvec3 shadeLayer(const Layer& layer, const dvec3& albedo, const dvec3& n, const dvec3& v,
                 const std::vector<Light>& lights, const reference::Surroundings* around) {
  dvec3 sum(0.0);
  const double nDotV = glm::dot(n, v);
  for (const Light& light : lights) {
    const Arriving arriving = arrivingFrom(light, n);
    const double nDotL = glm::dot(n, arriving.toLight);
    if (nDotL <= 0.0) continue;
    sum += arriving.irradiance * nDotL *
           (layer.brdf(n, v, arriving.toLight) + layer.lampWeight(nDotL, nDotV) * albedo / std::numbers::pi);
  }
  if (around == nullptr) return sum;
  sum += layer.imageWeight(nDotV) * albedo * around->irradianceOverPi(n);
  for (std::size_t i = 0; i < layer.lobes().size(); ++i)
    sum += layer.lobeAlbedo(i, nDotV) * around->prefiltered(glm::reflect(-v, n), layer.lobes()[i].perceptualRoughness);
  return sum;
}

Light lightOf(LightType type) {
  Light light;
  light.type = type;
  light.position = {1.5F, 1.0F, 2.5F};
  light.direction = {-0.5F, -0.4F, -0.8F};
  light.color = {1.0F, 0.8F, 0.6F};
  light.intensity = type == LightType::Directional ? 3.0F : 20.0F;
  light.innerDegrees = 8.0F;
  light.outerDegrees = 22.0F;
  light.shadow = false;
  light.radiusMm = 1.0F;  // a point, nearly: light_area_test.cpp has larger ones
  light.sizeMm = {1.0F, 1.0F};
  return light;
}

class SphereLayer : public SphereTest {};

TEST_F(SphereLayer, SkinUnderEveryKindOfLight) {
  Look look;
  MaterialParameters& p = look.material.parameters;
  p.subsurfaceWeight = 0.0F;
  p.transmissionWeight = 0.0F;
  look.camera = perspectiveCamera();
  const double roughness = static_cast<double>(p.specularPerceptualRoughness);
  const Layer layer(dvec3(reference::f0FromIor(1.4)), {{roughness * 0.75, 0.15}, {roughness * 1.30, 0.85}});
  for (const LightType type :
       {LightType::Point, LightType::Directional, LightType::Spot, LightType::Sphere, LightType::Rect}) {
    look.lights = {lightOf(type)};
    expectSphere(
        look,
        [&](const dvec3& n, const dvec3& v) {
          return shadeLayer(layer, dvec3(p.baseAlbedo.rgb), n, v, look.lights, nullptr);
        },
        "skin, light " + std::to_string(static_cast<int>(type)), 0.005, 0.15, 5e-4);
  }
}

TEST_F(SphereLayer, ModelsInASlopedWorld) {
  const glm::vec3 base(0.8F, 0.9F, 1.0F), x(0.2F, 0.3F, -0.1F), y(0.3F, -0.3F, 0.2F), z(0.1F, 0.2F, 0.3F);
  const auto environment = linearEnvironment(base, x, y, z);
  const reference::Surroundings around = reference::linearSurroundings(dvec3(base), dvec3(x), dvec3(y), dvec3(z));
  const dvec3 albedo(glm::vec3(0.9F, 0.5F, 0.3F));
  Look look;
  look.environment = environment;
  look.camera = orthographicCamera();
  look.lights = {lightOf(LightType::Point)};
  MaterialParameters& p = look.material.parameters;
  p.baseAlbedo.rgb = glm::vec3(albedo);
  p.subsurfaceWeight = 0.0F;
  p.transmissionWeight = 0.0F;
  p.specularPerceptualRoughness = 0.5F;
  for (const double metallic : {0.0, 0.5, 1.0}) {
    p.baseMetallic = static_cast<float>(metallic);
    look.material.model = ShadingModel::MetallicRoughness;
    const Layer gltf(dvec3(0.04), {{0.5, 1.0}}, albedo, metallic);
    expectSphere(
        look, [&](const dvec3& n, const dvec3& v) { return shadeLayer(gltf, albedo, n, v, look.lights, &around); },
        "metallic_roughness " + std::to_string(metallic));
    look.material.model = ShadingModel::Skin;
    p.specularIntensity = 0.8F;
    const Layer skin(dvec3(reference::f0FromIor(1.4)), {{0.5 * 0.75, 0.8 * 0.15}, {0.5 * 1.3, 0.8 * 0.85}}, albedo,
                     metallic);
    expectSphere(
        look, [&](const dvec3& n, const dvec3& v) { return shadeLayer(skin, albedo, n, v, look.lights, &around); },
        "skin " + std::to_string(metallic));
  }
}

// What a lens reflects is added to what it covers of the background: here none, so only its own light and its coverage
// are left.
TEST_F(SphereLayer, LensReflectsAndCovers) {
  static const auto kWhite = constantEnvironment(glm::vec3(1.0F));
  Look look;
  look.material.model = ShadingModel::Lens;
  look.material.parameters.lensOpacity = 0.25F;
  look.environment = kWhite;
  look.camera = orthographicCamera();
  const Layer layer(dvec3(reference::f0FromIor(1.376)), {{0.02, 1.0}});
  const Picture picture = render(look);
  for (int row = 0; row < look.size; ++row)
    for (int column = 0; column < look.size; ++column) {
      const auto point = reference::sphereUnderPixel(look.camera, look.size, look.size, column, row);
      if (!point || glm::dot(point->normal, point->view) < 0.15) continue;
      const double want = layer.albedo(glm::dot(point->normal, point->view)).x;
      EXPECT_NEAR(picture.at(column, row).x, want, 0.005 * want + 1e-4) << column << ", " << row;
      EXPECT_NEAR(picture.at(column, row).w, 0.25, 1e-3) << column << ", " << row;
    }
}

}  // namespace
}  // namespace dermis::test
