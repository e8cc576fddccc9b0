#include "passes/shadow_pass.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "passes/displacement.h"

namespace dermis {

namespace {

constexpr GLuint kUnit = 24;
constexpr float kSlack = 0.12F;  // a moving camera's windows are wider by that much on each side
constexpr float kWidest = 1.7F;  // and are drawn anew when they have become that much too wide
constexpr std::size_t kTrianglesASample =
    400000;  // drawn into maps for one sample of a viewport's picture, on software GL

/// What models that are lit through layered.glsl ask: the published shaders have no shadows.
bool receives(ShadingModel model) {
  return model == ShadingModel::Skin || model == ShadingModel::Eye || model == ShadingModel::Lens ||
         model == ShadingModel::MetallicRoughness;
}

/// Scene units that a pixel covers on the nearest part of the model.
float pixelSize(const FrameContext& frame) {
  const Camera& camera = frame.request.camera;
  const auto rows = static_cast<float>(frame.request.size.y);
  if (camera.orthographicHeight) return *camera.orthographicHeight / rows;
  const Bounds& bounds = frame.scene.model->bounds;
  const float distance =
      std::max(glm::length(bounds.centre() - frame.camera.position) - 0.5F * bounds.radius(), 0.05F * bounds.radius());
  return 2.0F * std::tan(0.5F * glm::radians(camera.verticalFovDegrees)) * distance / rows;
}

/// Digits of `index` in a base, mirrored at the point (Halton 1960).
float radicalInverse(int base, int index) {
  double value = 0.0, digit = 1.0;
  for (int i = index; i > 0; i /= base) {
    digit /= base;
    value += digit * (i % base);
  }
  return static_cast<float>(value);
}

/// Evenly spread shifts of the texel grid, −½..½, in bases that have nothing to do with the steps of pixels (R2) and of
/// light points (base 2).
glm::vec2 shiftOf(int index) { return {radicalInverse(3, index) - 0.5F, radicalInverse(5, index) - 0.5F}; }

ShadowWindow widened(ShadowWindow window, float share) {
  const glm::vec2 margin = share * window.extent();
  window.lower -= margin;
  window.upper += margin;
  return window;
}

}  // namespace

gl::ProgramSources casterProgram(bool hasCutOuts) {
  gl::ProgramSources sources;
  sources.vertex = "shadow.vert";
  sources.fragment = "shadow.frag";
  if (hasCutOuts) sources.defines.emplace_back("DERMIS_CUT_OUTS");
  return sources;
}

ShadowPass::ShadowPass(bool software)
    : m_software(software),
      m_maps(gl::Texture::create(
          {.target = GL_TEXTURE_2D_ARRAY, .format = GL_DEPTH_COMPONENT32F, .label = "no shadow maps"})),
      m_framebuffer(gl::Framebuffer::create("shadow map")),
      m_blockBuffer(gl::Buffer::writable("shadow block", sizeof(ShadowBlock))) {
  glNamedFramebufferDrawBuffer(m_framebuffer.id(), GL_NONE);
  glNamedFramebufferReadBuffer(m_framebuffer.id(), GL_NONE);
}

void ShadowPass::draw(const FrameContext& frame, const ShadowSample& sample, RenderStatistics& statistics) {
  std::vector<Light> lights;
  for (const Light& light : frame.scene.scene.lights)
    if (light.enabled && lights.size() < kMaxLights) lights.push_back(animated(light, frame.request.seconds));
  if (lights.empty()) {
    // Nothing has to be known of the model, which takes as long as drawing it.
    m_points.clear();
    m_faces.clear();
    m_turn = 0;
    upload(sample, 0.0F);
    return;
  }
  readGeometry(frame);
  if (lights.size() != m_points.size()) {
    m_points.assign(lights.size(), {});
    m_faces.assign(lights.size(), {});
    m_fresh.assign(lights.size(), false);
    m_taken.assign(lights.size(), 0);
  }
  const bool asked = std::any_of(frame.resources.slots().begin(), frame.resources.slots().end(),
                                 [](const SlotResources& slot) { return receives(slot.model); });

  // Which lights move on: all of them in the first sample and where there is time, else one after the other.
  if (sample.index == 0) std::fill(m_taken.begin(), m_taken.end(), 0);
  const bool first = sample.moving || sample.index == 0;
  std::size_t budget = lights.size();
  if (!first && !sample.thorough && m_software)
    budget = std::clamp<std::size_t>(kTrianglesASample * 3 / std::max<std::size_t>(m_model->indices.size(), 1), 1,
                                     lights.size());
  std::fill(m_fresh.begin(), m_fresh.end(), first);
  for (std::size_t i = 0; !first && i < budget; ++i) m_fresh[m_turn++ % lights.size()] = true;

  for (std::size_t i = 0; i < lights.size(); ++i) {
    if (!m_fresh[i]) continue;
    m_points[i] = pointNow(frame, lights[i], i, sample);
    if (asked && m_points[i].castsShadow)
      fit(frame, sample, i);
    else
      m_faces[i].clear();
    ++m_taken[i];
  }
  makeMaps(frame, sample);
  for (std::size_t i = 0; i < lights.size(); ++i)
    for (Face& face : m_faces[i])
      if (face.layer >= 0 && !face.drawn)
        drawFace(frame, face, first ? glm::vec2(0.0F) : shiftOf(sample.index), statistics);
  // Fewer triangles lie a little below those in the maps.
  upload(sample, 2.0F * frame.resources.geometry().errorOf(frame.level));
}

void ShadowPass::readGeometry(const FrameContext& frame) {
  std::vector<Caster> casters;
  for (const SlotResources& slot : frame.resources.slots()) {
    Caster caster{slot.kind, slot.hasCutOuts, {}, nullptr, nullptr};
    if (slot.hasCutOuts) {
      caster.material = slot.materialBytes;
      caster.albedo = slot.textures.at(static_cast<std::size_t>(TextureSlot::Albedo)).get();
    }
    if (slot.displaced) {
      caster.material = slot.materialBytes;
      caster.heights = slot.textures.at(static_cast<std::size_t>(TextureSlot::Displacement)).get();
    }
    casters.push_back(std::move(caster));
  }
  const bool sameModel = m_model == frame.scene.model;
  if (sameModel && casters == m_casters) return;
  if (!sameModel) m_geometry = ShadowGeometry::of(*frame.scene.model);
  m_model = frame.scene.model;
  m_casters = std::move(casters);
  for (auto& faces : m_faces) faces.clear();
}

LightPoint ShadowPass::pointNow(const FrameContext& frame, const Light& light, std::size_t index,
                                const ShadowSample& sample) {
  const float units = frame.scene.millimetresPerUnit;
  if (sample.moving || sample.count < 2 || !isAreaLight(light)) return centreOf(light, units);
  // A sphere's first point is one of middling weight.
  const glm::vec2 start = light.type == LightType::Sphere ? glm::vec2(0.29F, 0.0F) : glm::vec2(0.5F);
  const int taken = m_taken[index];
  return pointOf(light, units, litCap(light, units, m_geometry.boxes), lightNumbers(taken, start),
                 sample.thorough ? sample.count : taken + 1);
}

void ShadowPass::fit(const FrameContext& frame, const ShadowSample& sample, std::size_t light) {
  const LightPoint& point = m_points[light];
  std::vector<Face>& faces = m_faces[light];
  const std::vector<ShadowAxes> eyes = shadowAxes(point, m_geometry);
  faces.resize(eyes.size());
  const bool keeps = sample.moving || (sample.index == 0 && !sample.thorough);
  for (std::size_t i = 0; i < eyes.size(); ++i) {
    Face& face = faces[i];
    const ShadowWindow needed = shadowWindow(eyes[i], point, m_geometry, frame.camera.viewProjection);
    const glm::vec2 now = face.window.extent(), least = needed.extent();
    const bool covers = face.drawn && face.axes == eyes[i] && face.window.contains(needed) &&
                        std::max(now.x, now.y) < kWidest * std::max(least.x, least.y);
    if (needed.empty() || (keeps && covers)) {
      if (needed.empty()) face = Face{};
      continue;
    }
    face.axes = eyes[i];
    // Filters look a texel beyond what is lit.
    face.window = widened(needed, sample.moving ? kSlack : 0.005F);
    face.drawn = false;
    face.layer = 0;
  }
}

void ShadowPass::makeMaps(const FrameContext& frame, const ShadowSample& sample) {
  // Two texels a pixel where there is time: half the blur, half the offset.
  const float pixel = pixelSize(frame) * (sample.thorough ? 0.5F : 1.0F);
  float needed = 0.0F;
  int layers = 0;
  for (auto& faces : m_faces)
    for (Face& face : faces) {
      if (face.layer < 0) continue;
      needed = std::max(needed, texelsNeeded(face.axes, face.window, m_geometry, pixel));
      const int layer = layers++;
      if (face.layer != layer) face.drawn = false;
      face.layer = layer;
    }
  if (layers == 0) return;

  // Texels no larger than a pixel, as far as there is memory; maps that are there are kept while they are not far too
  // large.
  constexpr std::array<int, 9> kSizes = {256, 384, 512, 768, 1024, 1536, 2048, 3072, 4096};
  const int most = m_software && !sample.thorough ? 2048 : 4096;
  const std::size_t memory = m_software && !sample.thorough ? std::size_t{96} << 20 : std::size_t{256} << 20;
  std::size_t step = 0;
  while (step + 1 < kSizes.size() && static_cast<float>(kSizes.at(step)) < needed && kSizes.at(step + 1) <= most)
    ++step;
  const auto bytes = [&](std::size_t s) {
    return static_cast<std::size_t>(kSizes.at(s)) * static_cast<std::size_t>(kSizes.at(s)) * 4 *
           static_cast<std::size_t>(layers);
  };
  while (step > 0 && bytes(step) > memory) --step;
  const int size = kSizes.at(step);
  const int have = m_maps.width();
  const bool fits = m_maps.spec().depth >= layers && have >= size && have <= 2 * size && have > 1;
  if (fits) return;
  m_maps = gl::Texture::create({.target = GL_TEXTURE_2D_ARRAY,
                                .format = GL_DEPTH_COMPONENT32F,
                                .width = size,
                                .height = size,
                                .depth = layers,
                                .label = "shadow maps"});
  m_maps.setFilter(GL_NEAREST, GL_NEAREST);
  m_maps.setWrap(GL_CLAMP_TO_BORDER);  // depth 0: nothing is in the way
  for (auto& faces : m_faces)
    for (Face& face : faces) face.drawn = false;
}

void ShadowPass::drawFace(const FrameContext& frame, Face& face, glm::vec2 shift, RenderStatistics& statistics) {
  const int size = m_maps.width();
  const glm::vec3 centre = m_geometry.bounds.centre();
  face.view = shadowView(face.axes, face.window, size, face.layer, shift, centre, m_geometry.facetDepth);
  glNamedFramebufferTextureLayer(m_framebuffer.id(), GL_DEPTH_ATTACHMENT, m_maps.id(), 0, face.layer);
  const GLfloat nothing = 0.0F;
  glDepthMask(GL_TRUE);
  glClearNamedFramebufferfv(m_framebuffer.id(), GL_DEPTH, 0, &nothing);
  m_framebuffer.bind();
  glViewport(0, 0, size, size);
  glEnable(GL_DEPTH_TEST);
  glEnable(GL_DEPTH_CLAMP);  // casters nearer than the near plane still cast
  glDepthFunc(GL_GREATER);
  glDisable(GL_CULL_FACE);  // both sides cast: scans have holes, hair cards have no back
  glDisable(GL_BLEND);
  frame.resources.geometry().bind();
  for (std::size_t i = 0; i < m_model->parts.size(); ++i) {
    const ModelPart& part = m_model->parts[i];
    const SlotResources& slot = frame.resources.slots()[part.slot];
    if (slot.kind != DrawKind::Opaque) continue;
    if (slot.displaced) {
      // As finely as the camera sees it, so that the surface lies on what shades it.
      const gl::Program* program = frame.useProgram(withTiles(displacedCasterProgram(), slot.tiled));
      if (program == nullptr) continue;
      frame.resources.bindSlot(slot);
      DisplacementView view = displacementView(frame.camera, frame.size(),
                                               pixelsPerPiece(frame.request.moving, frame.resources.isSoftware()));
      view.clipFromWorld = glm::translate(face.view.clip, -centre);
      view.leastFacing = -2.0F;
      drawDisplaced(*program, slot, frame.resources.geometry(), i, view);
      continue;
    }
    const gl::Program* program =
        frame.useProgram(withTiles(casterProgram(slot.hasCutOuts), slot.hasCutOuts && slot.tiled));
    if (program == nullptr) continue;
    if (slot.hasCutOuts) frame.resources.bindSlot(slot);
    glUniformMatrix4fv(program->uniform("u_clip_from_world"), 1, GL_FALSE, &face.view.clip[0][0]);
    glUniform3f(program->uniform("u_centre"), centre.x, centre.y, centre.z);
    frame.resources.geometry().draw(part);
  }
  frame.resources.unbindSamplers();
  glDisable(GL_DEPTH_CLAMP);
  face.drawn = true;
  ++statistics.shadowMapsDrawn;
  ++m_revision;
}

void ShadowPass::upload(const ShadowSample& sample, float below) {
  ShadowBlock block;
  block.centre = {m_geometry.bounds.centre(), static_cast<float>(m_maps.width())};
  // Still pictures take the nearest texel and move the grid; where there is nothing to average, neighbours are.
  block.filter.x = sample.moving || sample.count < 2 || (sample.index == 0 && !sample.thorough) ? 1.0F : 0.0F;
  for (ShadowViewBlock& view : block.views) view.texel.w = -1.0F;
  std::size_t next = kMaxLights;
  for (std::size_t light = 0; light < m_faces.size(); ++light) {
    const std::vector<Face>& faces = m_faces[light];
    std::size_t first = light;
    if (faces.size() > 1) {
      first = next;
      next += faces.size();
      block.of.at(light).x = static_cast<int>(first);
    }
    for (std::size_t i = 0; i < faces.size(); ++i)
      if (faces[i].drawn) {
        ShadowViewBlock& view = block.views.at(first + i);
        view = faces[i].view.block;
        view.texel.z += below;
      }
  }
  const auto bytes = std::as_bytes(std::span<const ShadowBlock, 1>(&block, 1));
  if (std::ranges::equal(bytes, m_blockBytes)) return;
  m_blockBuffer.update(0, bytes);
  m_blockBytes.assign(bytes.begin(), bytes.end());
  ++m_revision;
}

void ShadowPass::bind() const {
  m_blockBuffer.bindUniform(kShadowBinding);
  m_maps.bind(kUnit);
}

}  // namespace dermis
