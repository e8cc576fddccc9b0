#include "passes/subsurface_pass.h"

namespace dermis {

gl::ProgramSources composeProgram() {
  gl::ProgramSources sources;
  sources.vertex = "full_screen.vert";
  sources.fragment = "subsurface/compose.frag";
  return sources;
}

void subsurfacePass(const FrameContext& frame) {
  if (frame.useProgram(composeProgram()) == nullptr) return;
  const PixelArea area = screenArea(frame.camera, frame.scene.model->bounds, frame.request.size);
  const glm::ivec2 extent = area.upper - area.lower;
  const RenderTargets& targets = frame.targets;
  targets.composed().bind();
  targets.image(SceneImage::Entering).bind(0);
  targets.image(SceneImage::Exit).bind(1);
  targets.depth().bind(2);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  glEnable(GL_SCISSOR_TEST);
  glScissor(area.lower.x, area.lower.y, extent.x, extent.y);
  // Added to what the picture has already; the other two images are new.
  glEnablei(GL_BLEND, 0);
  glBlendFunci(0, GL_ONE, GL_ONE);
  gl::drawFullScreen();
  glDisablei(GL_BLEND, 0);
  glDisable(GL_SCISSOR_TEST);
}

}  // namespace dermis
