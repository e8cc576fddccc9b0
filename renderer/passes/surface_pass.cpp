#include "passes/surface_pass.h"

#include <algorithm>
#include <array>

#include "passes/displacement.h"

namespace dermis {

namespace {

SurfaceOutputs outputsOf(const FrameContext& frame, bool blended) {
  if (frame.multisampled) return SurfaceOutputs::Picture;
  return surfaceOutputs(frame.scene, (frame.targets.images() & ~kSplit) != 0, blended);
}

/// Draws with `program` in use and the slot bound.
void drawTriangles(const FrameContext& frame, const gl::Program& program, std::size_t index) {
  const ModelPart& part = frame.scene.model->parts[index];
  const SlotResources& slot = frame.resources.slots()[part.slot];
  const Geometry& geometry = frame.resources.geometry();
  if (!slot.displaced) {
    geometry.drawPart(index, frame.levelOf(slot), *frame.scene.model);
    return;
  }
  drawDisplaced(
      program, slot, geometry, index,
      displacementView(frame.camera, frame.size(), pixelsPerPiece(frame.request.moving, frame.resources.isSoftware())));
}

/// Whether a part's back faces can be left out: where its material shows one side only, and where none is seen because
/// the part bounds solids and the camera stands outside. Half of a dense mesh's cost is the half that looks away.
bool leavesOutBackFaces(const FrameContext& frame, std::size_t index) {
  const SlotResources& slot = frame.resources.slots()[frame.scene.model->parts[index].slot];
  if (slot.cullBackFaces) return true;
  const Geometry& geometry = frame.resources.geometry();
  if (slot.kind != DrawKind::Opaque || slot.displaced || slot.hasCutOuts || !geometry.boundsSolids(index)) return false;
  const Bounds& bounds = geometry.partBounds()[index];
  const glm::vec3 position = frame.camera.position;
  return glm::any(glm::lessThan(position, bounds.min)) || glm::any(glm::greaterThan(position, bounds.max));
}

void drawPart(const FrameContext& frame, std::size_t index) {
  const ModelPart& part = frame.scene.model->parts[index];
  const SlotResources& slot = frame.resources.slots()[part.slot];
  const SurfaceOutputs outputs = outputsOf(frame, slot.kind != DrawKind::Opaque);
  gl::ProgramSources sources = withTiles(surfaceProgram(slot.model, outputs, slot.constantMaps), slot.tiled);
  const gl::Program* program = frame.useProgram(slot.displaced ? tessellated(std::move(sources)) : sources);
  if (program == nullptr) return;
  frame.resources.bindSlot(slot);
  if (slot.kind == DrawKind::Opaque || slot.cullBackFaces) {
    (leavesOutBackFaces(frame, index) ? glEnable : glDisable)(GL_CULL_FACE);
    drawTriangles(frame, *program, index);
    return;
  }
  // A blended part that shows both sides: what is behind first.
  glEnable(GL_CULL_FACE);
  for (const GLenum hidden : {GL_FRONT, GL_BACK}) {
    glCullFace(hidden);
    frame.resources.geometry().draw(part);
  }
}

/// What hides is near, nothing blends; the model's triangles are bound.
void beginOpaque(const FrameContext& frame) {
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_GREATER);
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
  glCullFace(GL_BACK);
  frame.resources.geometry().bind();
}

constexpr const char* kGradients = "DERMIS_GRADIENTS";  // how far a map moves from pixel to pixel is kept

}  // namespace

std::string mapsDefine(int maps) { return "DERMIS_MAPS " + std::to_string(maps); }

bool isSplit(const ResolvedScene& scene) {
  return std::any_of(scene.slots.begin(), scene.slots.end(), [](const ResolvedMaterial& slot) {
    return slot.material.model == ShadingModel::Skin || slot.material.model == ShadingModel::Eye;
  });
}

SurfaceOutputs surfaceOutputs(const ResolvedScene& scene, bool withAovs, bool blended) {
  if (withAovs) return blended ? SurfaceOutputs::BlendedEverything : SurfaceOutputs::Everything;
  return isSplit(scene) && !blended ? SurfaceOutputs::Split : SurfaceOutputs::Picture;
}

gl::ProgramSources surfaceProgram(ShadingModel model, SurfaceOutputs outputs, std::optional<int> constantMaps) {
  gl::ProgramSources sources;
  sources.vertex = "surface.vert";
  sources.fragment = "surface.frag";
  sources.defines = {"DERMIS_MODEL \"models/" + std::string(shadingModelRow(model).id) + ".glsl\""};
  if (outputs == SurfaceOutputs::Split || outputs == SurfaceOutputs::Everything)
    sources.defines.emplace_back("DERMIS_SPLIT");
  if (outputs == SurfaceOutputs::Everything) sources.defines.emplace_back("DERMIS_AOVS");
  if (outputs == SurfaceOutputs::BlendedEverything) sources.defines.emplace_back("DERMIS_BLENDED_AOVS");
  const bool readsMaps =
      model != ShadingModel::Reflection && model != ShadingModel::MicrofacetLab && model != ShadingModel::Lens;
  if (constantMaps && readsMaps) sources.defines.push_back(mapsDefine(*constantMaps));
  return sources;
}

gl::ProgramSources forLampsOf(gl::ProgramSources sources, const ResolvedScene& scene) {
  if (std::ranges::none_of(scene.scene.lights, &Light::enabled)) sources.defines.emplace_back("DERMIS_NO_LAMPS");
  return sources;
}

void surfacePass(const FrameContext& frame) {
  beginOpaque(frame);
  const auto& parts = frame.scene.model->parts;
  for (std::size_t i = 0; i < parts.size(); ++i)
    if (frame.resources.slots()[parts[i].slot].kind == DrawKind::Opaque) drawPart(frame, i);
  frame.resources.unbindSamplers();
}

gl::ProgramSources geometryProgram(bool moving, bool displaced) {
  gl::ProgramSources sources;
  sources.vertex = "surface.vert";
  sources.fragment = "geometry.frag";
  if (!moving) sources.defines = {std::string(kGradients)};
  return displaced ? tessellated(std::move(sources)) : sources;
}

gl::ProgramSources deferredProgram(const ResolvedScene& scene, std::size_t slot, bool moving, SurfaceOutputs outputs) {
  gl::ProgramSources sources = surfaceProgram(scene.slots[slot].material.model, outputs, presentMaps(scene, slot));
  sources.vertex = "full_screen.vert";
  sources.defines.emplace_back("DERMIS_DEFERRED");
  sources.defines.emplace_back(moving ? "DERMIS_MOVING" : kGradients);
  return forLampsOf(withTiles(std::move(sources), readsTiles(scene, slot)), scene);
}

bool deferringPays(const ResolvedScene& scene) {
  constexpr std::size_t kMostParts = 4;  // each costs a look at every pixel of the model's rectangle
  constexpr std::size_t kLeastTriangles = 8000;
  std::size_t opaque = 0;
  for (const ModelPart& part : scene.model->parts) {
    const Material& material = scene.slots[part.slot].material;
    if (hasCutOuts(material)) return false;
    opaque += isBlended(material) ? 0 : 1;
  }
  return opaque > 0 && opaque <= kMostParts && scene.model->indices.size() / 3 >= kLeastTriangles;
}

void geometryPass(const FrameContext& frame) {
  const auto& parts = frame.scene.model->parts;
  const auto& slots = frame.resources.slots();
  // Zero in the tangent's image says that nothing is there.
  const std::array<GLfloat, 4> nothing = {0.0F, 0.0F, 0.0F, 0.0F};
  const gl::Framebuffer& surfaces = frame.targets.surfaces(frame.request.moving);
  glClearNamedFramebufferfv(surfaces.id(), GL_COLOR, 1, nothing.data());
  surfaces.bind();
  beginOpaque(frame);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const SlotResources& slot = slots[parts[i].slot];
    if (slot.kind != DrawKind::Opaque) continue;
    const gl::Program* program = frame.useProgram(
        withTiles(geometryProgram(frame.request.moving, slot.displaced), slot.displaced && slot.tiled));
    if (program == nullptr) continue;
    frame.resources.bindSlot(slot);
    (leavesOutBackFaces(frame, i) ? glEnable : glDisable)(GL_CULL_FACE);
    glUniform1i(program->uniform("u_slot"), static_cast<GLint>(parts[i].slot));
    drawTriangles(frame, *program, i);
  }
}

void shadingPass(const FrameContext& frame) {
  const auto& slots = frame.resources.slots();
  frame.targets.scene().bind();
  frame.targets.bindSurfaces(frame.request.moving);
  // Only where the model is: the triangle lies on the far plane. The depth is read by the shader too, and not written.
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  glDepthMask(GL_FALSE);
  glDisable(GL_CULL_FACE);
  glEnable(GL_SCISSOR_TEST);
  const auto& parts = frame.scene.model->parts;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const ModelPart& part = parts[i];
    const SlotResources& slot = slots[part.slot];
    if (slot.kind != DrawKind::Opaque) continue;
    // Programs run for pixels of other slots too before they find out.
    const Bounds& bounds = slot.displaced ? frame.resources.bounds() : frame.resources.geometry().partBounds()[i];
    const PixelArea area = screenArea(frame.camera, bounds, frame.size());
    const glm::ivec2 extent = area.upper - area.lower;
    glScissor(area.lower.x, area.lower.y, extent.x, extent.y);
    const gl::Program* program =
        frame.useProgram(deferredProgram(frame.scene, part.slot, frame.request.moving, outputsOf(frame, false)));
    if (program == nullptr) continue;
    glUniform1i(program->uniform("u_slot"), static_cast<GLint>(part.slot));
    frame.resources.bindSlot(slot);
    gl::drawFullScreen();
  }
  glDisable(GL_SCISSOR_TEST);
  glDepthFunc(GL_GREATER);
  glDepthMask(GL_TRUE);
  frame.resources.unbindSamplers();
}

bool hasTransparentParts(const SceneResources& resources) {
  return std::any_of(resources.slots().begin(), resources.slots().end(),
                     [](const SlotResources& slot) { return slot.kind != DrawKind::Opaque; });
}

std::vector<PixelArea> transparentAreas(const FrameContext& frame) {
  const auto& parts = frame.scene.model->parts;
  std::vector<PixelArea> areas;
  for (std::size_t i = 0; i < parts.size(); ++i)
    if (frame.resources.slots()[parts[i].slot].kind != DrawKind::Opaque)
      areas.push_back(screenArea(frame.camera, frame.resources.geometry().partBounds()[i], frame.size()));
  return areas;
}

void transparentPass(const FrameContext& frame) {
  const auto& parts = frame.scene.model->parts;
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < parts.size(); ++i)
    if (frame.resources.slots()[parts[i].slot].kind != DrawKind::Opaque) order.push_back(i);
  const auto depthOf = [&](std::size_t i) {
    return glm::dot(frame.resources.geometry().partBounds()[i].centre() - frame.camera.position, frame.camera.forward);
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
