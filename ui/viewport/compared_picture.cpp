#include "ui/viewport/compared_picture.h"

#include <algorithm>

namespace dermis {

Result<std::unique_ptr<ComparedPicture>> ComparedPicture::create(const RendererOptions& options) {
  Result<std::unique_ptr<Renderer>> renderer = Renderer::create(options);
  if (!renderer) return tl::unexpected(renderer.error());
  return std::unique_ptr<ComparedPicture>(new ComparedPicture(std::move(*renderer)));
}

void ComparedPicture::show(std::shared_ptr<const ResolvedScene> scene) {
  m_scene = std::move(scene);
  m_renderer->setScene(m_scene);
}

bool ComparedPicture::draw(FrameRequest request, int column) {
  if (!m_scene || column >= request.displaySize.x) return false;
  request.view = m_scene->scene.view;
  request.displayColumns = {std::max(column, 0), request.displaySize.x};
  return m_renderer->renderFrame(request);
}

}  // namespace dermis
