#include "passes/subsurface_pass.h"

#include <array>
#include <utility>

namespace dermis {

namespace {

gl::ProgramSources program(const char* fragment) {
  gl::ProgramSources sources;
  sources.vertex = "full_screen.vert";
  sources.fragment = fragment;
  return sources;
}

/// Units of the images, beside those of the light and the shadow maps.
constexpr GLuint kEnteringUnit = 21, kGeometryUnit = 22, kDepthUnit = 23, kSpreadUnit = 27, kExitUnit = 28;

}  // namespace

std::vector<gl::ProgramSources> subsurfacePrograms(DiffusionQuality quality, std::size_t profiles) {
  if (profiles == 0) return {program("subsurface/compose.frag")};
  if (quality == DiffusionQuality::Disc) return {program("subsurface/disc.frag")};
  gl::ProgramSources first = program("subsurface/separable.frag");
  // With one profile no tap needs to look whose it is: what doesn't diffuse has no share.
  if (profiles == 1) first.defines.emplace_back("DERMIS_ONE_PROFILE");
  gl::ProgramSources second = first;
  first.defines.emplace_back("DERMIS_FIRST");
  return {std::move(first), std::move(second)};
}

void subsurfacePass(const FrameContext& frame, DiffusionQuality quality) {
  const DiffusionKernels& kernels = frame.resources.kernels();
  const std::size_t profiles = frame.request.withoutSubsurface ? 0 : kernels.count();
  const PixelArea area = screenArea(frame.camera, frame.scene.model->bounds, frame.size());
  const glm::ivec2 extent = area.upper - area.lower;
  const RenderTargets& targets = frame.targets;
  targets.image(SceneImage::Entering).bind(kEnteringUnit);
  targets.image(SceneImage::Geometry).bind(kGeometryUnit);
  targets.depth().bind(kDepthUnit);
  targets.image(SceneImage::Exit).bind(kExitUnit);
  if (profiles > 0) kernels.bind();
  // Only where the model is: the triangle lies on the far plane. The depth is read by shaders too, and never written.
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  glDepthMask(GL_FALSE);
  glDisable(GL_CULL_FACE);
  glDisable(GL_BLEND);
  glEnable(GL_SCISSOR_TEST);
  glScissor(area.lower.x, area.lower.y, extent.x, extent.y);
  const std::vector<gl::ProgramSources> programs = subsurfacePrograms(quality, profiles);
  if (programs.size() > 1 && frame.useProgram(programs.front()) != nullptr) {
    targets.spreading().bind();
    // What an earlier frame left where the model isn't any more would pass for a neighbour.
    const std::array<GLfloat, 4> nothing = {0.0F, 0.0F, 0.0F, 0.0F};
    glClearBufferfv(GL_COLOR, 0, nothing.data());
    gl::drawFullScreen();
    targets.spread().bind(kSpreadUnit);
  }
  if (frame.useProgram(programs.back()) != nullptr) {
    // Added to what the picture has already; the other two images are new.
    targets.composed().bind();
    glEnablei(GL_BLEND, 0);
    glBlendFunci(0, GL_ONE, GL_ONE);
    gl::drawFullScreen();
    glDisablei(GL_BLEND, 0);
  }
  glDisable(GL_SCISSOR_TEST);
  glDepthFunc(GL_GREATER);
  glDepthMask(GL_TRUE);
}

}  // namespace dermis
