#include "gpu/shadow_support.h"

#include <cmath>

#include "core/scene/primitives.h"

namespace dermis::test {

Model quad(const dvec3& a, const dvec3& b, const dvec3& c, const dvec3& d, const std::string& name) {
  Model model;
  const glm::vec3 normal(glm::normalize(glm::cross(b - a, c - a)));
  const glm::vec3 tangent(glm::normalize(b - a));
  for (const dvec3& corner : {a, b, c, d}) {
    model.positions.emplace_back(corner);
    model.normals.push_back(normal);
    model.tangents.emplace_back(tangent, 1.0F);
    model.bounds.grow(glm::vec3(corner));
  }
  model.uvs = {{0.0F, 0.0F}, {1.0F, 0.0F}, {1.0F, 1.0F}, {0.0F, 1.0F}};
  model.indices = {0, 1, 2, 0, 2, 3};
  model.parts = {{0, 0, 6}};
  model.slots = {{name, {}}};
  model.millimetresPerUnit = 100.0F;
  return model;
}

Model ground() { return quad({-2, -2, 0}, {2, -2, 0}, {2, 2, 0}, {-2, 2, 0}); }

Model awning(double height) {
  return quad({-1.5, -1, height}, {-0.6, -1, height}, {-0.6, 1, height}, {-1.5, 1, height}, "awning");
}

Model both(Model model, const Model& other) {
  appendModel(model, other);
  return model;
}

Material chalk() {
  Material material = materialOf(ShadingModel::MetallicRoughness);
  material.parameters.baseAlbedo.rgb = glm::vec3(1.0F);
  material.parameters.specularPerceptualRoughness = 1.0F;
  material.parameters.metallicRoughnessDoubleSided = true;
  return material;
}

ResolvedScene litFromAbove(Model model, const Light& light, const glm::vec2& centre, float half) {
  ResolvedScene scene = sceneOf(std::move(model), chalk(), glm::vec3(0.0F));
  scene.scene.lights = {light};
  scene.camera.position = {centre, 5.0F};
  scene.camera.target = {centre, 0.0F};
  scene.camera.orthographicHeight = 2.0F * half;
  return scene;
}

Light lampOf(LightType type) {
  Light light;
  light.type = type;
  light.position = {-1.2F, 0.0F, 1.1F};
  light.direction = glm::normalize(glm::vec3(1.0F, 0.1F, -1.0F));
  light.intensity = 2.0F;
  light.radiusMm = 0.01F;
  light.sizeMm = {0.01F, 0.01F};
  light.innerDegrees = 45.0F;
  light.outerDegrees = 50.0F;
  return light;
}

dvec3 towards(const Light& light, const dvec3& point) {
  if (light.type == LightType::Directional) return -glm::normalize(dvec3(light.direction));
  return glm::normalize(dvec3(light.position) - point);
}

std::vector<double> ShadowTest::arriving(ResolvedScene scene, int samples) {
  const Image shaded = still(scene, samples);
  for (Light& light : scene.scene.lights) light.shadow = false;
  const Image open = still(scene, samples);
  std::vector<double> shares;
  for (int y = 0; y < m_size.y; ++y)
    for (int x = 0; x < m_size.x; ++x) {
      const double all = static_cast<double>(pixel(open, x, y).r);
      shares.push_back(all > 1e-5 ? static_cast<double>(pixel(shaded, x, y).r) / all : -1.0);
    }
  return shares;
}

}  // namespace dermis::test
