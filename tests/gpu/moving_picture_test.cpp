// Pictures on software GL are drawn in two steps, geometry and then its shading; moving ones take short cuts besides.
// How far apart the ways are, and what a drag may not do.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <functional>

#include "core/scene/primitives.h"
#include "gpu/moving_support.h"

namespace dermis::test {
namespace {

struct Difference {
  double mean = 0.0;      ///< of all channels of the model's pixels, codes of 255
  double farShare = 0.0;  ///< of its pixels that are more than `far` codes apart
  std::size_t pixels = 0;
};

Difference between(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b, int far) {
  Difference result;
  for (std::size_t i = 0; i + 3 < a.size(); i += 4) {
    // Outlines are smoothed in different ways: what both cover whole.
    if (a[i + 3] != 255 || b[i + 3] != 255) continue;
    int most = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      const int apart = std::abs(int{a[i + c]} - int{b[i + c]});
      result.mean += apart;
      most = std::max(most, apart);
    }
    result.farShare += most > far ? 1.0 : 0.0;
    ++result.pixels;
  }
  result.mean /= 3.0 * static_cast<double>(std::max<std::size_t>(result.pixels, 1));
  result.farShare /= static_cast<double>(std::max<std::size_t>(result.pixels, 1));
  return result;
}

class MovingPicture : public MovingTest {
 protected:
  /// As a window shows it when it has converged, RGBA, first row lowest.
  std::vector<std::uint8_t> stillPicture(const ResolvedScene& scene) {
    still(scene, 16);
    const Image image = m_renderer->readDisplay(request(scene).view, PixelType::U8);
    std::vector<std::uint8_t> values;
    const std::size_t row = image.rowBytes();
    for (auto y = static_cast<std::size_t>(image.height); y-- > 0;)
      for (std::size_t x = 0; x < row; ++x) values.push_back(std::to_integer<std::uint8_t>(image.pixels[y * row + x]));
    return values;
  }
};

TEST_F(MovingPicture, DrawnInTwoStepsItIsTheOneDrawnAtOnce) {
  const ResolvedScene scene = everything();
  const auto deferred = movingPicture(scene, true), direct = movingPicture(scene, false);
  const Difference apart = between(deferred, direct, 10);
  std::printf("  mean %.2f codes, %.2f %% of the pixels more than 10 apart\n", apart.mean, 100.0 * apart.farShare);
  EXPECT_GT(apart.pixels, 15000U);
  EXPECT_LT(apart.mean, 0.6);
  EXPECT_LT(apart.farShare, 0.01);
  // The lamp behind must count, or this says nothing of the light through thin parts.
  ResolvedScene without = scene;
  for (ResolvedMaterial& slot : without.slots) slot.material.parameters.transmissionWeight = 0.0F;
  EXPECT_GT(between(movingPicture(without, true), deferred, 10).mean, 2.0);
}

TEST_F(MovingPicture, AStillOneInTwoStepsIsTheOneDrawnAtOnce) {
  const ResolvedScene scene = everything();
  ResolvedScene inManyParts = scene;  // too many for two steps, of the same triangles
  auto model = std::make_shared<Model>(*scene.model);
  ModelPart rest = model->parts.front();
  for (const std::uint32_t taken : {3000U, 30000U, 60000U, 90000U}) {
    ModelPart first = rest;
    first.indexCount = taken;
    rest.firstIndex += taken;
    rest.indexCount -= taken;
    model->parts.push_back(first);
  }
  model->parts.front() = rest;
  inManyParts.model = model;
  makeSoftwareRenderer();
  constexpr int kSamples = 33;  // enough for reflections to be sampled
  const Image deferred = still(scene, kSamples), direct = still(inManyParts, kSamples);
  double sum = 0.0, apart = 0.0;
  int far = 0;
  for (int y = 0; y < kEdge; ++y)
    for (int x = 0; x < kEdge; ++x) {
      const glm::vec4 a = pixel(deferred, x, y), b = pixel(direct, x, y);
      EXPECT_NEAR(a.a, b.a, 1e-5F);
      for (int c = 0; c < 3; ++c) {
        sum += b[c];
        apart += std::abs(a[c] - b[c]);
        // Rounding may put a place on the other side of a shadow's edge in one of the samples.
        if (std::abs(a[c] - b[c]) > 0.002F + 0.01F * b[c]) ++far;
      }
    }
  std::printf("  %.2e of the light apart, %d values by more than 1 %%\n", apart / sum, far);
  EXPECT_GT(sum, 0.1 * kEdge * kEdge);
  EXPECT_LT(apart, 2e-4 * sum);
  EXPECT_LT(far, kEdge * kEdge / 500);
}

TEST_F(MovingPicture, AgreesWithTheStillOne) {
  const ResolvedScene scene = everything();
  const auto converged = stillPicture(scene);
  const Difference apart = between(movingPicture(scene, true), converged, 16);
  std::printf("  mean %.2f codes, %.2f %% of the pixels more than 16 apart\n", apart.mean, 100.0 * apart.farShare);
  EXPECT_GT(apart.pixels, 15000U);
  EXPECT_LT(apart.mean, 1.0);
  EXPECT_LT(apart.farShare, 0.01);
}

TEST_F(MovingPicture, DragsCompileNothing) {
  makeSoftwareRenderer();
  ResolvedScene scene = everything();
  show(scene);
  const Window window(m_size);
  FrameRequest frame = movingFrame(scene, window);
  ASSERT_TRUE(m_renderer->renderFrame(frame));
  const std::uint64_t compiled = m_renderer->statistics().programsCompiled;
  const std::vector<std::function<void()>> drags = {
      [&] { scene.slots[0].material.parameters.specularPerceptualRoughness += 0.1F; },
      [&] { scene.slots[0].material.parameters.subsurfaceScale *= 1.5F; },
      [&] { scene.slots[0].material.parameters.transmissionThicknessMaxMm += 5.0F; },
      [&] { scene.scene.lights[0].position.x += 0.3F; },
      [&] { scene.scene.lights[1].intensity *= 2.0F; },
      [&] { scene.scene.environment.rotationDegrees += 30.0F; },
      [&] { frame.camera.position.x += 0.2F; }};
  for (const auto& drag : drags) {
    drag();
    m_renderer->setScene(std::make_shared<ResolvedScene>(scene));
    ASSERT_TRUE(m_renderer->renderFrame(frame));
  }
  EXPECT_EQ(m_renderer->statistics().programsCompiled, compiled);
}

// What was rasterised for the last frame is shaded again where only a material has changed. It must be the frame that
// is drawn anew, whatever changes; a lens before ball and sky is drawn over both once, not once a frame.
TEST_F(MovingPicture, WhatIsKeptOfTheLastFrameIsWhatWouldBeDrawnAnew) {
  makeSoftwareRenderer();
  for (const bool withLamps : {false, true}) {
    ResolvedScene scene = everything();
    auto model = std::make_shared<Model>(*scene.model);
    appendModel(*model, makeSphere(16), {glm::vec3(0.4F), {}, {1.0F, 0.0F, 1.0F}});
    scene.model = model;
    scene.slots.push_back({materialOf(ShadingModel::Lens), {}});
    scene.scene.environment.background.kind = BackgroundKind::Environment;
    if (!withLamps) scene.scene.lights.clear();
    MaterialParameters& skin = scene.slots[0].material.parameters;
    const Window window(m_size);
    FrameRequest frame = movingFrame(scene, window);
    const auto picture = [&] {
      m_renderer->setScene(std::make_shared<ResolvedScene>(scene));
      EXPECT_TRUE(m_renderer->renderFrame(frame));
      return window.read();
    };
    const auto kept = [&] { return m_renderer->statistics().surfacesKept; };
    show(scene);
    std::vector<std::uint8_t> before = picture();
    struct Edit {
      const char* name;
      std::function<void()> make;
      bool changesLightAtVertices;  // where lamps shine through
      bool changesGeometry;
    };
    const std::vector<Edit> edits = {
        {"roughness", [&] { skin.specularPerceptualRoughness += 0.2F; }, false, false},
        {"scale", [&] { skin.subsurfaceScale *= 3.0F; }, true, false},
        {"normal strength", [&] { skin.surfaceNormalStrength = 0.2F; }, false, false},
        {"thickness", [&] { skin.transmissionThicknessMaxMm = 4.0F; }, true, false},
        {"tint",
         [&] {
           skin.transmissionTint.rgb = {1.0F, 0.2F, 0.2F};
         },
         false, false},
        {"exposure", [&] { scene.scene.environment.exposureStops = 1.0F; }, true, true},
        {"rotation", [&] { scene.scene.environment.rotationDegrees = 70.0F; }, true, true},
        {"background", [&] { scene.scene.environment.background.kind = BackgroundKind::Color; }, false, true},
        {"camera", [&] { frame.camera.position.x += 0.3F; }, false, true},
        {"a lamp",
         [&] {
           scene.scene.lights.push_back(pointLight({0.5F, 2.0F, 2.0F}, 4.0F));
         },
         true, true}};
    for (const Edit& edit : edits) {
      SCOPED_TRACE(edit.name);
      edit.make();
      const std::uint64_t keptBefore = kept();
      const std::vector<std::uint8_t> now = picture();
      const bool mayKeep = !edit.changesGeometry && !(withLamps && edit.changesLightAtVertices);
      EXPECT_EQ(kept() - keptBefore, mayKeep ? 1U : 0U);
      EXPECT_EQ(picture(), now) << "the same again";
      EXPECT_NE(now, before) << "or this says nothing";
      // Another camera, and back: nothing is left to keep.
      const Camera camera = frame.camera;
      frame.camera.position.y += 1.0F;
      picture();
      frame.camera = camera;
      EXPECT_EQ(picture(), now);
      before = now;
    }
  }
}

// Shown larger than it is drawn, a picture has fewer triangles. It must still be the picture, without spots where the
// new ones lie below those that cast the shadows, and what their vertices hold must not be taken for all vertices'
// light.
TEST_F(MovingPicture, OfFewerTrianglesItIsTheSame) {
  makeSoftwareRenderer();
  ResolvedScene scene = everything();
  show(scene);
  const Window window(2 * m_size);
  FrameRequest fine = request(scene);
  fine.exactDisplay = false;
  fine.moving = true;
  FrameRequest coarse = fine;
  coarse.displaySize = 2 * m_size;
  coarse.framebuffer = window.framebuffer.id();
  const auto coarseFrames = [&] { return m_renderer->statistics().coarseFrames; };
  const auto picture = [&](const FrameRequest& frame) {
    m_renderer->setScene(std::make_shared<ResolvedScene>(scene));
    EXPECT_TRUE(m_renderer->renderFrame(frame));
    std::vector<glm::vec4> values;
    for (int y = 0; y < kEdge; y += 2)
      for (int x = 0; x < kEdge; x += 2) values.push_back(m_renderer->readPixel({x, y}, frame.view)->radiance);
    return values;
  };
  const auto apart = [](const std::vector<glm::vec4>& a, const std::vector<glm::vec4>& b) {
    double sum = 0.0, difference = 0.0;
    std::size_t far = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
      const glm::vec3 d = glm::abs(glm::vec3(a[i]) - glm::vec3(b[i]));
      sum += a[i].r + a[i].g + a[i].b;
      difference += d.r + d.g + d.b;
      far += d.r > 0.1F * a[i].r + 0.01F ? 1 : 0;
    }
    return std::pair(difference / sum, static_cast<double>(far) / static_cast<double>(a.size()));
  };
  const auto whole = picture(fine);
  EXPECT_EQ(coarseFrames(), 0U);
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  while (coarseFrames() == 0 && std::chrono::steady_clock::now() < deadline)
    ASSERT_TRUE(m_renderer->renderFrame(coarse));
  const std::uint64_t before = coarseFrames();
  const auto fewer = picture(coarse);
  ASSERT_EQ(coarseFrames(), before + 1);
  const auto [mean, far] = apart(whole, fewer);
  std::printf("  %.4f of the light apart, %.4f of the pixels by more than a tenth\n", mean, far);
  EXPECT_GT(mean, 0.0) << "or it is the same picture";
  EXPECT_LT(mean, 0.008);
  EXPECT_LT(far, 0.005);

  // Another light, seen by the few vertices first: all of them have to follow.
  scene.scene.lights.back().intensity *= 3.0F;
  scene.scene.environment.exposureStops = -1.0F;
  EXPECT_LT(apart(picture(coarse), fewer).second, 1.0);
  const auto afterwards = picture(fine);
  EXPECT_GT(apart(afterwards, whole).first, 0.05) << "or the change says nothing";
  makeSoftwareRenderer();
  show(scene);
  EXPECT_EQ(afterwards, picture(fine));
}

// Light of many vertices is computed in several calls, so that a window answers between them. What is drawn in the end
// must be what one call draws, and nothing before that; a light that keeps changing must not keep the picture away.
TEST_F(MovingPicture, LightInSlicesIsTheSameLight) {
  makeSoftwareRenderer();
  ResolvedScene scene = everything();
  show(scene);
  const Window window(m_size);
  FrameRequest frame = movingFrame(scene, window);
  const auto frames = [&] { return m_renderer->statistics().frames; };
  // How many calls until there is a picture.
  const auto calls = [&](unsigned verticesAtOnce) {
    m_renderer->setScene(std::make_shared<ResolvedScene>(scene));
    frame.verticesAtOnce = verticesAtOnce;
    const std::uint64_t before = frames();
    for (int call = 1; call < 1000; ++call) {
      const bool drawn = m_renderer->renderFrame(frame);
      EXPECT_NE(drawn, m_renderer->lightIsPending());
      EXPECT_EQ(frames() - before, drawn ? 1U : 0U);
      if (drawn) return call;
    }
    return 1000;
  };
  const auto vertices = static_cast<int>(scene.model->positions.size());
  constexpr int kSlice = 10000;
  ASSERT_GT(vertices, 3 * kSlice);
  EXPECT_EQ(calls(kSlice), (vertices + kSlice - 1) / kSlice);
  const auto dim = window.read();
  EXPECT_EQ(calls(kSlice), 1) << "nothing has changed";
  scene.scene.environment.exposureStops = 1.0F;
  scene.scene.lights.back().intensity *= 2.0F;
  EXPECT_GT(calls(kSlice), 1);
  const auto inSlices = window.read();
  EXPECT_NE(inSlices, dim);

  // Changed in between: all of it at once.
  scene.scene.environment.exposureStops = 0.0F;
  m_renderer->setScene(std::make_shared<ResolvedScene>(scene));
  EXPECT_FALSE(m_renderer->renderFrame(frame));
  scene.scene.environment.exposureStops = 1.0F;
  EXPECT_EQ(calls(kSlice), 1);
  EXPECT_EQ(window.read(), inSlices);

  makeSoftwareRenderer();
  show(scene);
  EXPECT_EQ(calls(0), 1);
  EXPECT_EQ(window.read(), inSlices);
}

}  // namespace
}  // namespace dermis::test
