// What bounds a solid is drawn without its back faces; the picture must not show it.
#include "core/bake/mesh_bake.h"
#include "core/scene/primitives.h"
#include "gpu/moving_support.h"

namespace dermis::test {
namespace {

class BackFaces : public MovingTest {
 protected:
  void SetUp() override {
    MovingTest::SetUp();
    makeSoftwareRenderer();
  }
  /// The scene with its bake, which says of its part what `solid` says.
  static ResolvedScene said(ResolvedScene scene, bool solid) {
    MeshBakeOptions options;
    options.skyRays = options.thicknessRays = 4;
    options.mostPoints = 500;
    auto bake = std::make_shared<MeshBake>(**bakeMesh(*scene.model, options));
    bake->solids.assign(scene.model->parts.size(), solid ? 1 : 0);
    scene.bake = std::move(bake);
    return scene;
  }
  std::vector<std::uint8_t> pictureOf(const ResolvedScene& scene, bool isMoving) {
    show(scene);
    const Window window(m_size);
    FrameRequest frame = movingFrame(scene, window);
    frame.moving = isMoving;
    frame.targetSamples = 2;
    for (int i = 0; i < (isMoving ? 1 : 2); ++i) EXPECT_TRUE(m_renderer->renderFrame(frame));
    return window.read();
  }
};

TEST_F(BackFaces, OfABallAreNotMissed) {
  const ResolvedScene scene = everything();
  EXPECT_EQ((*bakeMesh(*scene.model, {}))->solids, (std::vector<std::uint8_t>{1, 1}));
  for (const bool isMoving : {false, true})
    EXPECT_TRUE(pictureOf(said(scene, true), isMoving) == pictureOf(said(scene, false), isMoving)) << isMoving;
}

TEST_F(BackFaces, AreSeenFromWithin) {
  ResolvedScene scene = everything();
  scene.camera = Camera{};
  scene.camera.position = {0.1F, 0.2F, 0.3F};
  EXPECT_TRUE(pictureOf(said(scene, true), false) == pictureOf(said(scene, false), false));
}

TEST_F(BackFaces, WouldBeMissedOfAnOpenBall) {
  ResolvedScene scene = everything();
  auto open = std::make_shared<Model>(makeSphere(256));
  std::vector<std::uint32_t> behind;
  for (std::size_t i = 0; i + 2 < open->indices.size(); i += 3)
    if (open->positions[open->indices[i]].z < 0.3F)
      behind.insert(behind.end(), {open->indices[i], open->indices[i + 1], open->indices[i + 2]});
  open->indices = std::move(behind);
  open->parts.front().indexCount = static_cast<std::uint32_t>(open->indices.size());
  scene.model = open;
  scene.slots.resize(1);
  EXPECT_EQ((*bakeMesh(*scene.model, {}))->solids, std::vector<std::uint8_t>{0});
  EXPECT_FALSE(pictureOf(said(scene, true), false) == pictureOf(said(scene, false), false));
}

}  // namespace
}  // namespace dermis::test
