// A renderer without a window, for the commands.
#pragma once

#include <memory>

#include "app/commands/support.h"
#include "gl/headless_context.h"
#include "renderer.h"

namespace dermis::cli {

/// Owns an OpenGL context without a display and the renderer in it; the renderer goes first.
class HeadlessRenderer {
 public:
  /// `forBenchmark`: environments are baked anew and not kept, and passes are timed one by one. Fails with 1 where
  /// there is no OpenGL 4.5.
  [[nodiscard]] static Outcome<HeadlessRenderer> create(bool forBenchmark = false);

  [[nodiscard]] Renderer& operator*() const { return *m_renderer; }
  [[nodiscard]] Renderer* operator->() const { return m_renderer.get(); }

 private:
  std::unique_ptr<gl::HeadlessContext> m_context;
  std::unique_ptr<Renderer> m_renderer;
};

/// Bakes what the scene needs, with progress. Fails with 1 (a shader that doesn't compile).
[[nodiscard]] Outcome<void> finishJobs(Renderer& renderer, ProgressLine& progress);

}  // namespace dermis::cli
