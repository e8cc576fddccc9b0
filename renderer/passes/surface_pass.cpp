#include "passes/surface_pass.h"

#include <algorithm>

namespace dermis {

namespace {

void drawPart(const FrameContext& frame, std::size_t index) {
  const ModelPart& part = frame.scene.model->parts[index];
  const SlotResources& slot = frame.resources.slots()[part.slot];
  const bool withAovs = frame.targets.images() != kBeautyOnly && !frame.multisampled;
  if (frame.useProgram(surfaceProgram(slot.model, withAovs)) == nullptr) return;
  frame.resources.bindSlot(slot);
  if (slot.kind == DrawKind::Opaque || slot.cullBackFaces) {
    (slot.cullBackFaces ? glEnable : glDisable)(GL_CULL_FACE);
    frame.resources.geometry().draw(part);
    return;
  }
  // A blended part that shows both sides: what is behind first.
  glEnable(GL_CULL_FACE);
  for (const GLenum hidden : {GL_FRONT, GL_BACK}) {
    glCullFace(hidden);
    frame.resources.geometry().draw(part);
  }
}

}  // namespace

gl::ProgramSources surfaceProgram(ShadingModel model, bool withAovs) {
  gl::ProgramSources sources;
  sources.vertex = "surface.vert";
  sources.fragment = "surface.frag";
  sources.defines = {"DERMIS_MODEL \"models/" + std::string(shadingModelRow(model).id) + ".glsl\""};
  if (withAovs) sources.defines.emplace_back("DERMIS_AOVS");
  return sources;
}

void surfacePass(const FrameContext& frame) {
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_GREATER);
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
  glCullFace(GL_BACK);
  frame.resources.geometry().bind();
  const auto& parts = frame.scene.model->parts;
  for (std::size_t i = 0; i < parts.size(); ++i)
    if (frame.resources.slots()[parts[i].slot].kind == DrawKind::Opaque) drawPart(frame, i);
  frame.resources.unbindSamplers();
}

bool hasTransparentParts(const SceneResources& resources) {
  return std::any_of(resources.slots().begin(), resources.slots().end(),
                     [](const SlotResources& slot) { return slot.kind != DrawKind::Opaque; });
}

void transparentPass(const FrameContext& frame) {
  const auto& parts = frame.scene.model->parts;
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < parts.size(); ++i)
    if (frame.resources.slots()[parts[i].slot].kind != DrawKind::Opaque) order.push_back(i);
  const auto depthOf = [&](std::size_t i) {
    return glm::dot(frame.resources.geometry().partCentres()[i] - frame.camera.position, frame.camera.forward);
  };
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return depthOf(a) > depthOf(b); });

  // Premultiplied "over": what is drawn, plus what is behind times what it leaves uncovered.
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  glDepthMask(GL_FALSE);
  frame.resources.geometry().bind();
  for (const std::size_t i : order) {
    const bool seed = frame.resources.slots()[parts[i].slot].kind == DrawKind::SeedBlended;
    (seed ? glDisable : glEnable)(GL_DEPTH_TEST);
    glCullFace(GL_BACK);
    drawPart(frame, i);
  }
  glCullFace(GL_BACK);
  glDisable(GL_CULL_FACE);
  glDisable(GL_BLEND);
  glDepthMask(GL_TRUE);
  glEnable(GL_DEPTH_TEST);
  frame.resources.unbindSamplers();
}

}  // namespace dermis
