// What the last frame left, read back: images, the picture through a view, and what one pixel holds.
#include "colour/false_colour.h"
#include "frame.h"
#include "passes/read_back.h"

namespace dermis {

Image Frame::readAov(Aov aov) const {
  const SceneImage which = sceneImageOf(aov);
  if (m_samples == 0 || !samplesOf(which)) return blackAov(aov, m_targets.size());
  return aovFromSums(aov, samplesOf(which), m_samples);
}

Image Frame::readView(Aov aov, const ResolvedScene* scene, const ViewSettings& view, PixelType type) {
  const glm::ivec2 size = glm::max(m_targets.size(), glm::ivec2(1));
  const bool wide = type != PixelType::U8;
  const SceneImage which = sceneImageOf(aov);
  if (m_samples == 0 || scene == nullptr || !samplesOf(which)) return blackDisplay(size, wide);
  const gl::Texture target = gl::Texture::create({.format = wide ? GLenum{GL_RGBA16} : GLenum{GL_RGBA8},
                                                  .width = size.x,
                                                  .height = size.y,
                                                  .label = "encoded picture"});
  const gl::Framebuffer framebuffer = gl::Framebuffer::create("encoded picture");
  framebuffer.attachColour(0, target);
  framebuffer.drawTo(1);
  framebuffer.bind();
  m_noVertices.bind();
  const gl::Texture& sums = samplesOf(which);
  const float weight = 1.0F / static_cast<float>(m_samples);
  if (isData(aov)) {
    DisplayPass::drawData(m_shaders, m_messages, aov, valueRange(aov, *scene, m_stillKey.camera), sums, weight, size,
                          {{0, 0}, size});
  } else {
    DisplayInput input;
    input.image = &sums;
    input.weight = weight;
    input.exact = true;
    input.straightAlpha = true;
    m_display.draw(m_shaders, m_messages, view, input);
  }
  Image image = displayFromTexture(target, wide);
  gl::restoreDefaults(0);
  return image;
}

std::optional<glm::vec3> Frame::pickPosition(glm::ivec2 pixel) const {
  // From the picture's upper left to the lower left of what the images hold.
  const glm::ivec2 size = m_targets.dataWindow().extent();
  const glm::ivec2 at = glm::ivec2(pixel.x, m_targets.size().y - 1 - pixel.y) - m_targets.dataWindow().lower;
  if (at.x < 0 || at.y < 0 || at.x >= size.x || at.y >= size.y) return std::nullopt;
  if (m_lastMultisampled) {
    // One sample of each pixel is enough to point at something.
    glBlitNamedFramebuffer(m_targets.multisampled().id(), m_targets.scene().id(), 0, 0, size.x, size.y, 0, 0, size.x,
                           size.y, GL_DEPTH_BUFFER_BIT, GL_NEAREST);
  }
  m_targets.scene().bind();
  GLfloat depth = 0.0F;
  glReadPixels(at.x, at.y, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &depth);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  if (depth <= 0.0F) return std::nullopt;  // the far plane of the reversed depth
  const glm::vec2 clip = (glm::vec2(at) + 0.5F) / glm::vec2(size) * 2.0F - 1.0F;
  const glm::vec4 world = m_lastCamera.inverseViewProjection * glm::vec4(clip, depth, 1.0F);
  return glm::vec3(world) / world.w;
}

std::optional<PixelReadout> Frame::readPixel(glm::ivec2 pixel, const ViewSettings& view) {
  const glm::ivec2 size = m_targets.size();
  if (pixel.x < 0 || pixel.y < 0 || pixel.x >= size.x || pixel.y >= size.y) return std::nullopt;
  const int row = size.y - 1 - pixel.y;
  const bool fromSums = m_showsSums && m_samples > 0;
  if (m_isBegun && !fromSums) return std::nullopt;  // half a picture
  const auto texel = [](const gl::Texture& image, glm::ivec2 at) {
    glm::vec4 value(0.0F);
    glGetTextureSubImage(image.id(), 0, at.x, at.y, 0, 1, 1, 1, GL_RGBA, GL_FLOAT, sizeof value, &value[0]);
    return value;
  };
  const glm::ivec2 at(pixel.x, row);
  PixelReadout readout;
  readout.radiance = fromSums ? texel(samplesOf(SceneImage::Beauty), at) / static_cast<float>(m_samples)
                              : texel(m_targets.whole(SceneImage::Beauty), at);
  readout.display = m_display.encoded(readout.radiance, view, m_messages);
  const PixelArea& window = m_targets.dataWindow();
  if (m_targets.has(SceneImage::Geometry) && window.holds({at, at + 1}))
    if (const float thickness = texel(m_targets.image(SceneImage::Geometry), at - window.lower).w; thickness > 0.0F)
      readout.thicknessMm = thickness;
  return readout;
}

}  // namespace dermis
