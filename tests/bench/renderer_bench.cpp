// What the program spends its time on: loading, baking, a frame. `build/bin/dermis_bench`; figures in
// docs/benchmarks.md.
#include <benchmark/benchmark.h>
#include <epoxy/gl.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>

#include "core/builtin/default_look.h"
#include "core/builtin/environments.h"
#include "core/io/asset_loader.h"
#include "core/io/importer.h"
#include "core/scene/primitives.h"
#include "gl/headless_context.h"
#include "gl/offscreen_target.h"
#include "renderer.h"

namespace dermis {
namespace {

/// One context and renderer for all measurements, and a framebuffer to show pictures in.
class Stage {
 public:
  static Stage& get() {
    static Stage stage;
    return stage;
  }
  Renderer& renderer() { return *m_renderer; }
  unsigned framebuffer(glm::ivec2 size) {
    m_target = std::make_unique<gl::OffscreenTarget>(size);
    return m_target->framebuffer();
  }

 private:
  Stage() {
    auto context = gl::HeadlessContext::create();
    if (!context) fail(context.error());
    m_context = std::move(*context);
    RendererOptions options;
    options.platform = m_context->platform();
    auto renderer = Renderer::create(options);
    if (!renderer) fail(renderer.error());
    m_renderer = std::move(*renderer);
  }
  [[noreturn]] static void fail(const Error& error) {
    std::fprintf(stderr, "%s\n", error.message.c_str());
    std::exit(1);
  }

  std::unique_ptr<gl::HeadlessContext> m_context;
  std::unique_ptr<Renderer> m_renderer;
  std::unique_ptr<gl::OffscreenTarget> m_target;
};

std::shared_ptr<const ResolvedScene> resolved(const Scene& scene) {
  Warnings warnings;
  auto result = resolveScene(scene, {}, {}, warnings);
  return result ? std::make_shared<const ResolvedScene>(std::move(*result)) : nullptr;
}

/// The built-in sphere under the studio, with lights, in one shading model.
Scene sphereScene(ShadingModel model, int lights) {
  Scene scene;
  scene.model.builtin = "sphere";
  scene.materials["*"].material.model = model;
  for (int i = 0; i < lights; ++i) {
    Light light;
    light.position = {i % 2 == 0 ? 2.0F : -2.0F, i / 2 == 0 ? 2.0F : -2.0F, 3.0F};
    light.intensity = 5.0F;
    scene.lights.push_back(light);
  }
  return scene;
}

void drawFrames(benchmark::State& state, const Scene& scene) {
  Stage& stage = Stage::get();
  const auto look = resolved(scene);
  stage.renderer().setScene(look);
  if (!stage.renderer().finishJobs()) return state.SkipWithError("the scene is not drawable");
  FrameRequest frame;
  frame.size = {1280, 720};
  frame.camera = look->camera;
  frame.view = look->scene.view;
  frame.moving = true;
  frame.framebuffer = stage.framebuffer(frame.size);
  // What is made once (uploads, the display's table) is not the frame's.
  for (int i = 0; i < 2; ++i) stage.renderer().renderFrame(frame);
  glFinish();
  for ([[maybe_unused]] auto iteration : state) {
    frame.camera.position.x += 1e-3F;
    stage.renderer().renderFrame(frame);
    glFinish();
  }
}

void frameDefaultLook(benchmark::State& state) { drawFrames(state, defaultLook()); }
void frameSkin(benchmark::State& state) {
  drawFrames(state, sphereScene(ShadingModel::Skin, static_cast<int>(state.range(0))));
}
void frameThesis(benchmark::State& state) {
  drawFrames(state, sphereScene(ShadingModel::Thesis, static_cast<int>(state.range(0))));
}
BENCHMARK(frameDefaultLook)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();
BENCHMARK(frameSkin)->Arg(0)->Arg(4)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();
BENCHMARK(frameThesis)->Arg(4)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();

void bakeEnvironment(benchmark::State& state) {
  Stage& stage = Stage::get();
  Scene scene = defaultLook();
  for ([[maybe_unused]] auto iteration : state) {
    // Alternating, so that nothing is found resident; there is no cache folder.
    scene.environment.builtin = scene.environment.builtin == "studio" ? "overcast" : "studio";
    stage.renderer().setScene(resolved(scene));
    if (!stage.renderer().finishJobs()) return state.SkipWithError("the environment was not baked");
  }
}
BENCHMARK(bakeEnvironment)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();

void paintStudio(benchmark::State& state) {
  for ([[maybe_unused]] auto iteration : state) benchmark::DoNotOptimize(builtinEnvironment("studio"));
}
BENCHMARK(paintStudio)->Unit(benchmark::kMillisecond);

void buildSphere(benchmark::State& state) {
  for ([[maybe_unused]] auto iteration : state) benchmark::DoNotOptimize(makeSphere());
}
BENCHMARK(buildSphere)->Unit(benchmark::kMillisecond);

/// The sphere as an OBJ file with normals and UVs.
std::filesystem::path sphereFile(int segments) {
  const std::filesystem::path path = std::filesystem::temp_directory_path() / "dermis-bench-sphere.obj";
  const Model sphere = makeSphere(segments);
  std::ofstream file(path);
  for (const glm::vec3& p : sphere.positions) file << "v " << p.x << ' ' << p.y << ' ' << p.z << '\n';
  for (const glm::vec3& n : sphere.normals) file << "vn " << n.x << ' ' << n.y << ' ' << n.z << '\n';
  for (const glm::vec2& t : sphere.uvs) file << "vt " << t.x << ' ' << t.y << '\n';
  for (std::size_t i = 0; i + 2 < sphere.indices.size(); i += 3) {
    file << 'f';
    for (std::size_t k = 0; k < 3; ++k)
      file << ' ' << sphere.indices[i + k] + 1 << '/' << sphere.indices[i + k] + 1 << '/' << sphere.indices[i + k] + 1;
    file << '\n';
  }
  return path;
}

void loadObj(benchmark::State& state) {
  const auto module = importer();
  if (!module) return state.SkipWithError("no import module");
  const std::filesystem::path path = sphereFile(static_cast<int>(state.range(0)));
  for ([[maybe_unused]] auto iteration : state) {
    auto model = (*module)->loadModel(path);
    if (!model) return state.SkipWithError("the model does not load");
    state.counters["triangles"] = static_cast<double>(model->indices.size() / 3);
  }
  std::filesystem::remove(path);
}
BENCHMARK(loadObj)->Arg(320)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();

}  // namespace
}  // namespace dermis
