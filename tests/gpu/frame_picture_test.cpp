// The picture: samples, coverage, backgrounds, lamps, blending, AOVs, picking.
#include <algorithm>
#include <numbers>

#include "core/scene/primitives.h"
#include "gpu/frame_support.h"

namespace dermis::test {
namespace {

constexpr glm::vec3 kBlack(0.0F);

using FramePicture = FrameTest;

TEST_F(FramePicture, OneSampleIsThePixelsCentre) {
  const ResolvedScene scene = sceneOf(makeSphere(128), emissive({1.0F, 0.5F, 0.25F}), kBlack);
  const Image image = still(scene, 1);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const float alpha = pixel(image, x, y).a;
      const glm::vec2 at = (glm::vec2(x, y) + 0.5F) / 24.0F - 1.0F;
      EXPECT_TRUE(alpha == 0.0F || alpha == 1.0F);
      if (std::abs(glm::length(at) - 1.0F) > 0.02F) {
        EXPECT_EQ(alpha == 1.0F, glm::length(at) < 1.0F) << x << " " << y;
      }
    }
}

TEST_F(FramePicture, SamplesConvergeToCoverage) {
  const ResolvedScene scene = sceneOf(makeSphere(256), emissive({1.0F, 1.0F, 1.0F}), kBlack);
  double areas[2] = {};
  int index = 0;
  for (const int samples : {1, 64}) {
    const Image image = still(scene, samples);
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x) areas[index] += static_cast<double>(pixel(image, x, y).a) / (24.0 * 24.0);
    ++index;
  }
  // The disc's area is π; a polygon of 256 corners lacks a ten-thousandth of it.
  EXPECT_NEAR(areas[1], std::numbers::pi, 0.003);
  EXPECT_EQ(m_renderer->statistics().samples, 64);
  // Premultiplied: radiance 1 where the pixel is covered.
  const Image image = m_renderer->readAov(Aov::Beauty);
  for (int x = 0; x < image.width; ++x) EXPECT_NEAR(pixel(image, x, 3).r, pixel(image, x, 3).a, 1e-3F);
}

TEST_F(FramePicture, TheSameAgainIsIdentical) {
  ResolvedScene scene = sceneOf(makeSphere(64), materialOf(ShadingModel::Skin), {0.5F, 0.6F, 0.7F});
  scene.scene.lights.push_back(pointLight(glm::vec3(2.0F), 5.0F));
  const Image first = still(scene, 9);
  m_renderer->restartAccumulation();
  const Image second = still(scene, 9);
  EXPECT_EQ(first.pixels, second.pixels);
  makeRenderer();
  EXPECT_EQ(first.pixels, still(scene, 9).pixels) << "another renderer draws the same";
}

TEST_F(FramePicture, WhatChangesTheSamplesAndWhatDoesNot) {
  ResolvedScene scene = sceneOf(makePlane(), materialOf(ShadingModel::Skin));
  still(scene, 8);
  FrameRequest frame = request(scene, 8);
  EXPECT_FALSE(m_renderer->accumulating());

  frame.view.transform = "Thesis";  // only shown otherwise
  m_renderer->renderFrame(frame);
  EXPECT_EQ(m_renderer->statistics().samples, 8);
  frame.targetSamples = 12;  // goes on where it was
  m_renderer->renderFrame(frame);
  EXPECT_EQ(m_renderer->statistics().samples, 9);
  scene.scene.view.transform = "Raw";
  scene.scene.name = "renamed";
  show(scene);  // an equal scene
  m_renderer->renderFrame(frame);
  EXPECT_EQ(m_renderer->statistics().samples, 10);
  frame.seconds = 3.0;  // nothing is animated
  m_renderer->renderFrame(frame);
  EXPECT_EQ(m_renderer->statistics().samples, 11);

  frame.camera.position.x += 0.1F;
  m_renderer->renderFrame(frame);
  EXPECT_EQ(m_renderer->statistics().samples, 1);
  m_renderer->renderFrame(frame);
  scene.slots[0].material.parameters.specularPerceptualRoughness = 0.3F;
  show(scene);
  m_renderer->renderFrame(frame);
  EXPECT_EQ(m_renderer->statistics().samples, 1);
  m_renderer->renderFrame(frame);
  m_renderer->keepAovs({Aov::Normal});
  m_renderer->renderFrame(frame);
  EXPECT_EQ(m_renderer->statistics().samples, 1);

  scene.scene.lights.push_back(pointLight(glm::vec3(1.0F), 1.0F));
  scene.scene.lights[0].animation = {AnimationKind::Sway, 1.0F, 1.0F};
  show(scene);
  for (int i = 0; i < 3; ++i) {
    frame.seconds += 0.1;
    m_renderer->renderFrame(frame);
    EXPECT_EQ(m_renderer->statistics().samples, 1) << "an animated light never rests";
  }
}

TEST_F(FramePicture, Backgrounds) {
  ResolvedScene scene = sceneOf(makeSphere(32), materialOf(ShadingModel::Skin), {0.2F, 0.4F, 0.8F});
  scene.camera.orthographicHeight = 8.0F;
  scene.scene.environment.exposureStops = 1.0F;
  Background& background = scene.scene.environment.background;
  const auto corner = [&] { return pixel(still(scene), 1, 1); };
  background.kind = BackgroundKind::None;
  EXPECT_EQ(corner(), glm::vec4(0.0F));
  background.kind = BackgroundKind::Color;
  background.color = {3.0F, 0.1F, 0.0F};
  EXPECT_EQ(corner(), glm::vec4(3.0F, 0.1F, 0.0F, 1.0F));
  for (const BackgroundKind kind :
       {BackgroundKind::Environment, BackgroundKind::Irradiance, BackgroundKind::Prefiltered}) {
    background.kind = kind;
    background.perceptualRoughness = 0.4F;
    const glm::vec4 colour = corner();
    EXPECT_THAT(colour, IsColour(glm::vec3(0.4F, 0.8F, 1.6F), 0.002F));
    EXPECT_EQ(colour.a, 1.0F);
  }
}

TEST_F(FramePicture, AVisibleLampHasTheRadianceOfItsIntensity) {
  ResolvedScene scene = sceneOf(makePlane(), emissive(kBlack), kBlack);
  Light lamp = pointLight({0.0F, 0.0F, 1.0F}, 3.0F);
  lamp.color = {1.0F, 0.5F, 0.25F};
  lamp.visible = true;
  lamp.radiusMm = 20.0F;  // 0.2 units
  scene.scene.lights = {lamp};
  const Image image = still(scene);
  const float radiance = 3.0F / (std::numbers::pi_v<float> * 0.04F);
  EXPECT_THAT(pixel(image, 24, 24), IsColour(radiance * lamp.color, radiance * 1e-5F));
  EXPECT_NE(pixel(image, 24 + 7, 24).r, pixel(image, 24, 24).r) << "0.3 units off its centre is past its edge";

  scene.scene.lights[0].position.z = -1.0F;  // behind the plane
  EXPECT_LT(pixel(still(scene), 24, 24).r, 1.0F);
  scene.scene.lights[0].position.z = 1.0F;
  scene.scene.lights[0].enabled = false;
  EXPECT_EQ(pixel(still(scene), 24, 24).r, 0.0F);
}

/// A plane of emission 1 with a lens-shaped sphere of radius 0.5 at z.
ResolvedScene lensScene(float z, const Material& lens) {
  Model model = makePlane();
  appendModel(model, makeSphere(64), {.scale = glm::vec3(0.5F), .translate = {0.0F, 0.0F, z}});
  ResolvedScene scene = sceneOf(std::move(model), emissive(glm::vec3(1.0F)), kBlack);
  scene.slots.at(1).material = lens;
  return scene;
}

TEST_F(FramePicture, ALensCoversByItsOpacity) {
  Material lens = materialOf(ShadingModel::Lens);
  lens.parameters.lensOpacity = 0.25F;
  const Image over = still(lensScene(1.0F, lens));
  EXPECT_THAT(pixel(over, 24, 24), IsColour(glm::vec3(0.75F), 1e-3F));
  EXPECT_THAT(pixel(over, 2, 2), IsColour(glm::vec3(1.0F), 1e-3F));
  EXPECT_THAT(pixel(still(lensScene(-1.0F, lens)), 24, 24), IsColour(glm::vec3(1.0F), 1e-3F)) << "behind the plane";
  // The published way: no depth test.
  lens.parameters.lensSeedBlending = true;
  EXPECT_THAT(pixel(still(lensScene(-1.0F, lens)), 24, 24), IsColour(glm::vec3(0.75F), 1e-3F));
}

TEST_F(FramePicture, BlendedPartsAreSortedFromFarToNear) {
  // Two blended planes before an opaque one; the nearer one stands first in the file.
  Model model = makePlane();
  appendModel(model, makePlane(), {.translate = {0.0F, 0.0F, 1.0F}});
  appendModel(model, makePlane(), {.translate = {0.0F, 0.0F, 0.5F}});
  ResolvedScene scene = sceneOf(std::move(model), emissive({0.0F, 0.0F, 1.0F}), kBlack);
  for (const std::size_t i : {1U, 2U}) {
    scene.slots[i].material = emissive(i == 1 ? glm::vec3(1.0F, 0.0F, 0.0F) : glm::vec3(0.0F, 1.0F, 0.0F));
    scene.slots[i].material.parameters.metallicRoughnessAlphaMode = AlphaMode::Blend;
    scene.slots[i].material.parameters.metallicRoughnessOpacity = 0.5F;
  }
  EXPECT_THAT(pixel(still(scene), 24, 24), IsColour(glm::vec3(0.5F, 0.25F, 0.25F), 1e-3F));
}

TEST_F(FramePicture, SingleSidedMaterialsAreCulledAndSkinIsNot) {
  ResolvedScene scene = sceneOf(makePlane(), emissive(glm::vec3(1.0F)));
  scene.camera.position.z = -5.0F;  // from behind
  EXPECT_EQ(pixel(still(scene), 24, 24).a, 0.0F);
  scene.slots[0].material.parameters.metallicRoughnessDoubleSided = true;
  EXPECT_EQ(pixel(still(scene), 24, 24).a, 1.0F);
  scene.slots[0].material = materialOf(ShadingModel::Skin);
  const glm::vec4 back = pixel(still(scene), 24, 24);
  EXPECT_EQ(back.a, 1.0F);
  EXPECT_GT(back.r, 0.3F) << "lit with its normal turned round";
}

TEST_F(FramePicture, AovsAddUpAndMeanWhatTheySay) {
  ResolvedScene scene = sceneOf(makeSphere(128), materialOf(ShadingModel::Skin), {0.5F, 0.5F, 0.5F});
  scene.camera.orthographicHeight = 3.0F;
  m_renderer->keepAovs(allAovs());
  const Image beauty = still(scene, 4);
  const Image diffuse = m_renderer->readAov(Aov::Diffuse);
  const Image scattered = m_renderer->readAov(Aov::DiffuseScattered);
  const Image specular = m_renderer->readAov(Aov::Specular);
  const Image transmission = m_renderer->readAov(Aov::Transmission);
  const Image normal = m_renderer->readAov(Aov::Normal);
  const Image depth = m_renderer->readAov(Aov::Depth);
  const Image occlusion = m_renderer->readAov(Aov::Occlusion);
  const Image id = m_renderer->readAov(Aov::ProfileId);
  EXPECT_EQ(diffuse.channels, 3);
  EXPECT_EQ(normal.channels, 3);
  EXPECT_EQ(depth.channels, 1);
  for (const int x : {8, 24, 30, 40}) {
    const glm::vec3 sum =
        glm::vec3(pixel(scattered, x, 24)) + glm::vec3(pixel(specular, x, 24)) + glm::vec3(pixel(transmission, x, 24));
    EXPECT_THAT(pixel(beauty, x, 24), IsColour(sum, 1e-4F));
  }
  EXPECT_THAT(pixel(normal, 24, 24), IsColour(glm::vec3(0.0F, 0.0F, 1.0F), 0.06F));
  EXPECT_NEAR(pixel(depth, 24, 24).r, 4.0F, 0.01F);
  EXPECT_EQ(pixel(occlusion, 24, 24).r, 1.0F);
  EXPECT_EQ(pixel(id, 24, 24).r, 1.0F);
  for (const Image* image : {&diffuse, &specular, &normal, &depth, &occlusion, &id})
    EXPECT_EQ(pixel(*image, 0, 0).r, 0.0F) << image->name;
  EXPECT_EQ(largestDifference(beauty, (m_renderer->keepAovs({}), still(scene, 4))), 0.0F)
      << "the picture is the same with and without AOVs";
}

TEST_F(FramePicture, PickingGivesThePlaceUnderThePixel) {
  ResolvedScene scene = sceneOf(makeSphere(256), materialOf(ShadingModel::Skin));
  scene.camera.orthographicHeight = 4.0F;
  for (const bool perspective : {false, true}) {
    if (perspective) scene.camera.orthographicHeight.reset();
    still(scene);
    const auto middle = m_renderer->pickPosition({24, 24});
    ASSERT_TRUE(middle.has_value());
    EXPECT_NEAR(glm::length(*middle), 1.0F, 1e-3F);
    EXPECT_NEAR(middle->z, 1.0F, 0.01F);
    const auto upperLeft = m_renderer->pickPosition({18, 18});
    ASSERT_TRUE(upperLeft.has_value());
    EXPECT_LT(upperLeft->x, -0.1F);
    EXPECT_GT(upperLeft->y, 0.1F);
    EXPECT_FALSE(m_renderer->pickPosition({0, 0}).has_value());
    EXPECT_FALSE(m_renderer->pickPosition({-1, 5}).has_value());
    EXPECT_FALSE(m_renderer->pickPosition({48, 5}).has_value());
  }
}

}  // namespace
}  // namespace dermis::test
