// What is made in code: shapes, environments, the default look, cameras, and resolving a scene of them.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <numbers>

#include "core/builtin/default_look.h"
#include "core/builtin/environments.h"
#include "core/io/asset_loader.h"
#include "core/io/environment_image.h"
#include "core/io/importer.h"
#include "core/scene/cameras.h"
#include "core/scene/primitives.h"

namespace dermis {
namespace {

/// The invariants of Model, and a right-handed frame at every vertex.
void expectSound(const Model& model) {
  const std::size_t count = model.positions.size();
  ASSERT_EQ(model.normals.size(), count);
  ASSERT_EQ(model.tangents.size(), count);
  ASSERT_EQ(model.uvs.size(), count);
  for (std::size_t i = 0; i < count; ++i) {
    ASSERT_NEAR(glm::length(model.normals[i]), 1.0F, 1e-5F);
    ASSERT_NEAR(glm::length(glm::vec3(model.tangents[i])), 1.0F, 1e-5F);
    ASSERT_NEAR(glm::dot(model.normals[i], glm::vec3(model.tangents[i])), 0.0F, 1e-5F);
    ASSERT_EQ(std::abs(model.tangents[i].w), 1.0F);
  }
  std::size_t indices = 0;
  for (const ModelPart& part : model.parts) {
    ASSERT_LT(part.slot, model.slots.size());
    ASSERT_EQ(part.indexCount % 3, 0U);
    indices += part.indexCount;
  }
  ASSERT_EQ(indices, model.indices.size());
  for (std::size_t i = 0; i < model.indices.size(); i += 3) {
    const std::uint32_t a = model.indices[i], b = model.indices[i + 1], c = model.indices[i + 2];
    ASSERT_LT(std::max({a, b, c}), count);
    const glm::vec3 face = glm::cross(model.positions[b] - model.positions[a], model.positions[c] - model.positions[a]);
    ASSERT_GT(glm::dot(face, model.normals[a] + model.normals[b] + model.normals[c]), 0.0F) << "triangle " << i / 3;
    // The tangent follows u: where u grows along an edge, the edge runs along the tangent.
    const glm::vec2 du = model.uvs[b] - model.uvs[a];
    if (std::abs(du.y) < 1e-6F && std::abs(du.x) > 1e-4F && std::abs(du.x) < 0.5F) {
      ASSERT_GT(glm::dot(model.positions[b] - model.positions[a], glm::vec3(model.tangents[a])) * du.x, 0.0F);
    }
  }
}

TEST(BuiltinContent, SphereIsExact) {
  const Model sphere = makeSphere(64);
  expectSound(sphere);
  for (std::size_t i = 0; i < sphere.positions.size(); ++i) {
    EXPECT_NEAR(glm::length(sphere.positions[i]), 1.0F, 1e-6F);
    EXPECT_NEAR(glm::distance(sphere.positions[i], sphere.normals[i]), 0.0F, 1e-6F);
    if (sphere.uvs[i] == glm::vec2(0.5F)) {
      EXPECT_NEAR(sphere.positions[i].z, 1.0F, 1e-6F) << "u = v = ½ faces +Z";
    }
  }
  EXPECT_EQ(makeSphere().indices.size() / 3, 512U * 255U * 2U);
  EXPECT_EQ(sphere.millimetresPerUnit, 100.0F);
}

TEST(BuiltinContent, PlaneAndTrioAreSound) {
  expectSound(makePlane());
  const auto trio = builtinModel("default");
  ASSERT_TRUE(trio);
  expectSound(*trio);
  ASSERT_EQ(trio->slots.size(), 3U);
  EXPECT_EQ(trio->slots[0].name, "skin");
  EXPECT_EQ(trio->slots[1].name, "eye");
  EXPECT_EQ(trio->slots[2].name, "gold");
  EXPECT_FALSE(builtinModel("teapot"));
}

TEST(BuiltinContent, AppendedModelsArePlacedAndNamedApart) {
  Model model = makePlane();
  appendModel(model, makeSphere(16), {{-2.0F, 1.0F, 1.0F}, {0.0F, 90.0F, 0.0F}, {0.0F, 5.0F, 0.0F}});
  expectSound(model);  // the mirroring scale has turned the triangles round
  EXPECT_EQ(model.slots[1].name, "default.2");
  EXPECT_NEAR(model.bounds.max.y, 6.0F, 1e-5F);
  EXPECT_NEAR(model.bounds.max.z, 2.0F, 1e-5F) << "scaled along x first, then turned about y";
}

TEST(BuiltinContent, EnvironmentsAreTheSameEveryTimeAndFollowTheConvention) {
  for (const BuiltinEnvironmentRow& row : builtinEnvironments()) {
    const auto a = builtinEnvironment(row.id);
    const auto b = builtinEnvironment(row.id);
    ASSERT_TRUE(a && b) << row.id;
    EXPECT_EQ(a->contentHash, b->contentHash);
    EXPECT_EQ(a->latLong->pixels, b->latLong->pixels);
  }
  EXPECT_EQ(builtinEnvironment("moon"), nullptr);

  // CIE standard overcast sky: the horizon has a third of the zenith's radiance.
  const auto sky = builtinEnvironment("overcast")->latLong;
  const auto green = [&](int x, int y) {
    float v = 0.0F;
    std::memcpy(&v, sky->pixels.data() + static_cast<std::size_t>((y * sky->width + x) * 3 + 1) * sizeof v, sizeof v);
    return v;
  };
  EXPECT_NEAR(green(7, 0) / green(7, sky->height / 2 - 2), 3.0F, 0.15F);
  EXPECT_GT(green(7, 0), green(7, sky->height - 1));
}

TEST(BuiltinContent, IntegersAreDecodedFromSrgbAndFloatsAreNot) {
  Image grey{1, 1, 1, PixelType::U8, std::vector{std::byte{188}}, "grey"};
  Image linear = toLinearRadiance(grey);
  ASSERT_EQ(linear.channels, 3);
  std::array<float, 3> rgb{};
  std::memcpy(rgb.data(), linear.pixels.data(), sizeof rgb);
  for (const float v : rgb) EXPECT_NEAR(v, std::pow((188.0 / 255.0 + 0.055) / 1.055, 2.4), 1e-5);
  linear = toLinearRadiance(linear);
  std::memcpy(rgb.data(), linear.pixels.data(), sizeof rgb);
  for (const float v : rgb) EXPECT_NEAR(v, std::pow((188.0 / 255.0 + 0.055) / 1.055, 2.4), 1e-5);
}

TEST(BuiltinContent, CamerasSeeTheWholeBounds) {
  Bounds bounds;
  bounds.grow({-1.0F, -3.0F, -2.0F});
  bounds.grow({2.0F, 1.0F, 0.5F});
  for (const NamedCameraRow& row : namedCameras()) {
    const auto camera = namedCamera(row.id, bounds);
    ASSERT_TRUE(camera) << row.id;
    if (row.id == "ear") continue;  // a part of it
    const glm::vec3 forward = glm::normalize(camera->target - camera->position);
    const glm::vec3 right = glm::normalize(glm::cross(forward, camera->up));
    const glm::vec3 up = glm::cross(right, forward);
    const float slope = std::tan(glm::radians(camera->verticalFovDegrees) / 2.0F);
    for (int corner = 0; corner < 8; ++corner) {
      const glm::vec3 p(corner & 1 ? bounds.max.x : bounds.min.x, corner & 2 ? bounds.max.y : bounds.min.y,
                        corner & 4 ? bounds.max.z : bounds.min.z);
      const float depth = glm::dot(p - camera->position, forward);
      EXPECT_GT(depth, 0.0F) << row.id;
      EXPECT_LE(std::abs(glm::dot(p - camera->position, right)), depth * slope) << row.id;
      EXPECT_LE(std::abs(glm::dot(p - camera->position, up)), depth * slope) << row.id;
    }
  }
  EXPECT_TRUE(namedCamera("Three-Quarter", bounds));
  EXPECT_FALSE(namedCamera("behind", bounds));
  EXPECT_GT(namedCamera("top-right", bounds)->position.x, namedCamera("top-left", bounds)->position.x);
}

TEST(BuiltinContent, ResolvingWhatIsBuiltInLoadsNoImportModule) {
  Warnings warnings;
  ResolveOptions options;
  options.cache = std::make_shared<AssetCache>();
  const auto first = resolveScene(defaultLook(), {}, options, warnings);
  ASSERT_TRUE(first) << first.error().message;
  EXPECT_TRUE(warnings.empty());
  EXPECT_FALSE(importerLoaded());
  ASSERT_EQ(first->slots.size(), 4U);
  EXPECT_EQ(first->slots[2].material.model, ShadingModel::Lens);

  // Nothing is made twice while somebody holds it.
  Scene turned = defaultLook();
  turned.environment.rotationDegrees = 30.0F;
  const auto second = resolveScene(turned, {}, options, warnings);
  ASSERT_TRUE(second);
  EXPECT_EQ(first->model, second->model);
  EXPECT_EQ(first->environment, second->environment);
}

TEST(BuiltinContent, SlotsWithoutABindingWearWhatTheBuiltInModelSays) {
  Warnings warnings;
  Scene scene;
  scene.model.builtin = "default";
  const auto bare = resolveScene(scene, {}, {}, warnings);
  ResolveOptions imported;
  imported.importedMaterials = true;
  const auto own = resolveScene(scene, {}, imported, warnings);
  scene.materials["*"].material.model = ShadingModel::Thesis;
  scene.materials["eye"].material.model = ShadingModel::Lens;
  const auto bound = resolveScene(scene, {}, imported, warnings);
  ASSERT_TRUE(bare && own && bound);
  EXPECT_EQ(bare->slots[2].material.model, ShadingModel::MetallicRoughness);
  EXPECT_EQ(bare->slots[2].material, own->slots[2].material);
  EXPECT_EQ(bound->slots[1].material.model, ShadingModel::Lens);
  EXPECT_EQ(bound->slots[2].material.model, ShadingModel::Thesis);
}

TEST(BuiltinContent, UnknownNamesAndMissingFilesAreInputErrors) {
  Warnings warnings;
  Scene scene;
  scene.environment.builtin = "moon";
  const auto unknown = resolveScene(scene, {}, {}, warnings);
  ASSERT_FALSE(unknown);
  EXPECT_EQ(unknown.error().kind, Error::Kind::Input);
  EXPECT_NE(unknown.error().message.find("moon"), std::string::npos);
}

}  // namespace
}  // namespace dermis
