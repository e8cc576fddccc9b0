#include "passes/accumulate_pass.h"

namespace dermis {

void accumulatePass(const FrameContext& frame, bool first) {
  gl::ProgramSources sources;
  sources.vertex = "full_screen.vert";
  sources.fragment = "accumulate.frag";
  if (frame.useProgram(sources) == nullptr) return;
  glDisable(GL_DEPTH_TEST);
  (first ? glDisable : glEnable)(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);
  for (std::size_t i = 0; i < kSceneImageCount; ++i) {
    const auto image = static_cast<SceneImage>(i);
    if (!frame.targets.summed(image)) continue;
    // Numbers of materials don't add up: a pixel keeps the largest that touched it.
    glBlendEquation(image == SceneImage::Geometry ? GL_MAX : GL_FUNC_ADD);
    frame.targets.sumBuffer(image).bind();
    frame.targets.whole(image).bind(0);
    gl::drawFullScreen();
  }
  glBlendEquation(GL_FUNC_ADD);
  glDisable(GL_BLEND);
}

}  // namespace dermis
