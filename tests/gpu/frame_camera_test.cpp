// Cameras as matrices.
#include <gtest/gtest.h>

#include "passes/camera_matrices.h"

namespace dermis::test {
namespace {

Bounds unitBounds() {
  Bounds bounds;
  bounds.grow(glm::vec3(-1.0F));
  bounds.grow(glm::vec3(1.0F));
  return bounds;
}

glm::vec3 projected(const CameraMatrices& camera, const glm::vec3& point) {
  const glm::vec4 clip = camera.viewProjection * glm::vec4(point, 1.0F);
  return glm::vec3(clip) / clip.w;
}

TEST(FrameCamera, PerspectiveDepthIsReversed) {
  Camera camera;  // at z = 6, looking at the origin
  const CameraMatrices m = cameraMatrices(camera, unitBounds(), {200, 100}, glm::vec2(0.0F));
  const float nearer = projected(m, {0.0F, 0.0F, 1.0F}).z;
  const float farther = projected(m, {0.0F, 0.0F, -1.0F}).z;
  EXPECT_GT(nearer, farther);
  EXPECT_LT(nearer, 1.0F);
  EXPECT_GT(farther, 0.0F);
  EXPECT_GT(projected(m, {0.0F, 0.0F, -1e6F}).z, 0.0F) << "nothing is too far";
  // Half the field of view reaches the upper edge.
  const float top = 6.0F * std::tan(glm::radians(13.0F));
  EXPECT_NEAR(projected(m, {0.0F, top, 0.0F}).y, 1.0F, 1e-5F);
  EXPECT_NEAR(projected(m, {2.0F * top, 0.0F, 0.0F}).x, 1.0F, 1e-5F);
}

TEST(FrameCamera, OrthographicShowsItsHeightAndAllOfTheBounds) {
  Camera camera;
  camera.orthographicHeight = 3.0F;
  camera.position = {0.0F, 0.0F, 0.5F};  // inside the bounds: an orthographic camera still sees all
  const CameraMatrices m = cameraMatrices(camera, unitBounds(), {100, 100}, glm::vec2(0.0F));
  EXPECT_NEAR(projected(m, {0.0F, 1.5F, 0.0F}).y, 1.0F, 1e-5F);
  for (const float z : {-1.0F, 1.0F}) {
    EXPECT_GT(projected(m, {1.0F, 1.0F, z}).z, 0.0F);
    EXPECT_LT(projected(m, {1.0F, 1.0F, z}).z, 1.0F);
  }
}

TEST(FrameCamera, JitterMovesByPixels) {
  Camera camera;
  const CameraMatrices still = cameraMatrices(camera, unitBounds(), {200, 100}, glm::vec2(0.0F));
  const CameraMatrices moved = cameraMatrices(camera, unitBounds(), {200, 100}, {0.5F, -0.25F});
  const glm::vec3 point(0.3F, -0.2F, 0.4F);
  const glm::vec2 shift =
      (glm::vec2(projected(moved, point)) - glm::vec2(projected(still, point))) * glm::vec2(100.0F, 50.0F);
  EXPECT_NEAR(shift.x, 0.5F, 1e-4F);
  EXPECT_NEAR(shift.y, -0.25F, 1e-4F);
}

TEST(FrameCamera, SamplesFillThePixelEvenlyFromItsCentre) {
  EXPECT_EQ(pixelJitter(0), glm::vec2(0.0F));
  int quadrants[4] = {};
  glm::vec2 mean(0.0F);
  for (int i = 0; i < 256; ++i) {
    const glm::vec2 jitter = pixelJitter(i);
    EXPECT_LE(std::max(std::abs(jitter.x), std::abs(jitter.y)), 0.5F);
    mean += jitter / 256.0F;
    ++quadrants[(jitter.x >= 0.0F ? 1 : 0) + (jitter.y >= 0.0F ? 2 : 0)];
  }
  EXPECT_NEAR(mean.x, 0.0F, 0.01F);
  EXPECT_NEAR(mean.y, 0.0F, 0.01F);
  for (const int count : quadrants) EXPECT_NEAR(count, 64, 4);
}

TEST(FrameCamera, LookingStraightDownIsAllRight) {
  Camera camera;
  camera.position = {0.0F, 5.0F, 0.0F};
  const CameraMatrices m = cameraMatrices(camera, unitBounds(), {100, 100}, glm::vec2(0.0F));
  EXPECT_NEAR(projected(m, glm::vec3(0.0F)).x, 0.0F, 1e-5F);
  EXPECT_FALSE(std::isnan(projected(m, {0.5F, 0.0F, 0.5F}).x));
}

TEST(FrameCamera, ScreenAreaHoldsTheBounds) {
  Camera camera;
  camera.position = {0.0F, 0.0F, 30.0F};
  const glm::ivec2 size(200, 100);
  const CameraMatrices m = cameraMatrices(camera, unitBounds(), size, glm::vec2(0.0F));
  const PixelArea area = screenArea(m, unitBounds(), size);
  EXPECT_GT(area.lower.x, 80);
  EXPECT_LT(area.upper.x, 120);
  camera.position = {0.0F, 0.0F, 0.5F};
  const CameraMatrices inside = cameraMatrices(camera, unitBounds(), size, glm::vec2(0.0F));
  EXPECT_EQ(screenArea(inside, unitBounds(), size).upper, size);
}

}  // namespace
}  // namespace dermis::test
