// The published shaders on a sphere, pixel by pixel against their equations in double precision.
#include <cmath>

#include "gpu/sphere_fixture.h"

namespace dermis::test {
namespace {

using reference::Arriving;
using reference::Surroundings;

const glm::vec3 kBase(1.0F, 0.7F, 0.5F), kAlongX(0.3F, -0.2F, 0.1F), kAlongY(0.4F, 0.3F, -0.2F),
    kAlongZ(-0.2F, 0.1F, 0.15F);

std::shared_ptr<const EnvironmentImages> slopedEnvironment() {
  static const auto kMade = linearEnvironment(kBase, kAlongX, kAlongY, kAlongZ);
  return kMade;
}
Surroundings slopedSurroundings() {
  return reference::linearSurroundings(dvec3(kBase), dvec3(kAlongX), dvec3(kAlongY), dvec3(kAlongZ));
}

Light pointLight(const glm::vec3& position, const glm::vec3& color, float intensity) {
  Light light;
  light.position = position;
  light.color = color;
  light.intensity = intensity;
  light.shadow = false;
  return light;
}

std::vector<Light> fourLights() {
  return {pointLight({2, 2, 3}, {1, 0.9F, 0.8F}, 12), pointLight({-3, 0.5F, 2}, {0.4F, 0.6F, 1}, 9),
          pointLight({0, -2.5F, 2.5F}, {0.9F, 0.3F, 0.3F}, 6), pointLight({0.5F, 1.2F, -3}, {1, 1, 1}, 20)};
}

std::vector<Arriving> arriving(const std::vector<Light>& lights, const dvec3& point) {
  std::vector<Arriving> result;
  for (const Light& light : lights) {
    const dvec3 offset = dvec3(light.position) - point;
    const double squared = glm::dot(offset, offset);
    result.push_back(
        {offset / std::sqrt(squared), dvec3(light.color) * static_cast<double>(light.intensity) / squared});
  }
  return result;
}

struct Variant {
  std::string name;
  float metallic, roughness, specular;
};
const std::vector<Variant> kVariants = {{"skin", 0.0F, 0.5F, 1.0F},
                                        {"smooth", 0.0F, 0.2F, 0.5F},
                                        {"rough half metal", 0.5F, 0.8F, 0.3F},
                                        {"metal", 1.0F, 0.35F, 0.7F}};

class SpherePublished : public SphereTest {
 protected:
  static void expectThesis(const Variant& variant, const std::vector<Light>& lights, const Surroundings* around,
                           const std::shared_ptr<const EnvironmentImages>& environment, const Camera& camera,
                           const std::string& what) {
    Look look;
    look.material.model = ShadingModel::Thesis;
    MaterialParameters& p = look.material.parameters;
    p.baseMetallic = variant.metallic;
    p.specularPerceptualRoughness = variant.roughness;
    p.specularIntensity = variant.specular;
    look.lights = lights;
    look.environment = environment;
    look.camera = camera;
    reference::ThesisMaterial m;
    m.albedo = dvec3(p.baseAlbedo.rgb);
    m.metallic = static_cast<double>(variant.metallic);
    m.roughness = static_cast<double>(variant.roughness);
    m.specular = static_cast<double>(variant.specular);
    m.sssColor = dvec3(p.thesisSssColor.rgb);
    m.sssScale = static_cast<double>(p.thesisSssScale);
    m.thickness = static_cast<double>(p.thesisThickness);
    const reference::SplitSumCurve table = reference::thesisSplitSum(m.roughness);
    expectSphere(
        look,
        [&](const dvec3& n, const dvec3& v) {
          return reference::thesisRadiance(m, table, n, v, arriving(lights, n), around);
        },
        what + ", " + variant.name);
  }
};

TEST_F(SpherePublished, ThesisUnderOneToFourLights) {
  const std::vector<Light> all = fourLights();
  for (std::size_t count = 1; count <= all.size(); ++count) {
    const std::vector<Light> lights(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(count));
    expectThesis(kVariants[0], lights, nullptr, nullptr, perspectiveCamera(), std::to_string(count) + " lights");
  }
  for (const Variant& variant : kVariants) {
    expectThesis(variant, all, nullptr, nullptr, perspectiveCamera(), "perspective");
    expectThesis(variant, all, nullptr, nullptr, orthographicCamera(), "orthographic");
  }
}

TEST_F(SpherePublished, ThesisInAWhiteWorld) {
  static const auto kWhite = constantEnvironment(glm::vec3(1.0F));
  const Surroundings around = reference::constantSurroundings(dvec3(1.0));
  for (const Variant& variant : kVariants) {
    expectThesis(variant, {}, &around, kWhite, perspectiveCamera(), "white world");
    expectThesis(variant, fourLights(), &around, kWhite, orthographicCamera(), "white world and lights");
  }
}

TEST_F(SpherePublished, ThesisInASlopedWorld) {
  const Surroundings around = slopedSurroundings();
  for (const Variant& variant : kVariants)
    expectThesis(variant, {}, &around, slopedEnvironment(), perspectiveCamera(), "sloped world");
}

TEST_F(SpherePublished, Reflection) {
  const Surroundings around = slopedSurroundings();
  for (const Camera& camera : {perspectiveCamera(), orthographicCamera()}) {
    Look look;
    look.material.model = ShadingModel::Reflection;
    look.environment = slopedEnvironment();
    look.camera = camera;
    expectSphere(
        look, [&](const dvec3& n, const dvec3& v) { return reference::labReflection(n, v, around); }, "reflection");
  }
}

TEST_F(SpherePublished, MicrofacetLabWithEachGeometryTerm) {
  const Surroundings around = slopedSurroundings();
  using reference::LabTerm;
  const dvec3 gold(glm::vec3(1.00F, 0.71F, 0.29F)), silver(glm::vec3(0.95F, 0.93F, 0.88F)), glass(glm::vec3(0.05F));
  for (const auto& [term, word] :
       {std::pair{LabTerm::One, LabGeometry::One}, std::pair{LabTerm::Smith, LabGeometry::Smith},
        std::pair{LabTerm::CookTorrance, LabGeometry::CookTorrance}})
    for (const auto& [f0, roughness] : {std::pair{gold, 0.25F}, std::pair{silver, 0.5F}, std::pair{glass, 0.1F}}) {
      Look look;
      look.material.model = ShadingModel::MicrofacetLab;
      look.material.parameters.specularF0 = Colour{glm::vec3(f0)};
      look.material.parameters.specularPerceptualRoughness = roughness;
      look.material.parameters.microfacetLabGeometry = word;
      look.environment = slopedEnvironment();
      look.camera = perspectiveCamera();
      expectSphere(
          look,
          [&, f = f0, r = static_cast<double>(roughness), t = term](const dvec3& n, const dvec3& v) {
            return reference::labMicrofacet(f, r, t, n, v, around);
          },
          "microfacet_lab, geometry " + std::to_string(static_cast<int>(term)) + ", roughness " +
              std::to_string(roughness));
    }
}

}  // namespace
}  // namespace dermis::test
