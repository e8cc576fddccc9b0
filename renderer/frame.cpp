// The frame, top to bottom: Frame::draw first, then what it calls. frame_read_back.cpp reads what it left.
#include "frame.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "lighting/environment_map.h"
#include "lighting/spherical_harmonics.h"
#include "passes/accumulate_pass.h"
#include "passes/data_window.h"
#include "passes/reference_objects.h"
#include "passes/sky_pass.h"
#include "passes/subsurface_pass.h"
#include "passes/surface_pass.h"

namespace dermis {

namespace {

bool canShow(GLuint framebuffer) {
  // Without a window the default framebuffer doesn't exist: nothing is shown, the picture is read back instead.
  return glCheckNamedFramebufferStatus(framebuffer, GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

std::vector<glm::vec3> visibleLampPositions(const ResolvedScene& scene, double seconds) {
  std::vector<glm::vec3> positions;
  for (const Light& light : scene.scene.lights)
    if (light.enabled && light.visible && light.type != LightType::Directional)
      positions.push_back(animated(light, seconds).position);
  return positions;
}

/// Does something within each rectangle alone.
template <class Draw>
void inAreas(const std::vector<PixelArea>& areas, Draw draw) {
  glEnable(GL_SCISSOR_TEST);
  for (const PixelArea& area : areas) {
    const glm::ivec2 extent = area.extent();
    if (extent.x < 1 || extent.y < 1) continue;
    glScissor(area.lower.x, area.lower.y, extent.x, extent.y);
    draw();
  }
  glDisable(GL_SCISSOR_TEST);
}

void setCamera(FrameBlock& block, const CameraMatrices& camera, glm::ivec2 size) {
  block.view = camera.view;
  block.projection = camera.projection;
  block.viewProjection = camera.viewProjection;
  block.inverseViewProjection = camera.inverseViewProjection;
  block.cameraPosition = {camera.position, camera.orthographic ? 1.0F : 0.0F};
  block.cameraForward = {camera.forward, 0.0F};
  block.viewport = {glm::vec2(size), 1.0F / glm::vec2(size)};
}

/// Takes away what was drawn over the background there.
void clearBeauty(const FrameContext& frame, const std::vector<PixelArea>& areas) {
  const glm::vec4 background = backgroundClearColour(frame);
  frame.targets.drawToBeauty();
  frame.targets.scene().bind();
  glViewport(0, 0, frame.size().x, frame.size().y);
  inAreas(areas, [&] { glClearBufferfv(GL_COLOR, 0, &background[0]); });
  frame.targets.drawToAll();
}

}  // namespace

Frame::Frame(gl::ShaderLibrary& shaders, MessageLog& messages, bool software, bool crops)
    : m_shaders(shaders),
      m_messages(messages),
      m_software(software),
      m_crops(crops),
      m_shadows(software),
      m_noVertices(gl::VertexArray::create("no vertices")),
      m_frameBlockBuffer(gl::Buffer::writable("frame block", sizeof(FrameBlock))),
      m_sampleBlockBuffer(gl::Buffer::writable("sample block", sizeof(SampleBlock))) {}

bool Frame::draw(const FrameRequest& request, SceneResources& resources, std::uint64_t revision,
                 RenderStatistics& statistics) {
  const std::optional<FrameContext> frame = prepare(request, resources, revision);
  if (!frame) return false;
  const bool drawsOne = drawsSample(request);
  if (drawsOne) {
    if (!m_isBegun) m_timer.beginFrame();
    if (!std::exchange(m_isBegun, false) && !drawSurface(*frame, statistics)) {
      gl::restoreDefaults(request.framebuffer);
      return false;
    }
    drawAround(*frame);
    if (m_targets.isCropped()) completePicture(*frame);
    ++statistics.frames;
    if (frame->level > 0) ++statistics.coarseFrames;
  } else {
    m_timer.beginFrame();
  }

  if (!request.moving && drawsOne) {
    // A single sample is its own mean: it goes into the sums when the next one is drawn.
    if (m_samples > 0 && !accumulate(*frame)) return false;
    ++m_samples;
  }

  if (canShow(request.framebuffer)) {
    const auto timed = m_timer.pass("display");
    show(*frame, !request.moving);
  }
  // At rest nobody needs what the samples were made of: a sixth of what a window with the built-in look holds.
  const bool isAtRest = !request.moving && m_targetSamples > 1 && !accumulating();
  if (isAtRest && drawsOne) m_targets.releaseWork();
  statistics.samples = request.moving ? 1 : m_samples;
  statistics.targetSamples = m_targetSamples;
  statistics.pictureSize = request.size;
  m_showsSums = !request.moving;
  gl::restoreDefaults(request.framebuffer);
  return true;
}

bool Frame::begin(const FrameRequest& request, SceneResources& resources, std::uint64_t revision,
                  RenderStatistics& statistics) {
  const std::optional<FrameContext> frame = prepare(request, resources, revision);
  if (!frame || !drawsSample(request)) return false;
  if (!m_isBegun) {
    m_timer.beginFrame();
    m_isBegun = drawSurface(*frame, statistics);
    m_begunFence = gl::Fence::here();
  }
  gl::restoreDefaults(request.framebuffer);
  return m_isBegun;
}

std::optional<FrameContext> Frame::prepare(const FrameRequest& request, SceneResources& resources,
                                           std::uint64_t revision) {
  const ResolvedScene* scene = resources.scene();
  if (scene == nullptr || !scene->model || request.size.x < 1 || request.size.y < 1) return std::nullopt;

  // Which images: the picture, what is kept of it, what is looked at. A moving picture on a GPU has four samples a
  // pixel.
  const SceneImages wanted =
      request.moving ? kBeautyOnly | bitOf(sceneImageOf(request.aov)) : m_kept | bitOf(sceneImageOf(request.aov));
  const SceneImages images = wanted != kBeautyOnly || isSplit(*scene) ? wanted | kSplit : wanted;
  const bool multisampled = request.moving && !m_software && images == kBeautyOnly;
  // What is looked at besides the picture, and what stands beside the model, needs all of it.
  const bool isWhole = !m_crops || request.moving || wanted != kBeautyOnly || hasVisibleLamps(*scene) ||
                       request.references.balls || request.references.chart;
  const std::vector<glm::vec3> lamps = visibleLampPositions(*scene, request.seconds);
  const auto cameraOf = [&](glm::vec2 jitter) {
    return cameraMatrices(request.camera, resources.bounds(), request.size, jitter, lamps);
  };
  const PixelArea window = isWhole ? PixelArea{glm::ivec2(0), request.size}
                                   : dataWindow(cameraOf(glm::vec2(0.0F)), resources.bounds(), request.size, m_targets);
  auto prepared =
      m_targets.prepare(request.size, window, images, request.exactDisplay && !request.eightBits, multisampled);
  if (!prepared) {
    m_messages.say(prepared.error().message);
    return std::nullopt;
  }
  if (*prepared) restart();
  if (*prepared || !request.moving) m_surfaceKey.reset();

  // A still picture converges as long as nothing that it shows changes.
  const bool animates = std::any_of(scene->scene.lights.begin(), scene->scene.lights.end(), isAnimated);
  const StillKey key{request.size,
                     request.camera,
                     wanted,
                     request.exactDisplay,
                     animates ? request.seconds : 0.0,
                     request.withoutSubsurface,
                     request.references,
                     revision};
  const bool isAnother = !(key == m_stillKey);
  if (isAnother || request.moving != m_begunMoving) m_isBegun = false;
  if (isAnother || request.moving) m_samples = m_summed = 0;
  m_stillKey = key;
  m_begunMoving = request.moving;
  m_targetSamples = std::max(request.targetSamples, 1);

  const CameraMatrices camera = cameraOf(request.moving ? glm::vec2(0.0F) : pixelJitter(m_samples));
  FrameContext frame{request,
                     *scene,
                     resources,
                     m_targets,
                     m_shaders,
                     m_messages,
                     m_targets.isCropped() ? cropped(camera, window, request.size) : camera,
                     camera,
                     multisampled};
  frame.level = levelFor(request, resources, frame.camera);
  return frame;
}

bool Frame::accumulate(const FrameContext& frame) {
  const auto timed = m_timer.pass("accumulate");
  if (auto sums = m_targets.prepareSums(m_stillKey.images); !sums) {
    m_messages.say(sums.error().message);
    return false;
  }
  glViewport(0, 0, frame.request.size.x, frame.request.size.y);
  accumulatePass(frame, m_summed == 0);
  ++m_summed;
  return true;
}

bool Frame::drawSurface(const FrameContext& frame, RenderStatistics& statistics) {
  const FrameRequest& request = frame.request;
  m_noVertices.bind();
  if (!request.moving && m_summed < m_samples && !accumulate(frame)) return false;
  glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);  // the environment's faces meet without a seam
  // Reversed depth in 0..1: see cameraMatrices.
  glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
  {
    const auto timed = m_timer.pass("shadow");
    m_shadows.draw(frame, {request.moving ? 0 : m_samples, m_targetSamples, request.moving, request.exactDisplay},
                   statistics);
    m_shadows.bind();
  }
  const FrameBlock block = uploadFrameBlock(frame, statistics);
  frame.resources.bindLight();
  const bool deferred =
      m_software && deferringPays(frame.scene) && m_targets.prepareSurfaces(request.moving).has_value();
  {
    const auto timed = m_timer.pass("vertices");
    m_lightIsPending = !m_vertexLight.update(frame, block, m_shadows.revision(), deferred && request.moving);
  }
  if (m_lightIsPending) {
    m_surfaceKey.reset();
    return false;
  }
  std::optional<SurfaceKey> key = deferred && request.moving ? surfaceKey(frame) : std::nullopt;
  m_surfacesAreKept = key.has_value() && key == m_surfaceKey;
  m_surfaceKey = std::move(key);
  m_drawnOver = m_surfacesAreKept ? transparentAreas(frame) : std::vector<PixelArea>{};
  if (m_surfacesAreKept) {
    ++statistics.surfacesKept;
    clearBeauty(frame, m_drawnOver);
  } else {
    clear(frame);
  }
  if (deferred && !m_surfacesAreKept) {
    const auto timed = m_timer.pass("geometry");
    geometryPass(frame);
  }
  const auto timed = m_timer.pass("surface");
  (deferred ? shadingPass : surfacePass)(frame);
  m_lastCamera = frame.camera;  // of the depth that pickPosition() reads
  m_lastMultisampled = frame.multisampled;
  return true;
}

void Frame::drawAround(const FrameContext& frame) {
  const FrameRequest& request = frame.request;
  // Bound again: something else may have been drawn since the first half.
  glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
  glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
  m_shadows.bind();
  m_frameBlockBuffer.bindUniform(kFrameBinding);
  m_sampleBlockBuffer.bindUniform(kSampleBinding);
  frame.resources.bindLight();
  m_noVertices.bind();
  glViewport(0, 0, frame.size().x, frame.size().y);
  if (m_targets.split()) {
    const auto timed = m_timer.pass("subsurface");
    // Two passes are enough while something moves, and better than one grainy sample of the disc, which other pictures
    // gather from.
    const bool spreads = (request.moving || m_targetSamples == 1) && m_targets.prepareSpread().has_value();
    subsurfacePass(frame, spreads ? DiffusionQuality::Separable : DiffusionQuality::Disc);
  }
  m_targets.scene().bind();
  {
    const auto timed = m_timer.pass("sky");
    m_targets.drawToBeauty();
    if (m_surfacesAreKept)
      inAreas(m_drawnOver, [&] { skyPass(frame); });
    else
      skyPass(frame);
    if (hasVisibleLamps(frame.scene)) lampPass(frame);
  }
  if (hasTransparentParts(frame.resources)) {
    const auto timed = m_timer.pass("transparent");
    (frame.multisampled ? m_targets.multisampled() : m_targets.radiances()).bind();
    transparentPass(frame);
    m_noVertices.bind();
  }
  if (frame.multisampled) {
    const auto timed = m_timer.pass("resolve");
    const glm::ivec2 size = request.size;
    glBlitNamedFramebuffer(m_targets.multisampled().id(), m_targets.scene().id(), 0, 0, size.x, size.y, 0, 0, size.x,
                           size.y, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  }
  if (request.references.balls || request.references.chart) {
    const auto timed = m_timer.pass("references");
    m_targets.scene().bind();
    m_targets.drawToBeauty();
    referencePass(frame, request.moving ? glm::vec2(0.0F) : pixelJitter(m_samples));
  }
  glClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
}

void Frame::completePicture(const FrameContext& frame) {
  const glm::ivec2 size = frame.request.size;
  const PixelArea& window = m_targets.dataWindow();
  const auto timed = m_timer.pass("sky around");
  const gl::Framebuffer& picture = m_targets.pictureBuffer();
  const glm::vec4 background = backgroundClearColour(frame);
  glClearNamedFramebufferfv(picture.id(), GL_COLOR, 0, &background[0]);
  picture.bind();
  glViewport(0, 0, size.x, size.y);
  glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
  m_wholeBlockBuffer.bindUniform(kFrameBinding);
  inAreas(areasAround(window, size), [&] { skyPass(frame); });
  m_frameBlockBuffer.bindUniform(kFrameBinding);
  glClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
  const glm::ivec2 extent = window.extent();
  glCopyImageSubData(m_targets.image(SceneImage::Beauty).id(), GL_TEXTURE_2D, 0, 0, 0, 0,
                     m_targets.whole(SceneImage::Beauty).id(), GL_TEXTURE_2D, 0, window.lower.x, window.lower.y, 0,
                     extent.x, extent.y, 1);
}

int Frame::levelFor(const FrameRequest& request, SceneResources& resources, const CameraMatrices& camera) {
  // Only where the viewport has already given up pixels to keep pace: a GPU has triangles to spare.
  const bool isReduced = request.displaySize.y > 0 && request.size.y < request.displaySize.y;
  if (!m_software || !request.moving || !isReduced) return 0;
  // A single one, as when a window opens, isn't worth the work.
  if (m_wasReduced) resources.wantCoarse();
  m_wasReduced = true;
  constexpr float kMostPixels = 0.35F;
  return resources.geometry().levelWithin(kMostPixels * nearestPixel(camera, resources.bounds(), request.size));
}

std::optional<Frame::SurfaceKey> Frame::surfaceKey(const FrameContext& frame) const {
  const FrameRequest& request = frame.request;
  // Lamps and reference objects are drawn into the sky, a displaced surface is its material's.
  if (hasVisibleLamps(frame.scene) || request.references.balls || request.references.chart) return std::nullopt;
  const EnvironmentSource& environment = frame.scene.scene.environment;
  SurfaceKey key{request.size,
                 request.camera,
                 m_targets.images(),
                 m_targets.precise(),
                 frame.resources.geometryRevision(),
                 m_vertexLight.revision(),
                 frame.resources.environmentRevision(),
                 environment.rotationDegrees,
                 environment.exposureStops,
                 environment.background,
                 frame.level,
                 {}};
  for (const SlotResources& slot : frame.resources.slots()) {
    if (slot.displaced) return std::nullopt;
    key.slots.emplace_back(slot.kind, slot.cullBackFaces);
  }
  return key;
}

FrameBlock Frame::uploadFrameBlock(const FrameContext& frame, RenderStatistics& statistics) {
  FrameBlock block;
  setCamera(block, frame.camera, frame.size());
  const EnvironmentSource& environment = frame.scene.scene.environment;
  block.environmentFromWorld = environmentFromWorld(environment.rotationDegrees);
  const EnvironmentMap* map = frame.resources.environment();
  block.environmentScale.x = map != nullptr ? std::exp2(environment.exposureStops) * map->scale() : 0.0F;
  if (map != nullptr) {
    const Harmonics<glm::vec3> harmonics = turned(map->harmonics(), glm::mat3(block.environmentFromWorld));
    for (std::size_t i = 0; i < harmonics.size(); ++i)
      block.environmentHarmonics.at(i) = glm::vec4(harmonics[i] * block.environmentScale.x, 0.0F);
  }
  block.units.x = frame.scene.millimetresPerUnit;
  packLights(block, frame.scene.scene.lights, frame.scene.millimetresPerUnit, frame.request.seconds);
  for (std::size_t i = 0; i < m_shadows.points().size(); ++i) packPoint(block.lights.at(i), m_shadows.points()[i]);

  const auto bytes = bytesOf(block);
  if (!std::ranges::equal(bytes, m_frameBlockBytes)) {
    m_frameBlockBuffer.update(0, bytes);
    m_frameBlockBytes.assign(bytes.begin(), bytes.end());
    ++statistics.uniformBlocksUploaded;
  }
  m_frameBlockBuffer.bindUniform(kFrameBinding);
  const FrameRequest& request = frame.request;
  if (m_targets.isCropped()) {
    FrameBlock whole = block;
    setCamera(whole, frame.wholeCamera, request.size);
    if (!m_wholeBlockBuffer) m_wholeBlockBuffer = gl::Buffer::writable("frame block, whole picture", sizeof whole);
    m_wholeBlockBuffer.update(0, bytesOf(whole));
  }
  SampleBlock sample =
      packSample(request.moving ? 0 : m_samples, m_targetSamples, request.moving, request.withoutSubsurface);
  sample.window = {m_targets.dataWindow().lower, 0.0F, 0.0F};
  m_sampleBlockBuffer.update(0, bytesOf(sample));
  m_sampleBlockBuffer.bindUniform(kSampleBinding);
  return block;
}

void Frame::clear(const FrameContext& frame) const {
  const glm::vec4 background = backgroundClearColour(frame);
  const std::array<GLfloat, 4> zero = {0.0F, 0.0F, 0.0F, 0.0F};
  const GLfloat farthest = 0.0F;
  glDepthMask(GL_TRUE);
  const gl::Framebuffer& target = frame.multisampled ? m_targets.multisampled() : m_targets.scene();
  if (!frame.multisampled) m_targets.drawToAll();
  target.bind();
  glViewport(0, 0, frame.size().x, frame.size().y);
  glClearNamedFramebufferfv(target.id(), GL_DEPTH, 0, &farthest);
  glClearNamedFramebufferfv(target.id(), GL_COLOR, 0, &background[0]);
  if (frame.multisampled) return;
  for (std::size_t i = 1; i < kSurfaceImageCount; ++i)
    if ((m_targets.images() & (1U << i)) != 0)
      glClearNamedFramebufferfv(target.id(), GL_COLOR, static_cast<GLint>(i), zero.data());
  // The subsurface pass writes only where the model is.
  for (const SceneImage image : {SceneImage::Diffuse, SceneImage::Scattered})
    if (m_targets.has(image)) glClearTexImage(m_targets.image(image).id(), 0, GL_RGBA, GL_FLOAT, zero.data());
}

void Frame::show(const FrameContext& frame, bool fromSums) {
  const FrameRequest& request = frame.request;
  const SceneImage which = sceneImageOf(request.aov);
  const gl::Texture& image = fromSums ? samplesOf(which) : m_targets.whole(which);
  const float weight = fromSums ? 1.0F / static_cast<float>(std::max(m_samples, 1)) : 1.0F;
  const glm::ivec2 size = request.displaySize.x > 0 && request.displaySize.y > 0 ? request.displaySize : request.size;
  glBindFramebuffer(GL_FRAMEBUFFER, request.framebuffer);
  const glm::ivec2 columns = request.displayColumns.y > 0 ? request.displayColumns : glm::ivec2(0, size.x);
  const PixelArea shown{{columns.x, 0}, {columns.y, size.y}};

  if (isData(request.aov)) {
    DisplayPass::drawData(m_shaders, m_messages, request.aov, valueRange(request.aov, frame.scene, request.camera),
                          image, weight, size, shown);
    return;
  }
  DisplayInput input;
  input.image = &image;
  input.weight = weight;
  input.exact = request.exactDisplay;
  // Until a still picture has enough samples of its own to be smooth, it is smoothed like a moving one: no flicker at
  // rest.
  constexpr int kSmoothSamples = 4;
  if (!request.exactDisplay && (request.moving ? !frame.multisampled : m_samples < kSmoothSamples)) {
    const bool isOnlyModel = !hasVisibleLamps(frame.scene) && !request.references.balls && !request.references.chart;
    input.edgeFilter = isOnlyModel ? screenArea(frame.wholeCamera, frame.resources.bounds(), request.size)
                                   : PixelArea{glm::ivec2(0), request.size};
  }
  input.dither = true;
  if (size == request.size) {
    input.shown = shown;
    m_display.draw(m_shaders, m_messages, request.view, input);
    return;
  }
  // Encoded at its own size and enlarged then: a software driver enlarges codes for a tenth of what encoding costs.
  const glm::vec2 scale = glm::vec2(request.size) / glm::vec2(size);
  input.shown = PixelArea{glm::max(glm::ivec2(glm::floor(glm::vec2(shown.lower) * scale)) - 1, glm::ivec2(0)),
                          glm::min(glm::ivec2(glm::ceil(glm::vec2(shown.upper) * scale)) + 1, request.size)};
  const gl::Framebuffer& encoded = m_targets.encoded();
  encoded.bind();
  m_display.draw(m_shaders, m_messages, request.view, input);
  glBindFramebuffer(GL_FRAMEBUFFER, request.framebuffer);
  DisplayPass::enlarge(m_shaders, m_messages, m_targets.encodedImage(), size, shown);
}

std::vector<PassTime> Frame::passTimes() {
  m_timer.finish();
  std::vector<PassTime> times;
  for (const gl::TimedPass& pass : m_timer.passes()) times.push_back({pass.name, pass.gpuMs, pass.cpuMs});
  return times;
}

}  // namespace dermis
