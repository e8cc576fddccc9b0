// On software GL a window draws a whole picture in two events. The halves together must be the picture that is drawn at
// once, whatever happens between them.
#include <functional>
#include <string>

#include "core/scene/primitives.h"
#include "gpu/moving_support.h"

namespace dermis::test {
namespace {

class TwoHalves : public MovingTest {
 protected:
  void SetUp() override {
    MovingTest::SetUp();
    makeSoftwareRenderer();
  }
  /// What the window shows and what the renderer holds after each of some frames.
  struct Shown {
    std::vector<std::uint8_t> window;
    Image beauty;
    int samples = 0;
    bool operator==(const Shown& other) const {
      return window == other.window && beauty.pixels == other.beauty.pixels && samples == other.samples;
    }
  };
  Shown shown(const Window& window) {
    return {window.read(), m_renderer->readAov(Aov::Beauty), m_renderer->statistics().samples};
  }
  /// As Qt leaves it when it has composed the window.
  static void disturb() {
    glViewport(3, 5, 7, 11);
    glUseProgram(0);
    glBindVertexArray(0);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    for (GLuint binding = 0; binding < 8; ++binding) glBindBufferBase(GL_UNIFORM_BUFFER, binding, 0);
    for (GLuint unit = 0; unit < 32; ++unit) glBindTextureUnit(unit, 0);
    glEnable(GL_BLEND);
    glDisable(GL_BLEND);
  }
};

ResolvedScene withAllThatIsDrawnAfterwards() {
  ResolvedScene scene = everything();
  auto model = std::make_shared<Model>(*scene.model);
  appendModel(*model, makeSphere(16), {glm::vec3(0.4F), {}, {1.0F, 0.0F, 1.0F}});
  scene.model = model;
  scene.slots.push_back({materialOf(ShadingModel::Lens), {}});
  scene.scene.environment.background.kind = BackgroundKind::Environment;
  scene.scene.lights[1].visible = true;
  return scene;
}

TEST_F(TwoHalves, AreThePictureDrawnAtOnce) {
  const Window window(m_size);
  for (const bool moving : {true, false})
    for (const bool references : {false, true}) {
      SCOPED_TRACE((moving ? "moving" : "still") + std::string(references ? " with references" : ""));
      const ResolvedScene scene = withAllThatIsDrawnAfterwards();
      FrameRequest frame = movingFrame(scene, window);
      frame.moving = moving;
      frame.targetSamples = 4;
      frame.references = {references, references};
      const auto draw = [&](bool inHalves) {
        makeSoftwareRenderer();
        show(scene);
        std::vector<Shown> pictures;
        for (int sample = 0; sample < 4; ++sample) {
          const std::uint64_t before = m_renderer->statistics().frames;
          if (inHalves) {
            EXPECT_TRUE(m_renderer->beginFrame(frame));
            EXPECT_TRUE(m_renderer->beginFrame(frame)) << "asked again it is begun still";
            EXPECT_EQ(m_renderer->statistics().frames, before) << "nothing is finished yet";
            disturb();
          }
          EXPECT_TRUE(m_renderer->renderFrame(frame));
          EXPECT_EQ(m_renderer->statistics().frames, before + 1);
          pictures.push_back(shown(window));
        }
        return pictures;
      };
      const auto whole = draw(false);
      EXPECT_EQ(whole.back().samples, moving ? 1 : 4);
      EXPECT_EQ(whole.front() == whole.back(), moving) << "or the samples say nothing";
      EXPECT_TRUE(draw(true) == whole);
    }
}

TEST_F(TwoHalves, WhatComesBetweenThemCounts) {
  ResolvedScene scene = withAllThatIsDrawnAfterwards();
  const Window window(m_size);
  FrameRequest frame = movingFrame(scene, window);
  frame.moving = false;
  frame.targetSamples = 8;
  const auto set = [&] { m_renderer->setScene(std::make_shared<ResolvedScene>(scene)); };
  struct Event {
    const char* name;
    std::function<void()> happens;
  };
  const std::vector<Event> events = {
      {"camera", [&] { frame.camera.position.x += 0.3F; }},
      {"size", [&] { frame.size = frame.size / 2; }},
      {"a slider", [&] { scene.slots[0].material.parameters.specularPerceptualRoughness += 0.2F, set(); }},
      {"a light", [&] { scene.scene.lights[0].intensity *= 3.0F, set(); }},
      {"another model", [&] { scene.model = std::make_shared<Model>(makeSphere(128)), scene.slots.resize(1), set(); }},
      {"no subsurface", [&] { frame.withoutSubsurface = true; }},
      {"a drag", [&] { frame.moving = true; }},
      {"letting go", [&] { frame.moving = false; }},
  };
  show(scene);
  ASSERT_TRUE(m_renderer->renderFrame(frame));
  for (const Event& event : events) {
    SCOPED_TRACE(event.name);
    EXPECT_TRUE(m_renderer->beginFrame(frame));
    const auto before = shown(window);
    event.happens();
    if (frame.size != frame.displaySize) frame.displaySize = m_size;
    EXPECT_TRUE(m_renderer->renderFrame(frame));
    const Shown now = shown(window);
    EXPECT_FALSE(now == before) << "or this says nothing";
    m_renderer->restartAccumulation();
    EXPECT_TRUE(m_renderer->renderFrame(frame));
    EXPECT_TRUE(shown(window) == now) << "drawn at once";
  }
}

TEST_F(TwoHalves, NothingIsBegunWhereNothingIsToBeDrawn) {
  const ResolvedScene scene = everything();
  const Window window(m_size);
  FrameRequest frame = movingFrame(scene, window);
  frame.moving = false;
  EXPECT_FALSE(m_renderer->beginFrame(frame)) << "no scene";
  show(scene);
  frame.verticesAtOnce = 10000;
  EXPECT_FALSE(m_renderer->beginFrame(frame));
  EXPECT_TRUE(m_renderer->lightIsPending());
  frame.verticesAtOnce = 0;
  EXPECT_TRUE(m_renderer->beginFrame(frame));
  glFinish();
  EXPECT_TRUE(m_renderer->beginningIsDrawn());
  EXPECT_TRUE(m_renderer->renderFrame(frame));
  EXPECT_FALSE(m_renderer->accumulating());
  EXPECT_FALSE(m_renderer->beginFrame(frame)) << "it has all its samples";
}

TEST_F(TwoHalves, NobodyReadsHalfAPicture) {
  const ResolvedScene scene = withAllThatIsDrawnAfterwards();
  const Window window(m_size);
  FrameRequest frame = movingFrame(scene, window);
  frame.moving = false;
  frame.targetSamples = 4;
  show(scene);
  const glm::ivec2 ball = m_size / 2, sky(4);
  const auto read = [&](glm::ivec2 pixel) { return m_renderer->readPixel(pixel, frame.view); };
  EXPECT_TRUE(m_renderer->beginFrame(frame));
  EXPECT_FALSE(read(ball).has_value());
  EXPECT_FALSE(read(sky).has_value());
  EXPECT_TRUE(m_renderer->renderFrame(frame));
  ASSERT_TRUE(read(ball).has_value());
  const auto first = read(sky);
  ASSERT_TRUE(first.has_value());
  EXPECT_GT(first->radiance.r, 0.0F);
  // Of the next sample only the mean of those before is known.
  EXPECT_TRUE(m_renderer->beginFrame(frame));
  ASSERT_TRUE(read(sky).has_value());
  EXPECT_EQ(read(sky)->radiance, first->radiance);
  // Depth belongs to the camera it was drawn with.
  EXPECT_TRUE(m_renderer->renderFrame(frame));
  frame.camera.position.x += 0.5F;
  EXPECT_TRUE(m_renderer->beginFrame(frame));
  const auto begun = m_renderer->pickPosition(ball);
  EXPECT_TRUE(m_renderer->renderFrame(frame));
  ASSERT_TRUE(begun.has_value());
  EXPECT_EQ(begun, m_renderer->pickPosition(ball));
}

}  // namespace
}  // namespace dermis::test
