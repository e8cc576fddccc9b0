// The other half of a split view: a scene that stays as it is, drawn with the same camera by a renderer of its own in
// the viewport's context.
#pragma once

#include <memory>

#include "renderer.h"

namespace dermis {

class ComparedPicture {
 public:
  /// Needs the context current, as all methods do. Errors: Runtime.
  [[nodiscard]] static Result<std::unique_ptr<ComparedPicture>> create(const RendererOptions& options);

  void show(std::shared_ptr<const ResolvedScene> scene);
  /// Draws what belongs to the columns from `column` on. The camera is the request's.
  bool draw(FrameRequest request, int column);
  /// Draws the first half of it.
  void begin(const FrameRequest& request) { m_renderer->beginFrame(request); }
  /// A slice of what is queued; true while something is left.
  bool runJobs(double budgetMs) { return m_renderer->runJobs(budgetMs); }
  [[nodiscard]] bool jobsAreQueued() const { return m_renderer->jobsAreQueued(); }
  [[nodiscard]] bool accumulating() const { return m_renderer->accumulating(); }
  [[nodiscard]] const ResolvedScene* scene() const { return m_scene.get(); }
  [[nodiscard]] Renderer& renderer() { return *m_renderer; }

 private:
  explicit ComparedPicture(std::unique_ptr<Renderer> renderer) : m_renderer(std::move(renderer)) {}
  std::unique_ptr<Renderer> m_renderer;
  std::shared_ptr<const ResolvedScene> m_scene;
};

}  // namespace dermis
