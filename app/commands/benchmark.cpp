// dermis benchmark: what loading, baking and a frame cost on this machine.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <fstream>
#include <functional>
#include <map>
#include <memory>
#include <optional>

#include "app/commands/commands.h"
#include "app/commands/headless.h"
#include "app/commands/look.h"
#include "core/base/json_text.h"
#include "core/io/importer.h"
#include "core/io/png_writer.h"
#include "gl/offscreen_target.h"

namespace dermis::cli {
namespace {

struct BenchmarkOptions {
  LookOptions look;
  std::string size = "1280x720";
  int frames = 30;
  bool json = false;
  std::string picture;  ///< of the last moving frame
};

struct Cost {
  double wallMs = 0.0, cpuMs = 0.0;
};

/// Wall and CPU milliseconds (all threads) of what `work` does.
Cost measured(const std::function<void()>& work) {
  const double cpu = cpuSeconds();
  const auto start = std::chrono::steady_clock::now();
  work();
  return {std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count(),
          1e3 * (cpuSeconds() - cpu)};
}

double rounded(double ms) { return std::round(ms * 1000.0) / 1000.0; }
Json costJson(const Cost& cost) { return {{"wall_ms", rounded(cost.wallMs)}, {"cpu_ms", rounded(cost.cpuMs)}}; }

/// Resident memory in MiB, from the kernel's own count.
double residentMiB() {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;)
    if (word == "VmRSS:") {
      double kilobytes = 0.0;
      status >> kilobytes;
      return kilobytes / 1024.0;
    }
  return 0.0;
}

/// A camera that turns a little: what a drag does, nothing can be kept from the frame before.
void turnCamera(FrameRequest& frame, int /*index*/) { frame.camera.position.x += 1e-3F; }

/// Draws `frames` frames, each after its `step`, and returns the mean cost of one, and of its passes.
Cost drawFrames(Renderer& renderer, FrameRequest frame, int frames, const std::function<void(FrameRequest&, int)>& step,
                Json* passes) {
  std::map<std::string, std::pair<double, double>> sums;
  std::vector<std::string> order;
  const Cost total = measured([&] {
    for (int i = 0; i < frames; ++i) {
      step(frame, i);
      renderer.renderFrame(frame);
      // Asking for the times waits for the frame.
      for (const PassTime& pass : renderer.passTimes()) {
        const auto [it, added] = sums.try_emplace(pass.name);
        if (added) order.push_back(pass.name);
        it->second.first += pass.gpuMs;
        it->second.second += pass.cpuMs;
      }
    }
  });
  if (passes != nullptr)
    for (const std::string& name : order)
      (*passes)[name] = {{"gpu_ms", rounded(sums[name].first / frames)},
                         {"cpu_ms", rounded(sums[name].second / frames)}};
  return {total.wallMs / frames, total.cpuMs / frames};
}

/// Until frames are drawn with fewer triangles, where the model has any to spare: they are made beside the frames.
void awaitCoarse(Renderer& renderer, const FrameRequest& reduced) {
  const auto start = std::chrono::steady_clock::now();
  while (renderer.statistics().coarseFrames == 0 && std::chrono::steady_clock::now() - start < std::chrono::seconds(2))
    renderer.renderFrame(reduced);
}

Outcome<int> benchmark(const BenchmarkOptions& options) {
  const Outcome<glm::ivec2> size = parseSize(options.size);
  if (!size) return tl::unexpected(size.error());
  ProgressLine progress(!options.json);
  Warnings warnings;
  Json json;

  std::optional<Outcome<Look>> look;
  const Cost load = measured([&] { look.emplace(resolveLook(options.look, progress, warnings)); });
  printWarnings(warnings);
  if (!*look) return tl::unexpected(look->error());

  std::optional<Outcome<HeadlessRenderer>> headless;
  const Cost start = measured([&] { headless.emplace(HeadlessRenderer::create(true)); });
  if (!*headless) return tl::unexpected(headless->error());
  Renderer& renderer = ***headless;
  const GlInfo& gl = renderer.glInfo();

  renderer.setScene(std::make_shared<const ResolvedScene>((*look)->resolved));
  Outcome<void> baked;
  const Cost bake = measured([&] { baked = finishJobs(renderer, progress); });
  if (!baked) return tl::unexpected(baked.error());

  FrameRequest frame;
  frame.size = *size;
  frame.camera = (*look)->resolved.camera;
  frame.view = (*look)->resolved.scene.view;
  frame.moving = true;
  const gl::OffscreenTarget window(frame.size);
  frame.framebuffer = window.framebuffer();
  const Cost first = drawFrames(renderer, frame, 1, turnCamera, nullptr);
  Json passes = Json::object(), halfPasses = Json::object(), stillPasses = Json::object();
  const Cost moving = drawFrames(renderer, frame, options.frames, turnCamera, &passes);
  // What a viewport does that can't keep pace: half the side, shown as large as before.
  FrameRequest reduced = frame;
  reduced.displaySize = frame.size;
  reduced.size = glm::max(frame.size / 2, glm::ivec2(1));
  awaitCoarse(renderer, reduced);
  const Cost half = drawFrames(renderer, reduced, options.frames, turnCamera, &halfPasses);
  const std::uint64_t compiled = renderer.statistics().programsCompiled;
  const auto turnRoughness = [&](FrameRequest& /*request*/, int i) {
    auto changed = std::make_shared<ResolvedScene>((*look)->resolved);
    for (ResolvedMaterial& slot : changed->slots)
      slot.material.parameters.specularPerceptualRoughness =
          0.3F + 0.3F * static_cast<float>(i) / static_cast<float>(options.frames);
    renderer.setScene(std::move(changed));
  };
  const Cost slider = drawFrames(renderer, frame, options.frames, turnRoughness, nullptr);
  const Cost halfSlider = drawFrames(renderer, reduced, options.frames, turnRoughness, nullptr);
  const std::uint64_t compiledBySlider = renderer.statistics().programsCompiled - compiled;
  renderer.setScene(std::make_shared<const ResolvedScene>((*look)->resolved));
  if (!options.picture.empty()) {
    renderer.renderFrame(frame);
    if (auto written = writePng(options.picture, window.read(), {}); !written) return failure(written.error());
  }
  frame.moving = false;
  frame.targetSamples = 1;
  const Cost still = drawFrames(renderer, frame, std::max(1, options.frames / 3), turnCamera, &stillPasses);
  warnings = renderer.takeMessages();
  printWarnings(warnings);
  const RenderStatistics statistics = renderer.statistics();

  json["version"] = DERMIS_VERSION;
  json["gl"] = {{"platform", gl.platform},
                {"vendor", gl.vendor},
                {"renderer", gl.renderer},
                {"version", gl.version},
                {"software", gl.software}};
  json["size"] = {size->x, size->y};
  json["frames"] = options.frames;
  json["triangles"] = (*look)->resolved.model->indices.size() / 3;
  json["load"] = costJson(load);
  json["start_gl"] = costJson(start);
  json["bake"] = costJson(bake);
  json["first_frame"] = costJson(first);
  json["frame_moving"] = costJson(moving);
  json["frame_moving"]["passes"] = passes;
  json["frame_reduced"] = costJson(half);
  json["frame_reduced"]["passes"] = halfPasses;
  json["frame_reduced"]["slider"] = costJson(halfSlider);
  json["frame_slider"] = costJson(slider);
  json["frame_slider"]["programs_compiled"] = compiledBySlider;
  json["frame_still"] = costJson(still);
  json["frame_still"]["passes"] = stillPasses;
  json["programs_compiled"] = statistics.programsCompiled;
  json["import_module_loaded"] = importerLoaded();
  json["resident_mib"] = rounded(residentMiB());
  if (options.json) {
    fmt::print("{}\n", json.dump(2));
    return kDone;
  }
  const auto line = [](std::string_view what, const Cost& cost) {
    fmt::print("{:<24}{:>10.2f} ms{:>10.2f} ms CPU\n", what, cost.wallMs, cost.cpuMs);
  };
  const auto passLines = [](const Json& of) {
    for (const auto& [name, cost] : of.items())
      fmt::print("  {:<22}{:>10.2f} ms GPU{:>9.2f} ms CPU\n", name, cost["gpu_ms"].get<double>(),
                 cost["cpu_ms"].get<double>());
  };
  fmt::print("{}, {}\n{} triangles at {}x{}\n", gl.renderer, gl.version, json["triangles"].get<std::size_t>(), size->x,
             size->y);
  line("load", load);
  line("start OpenGL", start);
  line("bake light and mesh", bake);
  line("first frame", first);
  line("frame while moving", moving);
  passLines(passes);
  line("frame as a slider moves", slider);
  line("moving, half the side", half);
  passLines(halfPasses);
  line("slider, half the side", halfSlider);
  line("one still sample", still);
  passLines(stillPasses);
  fmt::print("{:<24}{:>10.1f} MiB\n", "resident memory", residentMiB());
  return kDone;
}

}  // namespace

void addBenchmark(CLI::App& root, Action& action) {
  auto options = std::make_shared<BenchmarkOptions>();
  CLI::App* command = root.add_subcommand("benchmark", "Measure load, bake and frame times of a look");
  addLookOptions(*command, options->look);
  command->add_option("--size", options->size, "Pixels, 1280x720 by default")->type_name("WxH");
  command->add_option("--frames", options->frames, "Frames to average over, 30 by default")
      ->type_name("N")
      ->check(CLI::Range(1, 100000));
  command->add_flag("--json", options->json, "As JSON");
  command->add_option("-o,--output", options->picture, "Write the last moving frame, a PNG")->type_name("PNG");
  command->footer(R"(
Examples:
  dermis benchmark
  dermis benchmark --model head.glb --environment studio.hdr --json

The slider is the roughness of every material, the camera at rest. Environments are baked anew, whatever the cache holds. Milliseconds of CPU count all threads: on a software
renderer they are the figure to compare.)");
  command->callback([options, &action] { action = [options] { return benchmark(*options); }; });
}

}  // namespace dermis::cli
