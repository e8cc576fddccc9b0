#include "core/builtin/default_look.h"

#include <array>
#include <optional>

#include "core/builtin/head/head.h"
#include "core/builtin/head/head_look.h"
#include "core/scene/primitives.h"

namespace dermis {
namespace {

constexpr std::array<std::string_view, 6> kModels = {"head", "head-low", "head-high", "default", "sphere", "plane"};

/// At the default look's sizes on screen an arc of 1/160 of the circle departs from the true outline by under 0.1
/// pixel.
constexpr int kTrioSegments = 160;

Material skinMaterial() {
  Material material;
  material.name = "Fair skin";
  material.model = ShadingModel::Skin;
  material.parameters.baseAlbedo = {{0.80F, 0.52F, 0.41F}};
  material.parameters.specularPerceptualRoughness = 0.40F;
  return material;
}

Material eyeMaterial() {
  Material material;
  material.name = "Blue-green eye";
  material.model = ShadingModel::Eye;
  material.parameters.specularIor = 1.376F;
  material.parameters.specularPerceptualRoughness = 0.05F;
  material.parameters.specularLobeScale = {1.0F, 1.0F};
  material.parameters.eyeIrisColor = {{0.07F, 0.14F, 0.17F}};
  material.parameters.eyeLimbusDarkness = 0.7F;
  return material;
}

Material goldMaterial() {
  Material material;
  material.name = "Gold";
  material.model = ShadingModel::MetallicRoughness;
  material.parameters.baseAlbedo = {{1.00F, 0.71F, 0.29F}};
  material.parameters.baseMetallic = 1.0F;
  material.parameters.specularPerceptualRoughness = 0.22F;
  return material;
}

Model trio() {
  struct Ball {
    std::string_view slot;
    Material material;
    float radius;
    glm::vec3 centre;
    glm::vec3 rotateDegrees;
  };
  // Scene units of 100 mm. All three rest on the plane y = −1.
  const std::array<Ball, 3> balls = {{
      {"skin", skinMaterial(), 1.0F, {0.0F, 0.0F, 0.0F}, {0.0F, 0.0F, 0.0F}},
      {"eye", eyeMaterial(), 0.58F, {-1.42F, -0.42F, 0.62F}, {0.0F, 0.0F, 0.0F}},
      {"gold", goldMaterial(), 0.58F, {1.42F, -0.42F, 0.62F}, {0.0F, 0.0F, 0.0F}},
  }};
  Model model;
  const Model sphere = makeSphere(kTrioSegments);
  for (const Ball& ball : balls) {
    Model copy = sphere;
    copy.slots.front() = {std::string(ball.slot), ball.material};
    appendModel(model, copy, {glm::vec3(ball.radius), ball.rotateDegrees, ball.centre});
  }
  return model;
}

}  // namespace

std::span<const std::string_view> builtinModels() { return kModels; }

Result<Model> builtinModel(std::string_view name) {
  if (name == "default") return trio();
  if (name == "sphere") return makeSphere();
  if (name == "plane") return makePlane();
  if (const std::optional<HeadLevel> level = headLevel(name)) return builtinHead(*level)->model;
  return inputError("there is no built-in model \"" + std::string(name) +
                    "\"; choose head, head-low, head-high, default, sphere or plane");
}

Scene defaultLook() {
  Scene scene;
  scene.name = "Default look";
  scene.model.builtin = "head";
  for (const ModelSlot& slot : headSlots()) scene.materials[slot.name].material = slot.imported;
  scene.environment.builtin = "studio";
  Camera camera;
  camera.position = {0.20F, -0.01F, 0.98F};
  camera.target = {0.0F, -0.028F, -0.02F};
  camera.verticalFovDegrees = 21.0F;
  scene.camera = camera;
  return scene;
}

}  // namespace dermis
