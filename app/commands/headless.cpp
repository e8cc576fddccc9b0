#include "app/commands/headless.h"

#include "core/io/disk_cache.h"

namespace dermis::cli {

Outcome<HeadlessRenderer> HeadlessRenderer::create(bool forBenchmark) {
  HeadlessRenderer headless;
  auto context = gl::HeadlessContext::create();
  if (!context) return failure(context.error());
  headless.m_context = std::move(*context);
  RendererOptions options;
  if (!forBenchmark) options.cacheFolder = userCacheFolder("bakes");
  options.timePassesAlone = forBenchmark;
  options.bakeMeshes = true;
  options.platform = headless.m_context->platform();
  auto renderer = Renderer::create(options);
  if (!renderer) return failure(renderer.error());
  headless.m_renderer = std::move(*renderer);
  return headless;
}

Outcome<void> finishJobs(Renderer& renderer, ProgressLine& progress) {
  constexpr double kSliceMs = 100.0;
  while (renderer.runJobs(kSliceMs)) {
    const auto [what, fraction] = renderer.jobProgress();
    progress.show(what, fraction);
  }
  progress.clear();
  const Result<void> finished = renderer.finishJobs();
  if (!finished) return failure(finished.error());
  return {};
}

}  // namespace dermis::cli
