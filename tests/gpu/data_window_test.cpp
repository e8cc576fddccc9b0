// Pictures whose images hold no more than the model fills, against the same with images of all of it.
#include "passes/data_window.h"

#include <algorithm>

#include "core/scene/primitives.h"
#include "gpu/frame_support.h"
#include "gpu/lighting_support.h"
#include "gpu/subsurface_support.h"

namespace dermis::test {
namespace {

TEST(DataWindow, ACroppedCameraPutsEveryPointOnTheSamePixel) {
  Bounds bounds;
  bounds.grow(glm::vec3(-1.0F));
  bounds.grow(glm::vec3(1.0F));
  const glm::ivec2 size(640, 360);
  const PixelArea part{{128, 64}, {448, 320}};
  for (const bool orthographic : {false, true}) {
    Camera camera;
    if (orthographic) camera.orthographicHeight = 3.0F;
    const CameraMatrices whole = cameraMatrices(camera, bounds, size, {0.3F, -0.2F});
    const CameraMatrices crop = cropped(whole, part, size);
    for (const glm::vec3& point : {glm::vec3(0.0F), glm::vec3(0.7F, -0.4F, 0.9F), glm::vec3(-0.9F, 0.8F, -1.0F)}) {
      const auto pixelOf = [&](const CameraMatrices& m, glm::ivec2 extent) {
        const glm::vec4 clip = m.viewProjection * glm::vec4(point, 1.0F);
        const glm::vec3 at = glm::vec3(clip) / clip.w;
        return glm::vec3((glm::vec2(at) * 0.5F + 0.5F) * glm::vec2(extent), at.z);
      };
      const glm::vec3 expected = pixelOf(whole, size) - glm::vec3(part.lower, 0.0F);
      const glm::vec3 found = pixelOf(crop, part.extent());
      EXPECT_LT(glm::length(found - expected), 2e-4F);
      const glm::vec4 world = crop.inverseViewProjection * crop.viewProjection * glm::vec4(point, 1.0F);
      EXPECT_LT(glm::length(glm::vec3(world) / world.w - point), 1e-4F);
    }
  }
}

TEST(DataWindow, WhatLiesAroundAPartAndThePartAreThePicture) {
  const glm::ivec2 size(40, 30);
  for (const PixelArea& part : {PixelArea{{8, 4}, {16, 20}}, PixelArea{{0, 0}, {40, 12}}, PixelArea{{32, 0}, size}}) {
    const auto columns = static_cast<std::size_t>(size.x);
    std::vector<int> touched(columns * static_cast<std::size_t>(size.y), 0);
    std::vector<PixelArea> areas = areasAround(part, size);
    areas.push_back(part);
    for (const PixelArea& area : areas)
      for (int y = area.lower.y; y < area.upper.y; ++y)
        for (int x = area.lower.x; x < area.upper.x; ++x)
          ++touched.at(static_cast<std::size_t>(y) * columns + static_cast<std::size_t>(x));
    EXPECT_TRUE(std::ranges::all_of(touched, [](int count) { return count == 1; }));
  }
}

class DataWindowPicture : public FrameTest {
 protected:
  void SetUp() override {
    FrameTest::SetUp();
    m_size = {320, 192};
  }
  /// A ball of skin left of and below the middle, before a sky of every colour.
  static ResolvedScene ball() {
    const Material material = materialOf(ShadingModel::Skin);
    ResolvedScene scene = sceneOf(makeSphere(96), material);
    scene.millimetresPerUnit = 20.0F;
    auto world = latLongEnvironment(64, 32, [](int i, int j) {
      const auto x = static_cast<float>(i);
      const auto y = static_cast<float>(j);
      return glm::vec3(0.5F + 0.4F * std::sin(0.3F * x), 0.6F + 0.3F * std::cos(0.2F * x + 0.3F * y), 0.02F * y);
    });
    scene.environment = world;
    scene.camera = Camera{};
    scene.camera.position = {3.0F, 2.0F, 14.0F};
    scene.camera.target = {1.2F, 0.7F, 0.0F};
    scene.scene.environment.background.kind = BackgroundKind::Environment;
    return scene;
  }
  /// Keeping another image of the picture keeps all of it.
  Image wholePicture(const ResolvedScene& scene, int samples) {
    m_renderer->keepAovs({Aov::Normal});
    Image image = still(scene, samples);
    EXPECT_FALSE(isCropped());
    m_renderer->keepAovs({});
    return image;
  }
  bool isCropped() {
    return std::ranges::any_of(m_renderer->passTimes(), [](const PassTime& pass) { return pass.name == "sky around"; });
  }
  /// The same but for rounding: a pixel of the edge may fall to the other side in one of its samples.
  void expectSame(const Image& a, const Image& b) const {
    ASSERT_EQ(a.pixels.size(), b.pixels.size());
    int others = 0;
    for (int y = 0; y < m_size.y; ++y)
      for (int x = 0; x < m_size.x; ++x) others += glm::length(pixel(a, x, y) - pixel(b, x, y)) > 2e-3F ? 1 : 0;
    EXPECT_LE(others, m_size.x * m_size.y / 5000);
  }
};

TEST_F(DataWindowPicture, IsTheSameAsTheWholeOne) {
  for (const int samples : {1, 3}) {
    const ResolvedScene scene = ball();
    const Image whole = wholePicture(scene, samples);
    const Image cropped = still(scene, samples);
    EXPECT_TRUE(isCropped());
    expectSame(whole, cropped);
    // Something is to be seen: the ball isn't the sky, and the sky has colours.
    EXPECT_GT(glm::length(pixel(cropped, 2, 2) - pixel(cropped, 300, 180)), 0.1F);
  }
}

TEST_F(DataWindowPicture, EveryKindOfBackgroundStandsAroundIt) {
  ResolvedScene scene = ball();
  for (const BackgroundKind kind : {BackgroundKind::Color, BackgroundKind::None, BackgroundKind::Irradiance}) {
    scene.scene.environment.background.kind = kind;
    scene.scene.environment.background.color = {0.2F, 0.4F, 0.1F};
    const Image whole = wholePicture(scene, 1);
    const Image cropped = still(scene, 1);
    EXPECT_TRUE(isCropped());
    expectSame(whole, cropped);
  }
}

TEST_F(DataWindowPicture, PointsArePickedAndReadWhereTheyAre) {
  const ResolvedScene scene = ball();
  const Image whole = wholePicture(scene, 1);
  std::vector<glm::ivec2> places;
  for (int y = 8; y < m_size.y; y += 24)
    for (int x = 8; x < m_size.x; x += 24) places.emplace_back(x, y);
  std::vector<std::optional<glm::vec3>> picked;
  picked.reserve(places.size());
  for (const glm::ivec2 place : places) picked.push_back(m_renderer->pickPosition(place));
  const Image cropped = still(scene, 1);
  ASSERT_TRUE(isCropped());
  int hits = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto again = m_renderer->pickPosition(places[i]);
    ASSERT_EQ(again.has_value(), picked[i].has_value());
    if (again) {
      ++hits;
      EXPECT_LT(glm::length(*again - *picked[i]), 1e-3F);
    }
    const auto readout = m_renderer->readPixel(places[i], ViewSettings{});
    ASSERT_TRUE(readout.has_value());
    EXPECT_LT(glm::length(readout->radiance - pixel(cropped, places[i].x, places[i].y)), 1e-5F);
  }
  EXPECT_GT(hits, 3);
  EXPECT_LT(hits, static_cast<int>(places.size()) / 2);
}

TEST_F(DataWindowPicture, ATurningCameraGetsItsOwnPictureEachTime) {
  ResolvedScene scene = ball();
  std::vector<Image> cropped;
  for (const float x : {1.2F, -1.5F, 0.0F, 2.2F}) {
    scene.camera.target.x = x;
    cropped.push_back(still(scene, 1));
  }
  std::size_t i = 0;
  for (const float x : {1.2F, -1.5F, 0.0F, 2.2F}) {
    scene.camera.target.x = x;
    expectSame(wholePicture(scene, 1), cropped[i++]);
  }
}

TEST_F(DataWindowPicture, SamplesOfOnePictureAddUpWhateverWasDrawnBefore) {
  // The ball in a corner, then in another, then filling the picture: each in images that the one before left.
  struct View {
    glm::vec3 position, target;
  };
  for (const View& view :
       {View{{0, 0, 14}, {3.5F, 1.8F, 0}}, View{{0, 0, 14}, {-3.5F, -1.8F, 0}}, View{{0, 0, 3}, {0, 0, 0}},
        View{{0, 0, 9}, {1, 0, 0}}, View{{0, 0, 30}, {9, 4, 0}}, View{{0, 0, 14}, {3.5F, 1.8F, 0}}}) {
    ResolvedScene scene = ball();
    scene.camera.position = view.position;
    scene.camera.target = view.target;
    show(scene);
    const FrameRequest frame = request(scene, 3);
    for (int sample = 1; sample <= 3; ++sample) {
      EXPECT_TRUE(m_renderer->accumulating() || sample == 1);
      ASSERT_TRUE(m_renderer->renderFrame(frame));
      EXPECT_EQ(m_renderer->statistics().samples, sample);
    }
    EXPECT_FALSE(m_renderer->accumulating());
  }
}

TEST_F(DataWindowPicture, AnImageThatNobodyKeptIsBlack) {
  const ResolvedScene scene = ball();
  still(scene, 1);
  ASSERT_TRUE(isCropped());
  const Image normal = m_renderer->readAov(Aov::Normal);
  ASSERT_EQ(normal.width, m_size.x);
  EXPECT_TRUE(std::ranges::all_of(normal.pixels, [](std::byte b) { return b == std::byte{0}; }));
}

TEST_F(DataWindowPicture, AModelThatFillsThePictureOrLeavesItIsNotCropped) {
  ResolvedScene scene = ball();
  scene.camera.position = {0.0F, 0.0F, 3.0F};
  scene.camera.target = glm::vec3(0.0F);
  still(scene, 1);
  EXPECT_FALSE(isCropped());
  scene.camera.target = {0.0F, 40.0F, 3.1F};
  const Image sky = still(scene, 1);
  expectSame(wholePicture(scene, 1), sky);
}

}  // namespace
}  // namespace dermis::test
