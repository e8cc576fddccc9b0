#include "passes/vertex_light.h"

#include <algorithm>
#include <utility>

#include "passes/surface_pass.h"

namespace dermis {

namespace {

template <class T>
void append(std::vector<std::byte>& key, const T& value) {
  const auto bytes = bytesOf(value);
  key.insert(key.end(), bytes.begin(), bytes.end());
}

bool addsLamps(const ResolvedScene& scene, std::size_t slot, bool withLamps) {
  return withLamps && scene.slots[slot].material.model == ShadingModel::Skin;
}

/// All that a part's light is computed from, beside the vertices themselves.
std::vector<std::byte> keyOf(const FrameContext& frame, std::size_t slot, const FrameBlock& block,
                             std::uint64_t shadowRevision, bool withLamps) {
  std::vector<std::byte> key;
  append(key, block.units);
  append(key, block.lightCount);
  append(key, block.lights);
  append(key, block.environmentHarmonics);
  const SlotResources& resources = frame.resources.slots()[slot];
  append(key, resources.draw.meanAlbedo);
  if (!addsLamps(frame.scene, slot, withLamps)) return key;
  append(key, block.environmentScale);
  append(key, shadowRevision);
  append(key, resources.draw);
  // Of the material only what skin.glsl's farSideWithLamps asks: a slider that changes how it reflects keeps the
  // surface.
  const MaterialParameters& asked = frame.scene.slots[slot].material.parameters;
  append(key, asked.transmissionThicknessSource);
  append(key, asked.transmissionThicknessMinMm);
  append(key, asked.transmissionThicknessMaxMm);
  append(key, asked.transmissionNormalScale);
  append(key, resources.textures[static_cast<std::size_t>(TextureSlot::Thickness)].get());
  return key;
}

}  // namespace

gl::ProgramSources vertexLightProgram(const ResolvedScene& scene, std::size_t slot, bool withLamps) {
  gl::ProgramSources sources;
  sources.compute = "vertex_light.comp";
  if (!addsLamps(scene, slot, withLamps)) return forLampsOf(std::move(sources), scene);
  sources.defines = {"DERMIS_FAR_LAMPS", mapsDefine(presentMaps(scene, slot))};
  return withTiles(std::move(sources), readsTiles(scene, slot));
}

bool VertexLight::update(const FrameContext& frame, const FrameBlock& block, std::uint64_t shadowRevision,
                         bool withLamps) {
  const auto& parts = frame.scene.model->parts;
  if (m_geometryRevision != frame.resources.geometryRevision()) m_known.clear();
  m_geometryRevision = frame.resources.geometryRevision();
  m_known.resize(parts.size());
  const bool lit = withLamps && block.lightCount.x > 0;
  std::uint32_t allowed = frame.request.verticesAtOnce > 0 ? frame.request.verticesAtOnce : ~0U;
  bool any = false, complete = true;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    std::vector<std::byte> key = keyOf(frame, parts[i].slot, block, shadowRevision, lit);
    const int level = frame.levelOf(frame.resources.slots()[parts[i].slot]);
    const glm::uvec2 range = frame.resources.geometry().vertexRange(i, level);
    Known& known = m_known[i];
    const bool isGoingOn = key == known.key && known.missing > 0 && level == known.level;
    if (!isGoingOn && ((key == known.key && known.missing == 0 && known.level <= level) || range.y == 0)) continue;
    const gl::Program* program = frame.useProgram(vertexLightProgram(frame.scene, parts[i].slot, lit));
    if (program == nullptr) continue;
    // Changed again before all had it: whoever turns a light would never see a picture.
    if (!isGoingOn && known.missing > 0) allowed = ~0U;
    const std::uint32_t wanted = isGoingOn ? known.missing : range.y;
    const std::uint32_t count = std::min(wanted, allowed);
    allowed -= count;
    known = {std::move(key), level, wanted - count};
    complete = complete && known.missing == 0;
    if (count == 0) continue;
    if (!any) frame.resources.geometry().bindForLight();
    if (level > 0) frame.resources.geometry().bindCoarseVertices();
    any = true;
    frame.resources.bindSlot(frame.resources.slots()[parts[i].slot]);
    glUniform1ui(program->uniform("u_first"), range.x + range.y - wanted);
    glUniform1ui(program->uniform("u_count"), count);
    glUniform1i(program->uniform("u_listed"), level > 0 ? 1 : 0);
    glUniform1i(program->uniform("u_baked"), frame.resources.geometry().hasBake() ? 1 : 0);
    constexpr GLuint kGroup = 64;
    glDispatchCompute((count + kGroup - 1) / kGroup, 1, 1);
  }
  if (!any) return complete;
  ++m_revision;
  glMemoryBarrier(GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT);
  frame.resources.unbindSamplers();
  return complete;
}

}  // namespace dermis
