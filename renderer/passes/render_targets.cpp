#include "passes/render_targets.h"

#include <string>
#include <vector>

namespace dermis {

namespace {

constexpr std::array<const char*, kSceneImageCount> kNames = {
    "beauty", "entering", "exit", "geometry", "specular", "transmission", "normal", "data", "diffuse", "scattered"};
constexpr std::array kSurfaceImages = {SceneImage::Beauty,   SceneImage::Entering, SceneImage::Exit,
                                       SceneImage::Geometry, SceneImage::Specular, SceneImage::Transmission,
                                       SceneImage::Normal,   SceneImage::Data};
constexpr std::array kComposedImages = {SceneImage::Beauty, SceneImage::Diffuse, SceneImage::Scattered};
constexpr std::array kRadianceImages = {SceneImage::Beauty, SceneImage::Diffuse, SceneImage::Scattered,
                                        SceneImage::Specular, SceneImage::Transmission};

}  // namespace

SceneImage sceneImageOf(Aov aov) {
  switch (aov) {
    case Aov::Diffuse:
      return SceneImage::Diffuse;
    case Aov::DiffuseScattered:
      return SceneImage::Scattered;
    case Aov::Specular:
      return SceneImage::Specular;
    case Aov::Transmission:
      return SceneImage::Transmission;
    case Aov::Normal:
      return SceneImage::Normal;
    case Aov::Thickness:
    case Aov::Occlusion:
    case Aov::Depth:
      return SceneImage::Data;
    case Aov::ProfileId:
      return SceneImage::Geometry;
    case Aov::Energy:
      return SceneImage::Exit;
    case Aov::Beauty:
      break;
  }
  return SceneImage::Beauty;
}

gl::Framebuffer RenderTargets::framebufferOf(std::span<const SceneImage> images, const char* label) const {
  gl::Framebuffer framebuffer = gl::Framebuffer::create(label);
  std::vector<GLenum> attachments;
  for (std::size_t i = 0; i < images.size(); ++i) {
    if (has(images[i])) framebuffer.attachColour(static_cast<GLuint>(i), image(images[i]));
    attachments.push_back(has(images[i]) ? GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(i) : GLenum{GL_NONE});
  }
  framebuffer.attachDepth(m_depth);
  framebuffer.drawTo(attachments);
  return framebuffer;
}

Result<bool> RenderTargets::prepare(glm::ivec2 size, const PixelArea& window, SceneImages images, bool precise,
                                    bool multisampled) {
  const glm::ivec2 extent = window.extent();
  if (size == m_size && window == m_window && images == m_images && precise == m_precise) {
    if (!multisampled || m_hasMultisampled) return false;
  } else {
    const bool hadContent = m_size.x > 0;
    *this = RenderTargets();
    m_size = size;
    m_window = window;
    m_images = images;
    m_precise = precise;
    for (std::size_t i = 0; i < kSceneImageCount; ++i) {
      if ((images & (1U << i)) == 0) continue;
      // Data and normals are averaged over many samples; radiance of a moving picture is not.
      const auto which = static_cast<SceneImage>(i);
      const bool half = !precise && which != SceneImage::Data && which != SceneImage::Normal;
      m_imagesOf.at(i) = gl::Texture::create({.format = half ? GLenum{GL_RGBA16F} : GLenum{GL_RGBA32F},
                                              .width = extent.x,
                                              .height = extent.y,
                                              .label = kNames.at(i)});
    }
    m_depth =
        gl::Texture::create({.format = GL_DEPTH_COMPONENT32F, .width = extent.x, .height = extent.y, .label = "depth"});
    m_scene = framebufferOf(kSurfaceImages, "scene");
    m_radiances = framebufferOf(kRadianceImages, "radiances");
    for (const gl::Framebuffer* framebuffer : {&m_scene, &m_radiances})
      if (auto complete = framebuffer->check(); !complete) return tl::unexpected(complete.error());
    if (isCropped()) {
      m_picture = gl::Texture::create({.format = precise ? GLenum{GL_RGBA32F} : GLenum{GL_RGBA16F},
                                       .width = size.x,
                                       .height = size.y,
                                       .label = "whole picture"});
      m_pictureBuffer = gl::Framebuffer::create("whole picture");
      m_pictureBuffer.attachColour(0, m_picture);
      m_pictureBuffer.drawTo(1);
      if (auto complete = m_pictureBuffer.check(); !complete) return tl::unexpected(complete.error());
    }
    if (split()) {
      m_composed = framebufferOf(kComposedImages, "composed");
      if (auto complete = m_composed.check(); !complete) return tl::unexpected(complete.error());
    }
    if (!multisampled) return hadContent;
  }
  constexpr int kSamples = 4;
  m_msColour = gl::Texture::create({.target = GL_TEXTURE_2D_MULTISAMPLE,
                                    .format = m_precise ? GLenum{GL_RGBA32F} : GLenum{GL_RGBA16F},
                                    .width = extent.x,
                                    .height = extent.y,
                                    .samples = kSamples,
                                    .label = "multisampled beauty"});
  m_msDepth = gl::Texture::create({.target = GL_TEXTURE_2D_MULTISAMPLE,
                                   .format = GL_DEPTH_COMPONENT32F,
                                   .width = extent.x,
                                   .height = extent.y,
                                   .samples = kSamples,
                                   .label = "multisampled depth"});
  m_multisampled = gl::Framebuffer::create("multisampled scene");
  m_multisampled.attachColour(0, m_msColour);
  m_multisampled.attachDepth(m_msDepth);
  m_multisampled.drawTo(1);
  m_hasMultisampled = true;
  if (auto complete = m_multisampled.check(); !complete) return tl::unexpected(complete.error());
  return true;
}

Result<void> RenderTargets::prepareSpread() {
  if (m_spreading) return {};
  // As fine as what spreads. Not an image of the surface, which the next moving frame may want again.
  m_spread = gl::Texture::create({.format = m_precise ? GLenum{GL_RGBA32F} : GLenum{GL_RGBA16F},
                                  .width = m_window.extent().x,
                                  .height = m_window.extent().y,
                                  .label = "spread along one axis"});
  m_spreading = gl::Framebuffer::create("spread along one axis");
  m_spreading.attachColour(0, m_spread);
  m_spreading.attachDepth(m_depth);
  m_spreading.drawTo(1);
  return m_spreading.check();
}

Result<void> RenderTargets::prepareSurfaces(bool moving) {
  SurfaceImages& images = moving ? m_movingSurfaces : m_stillSurfaces;
  if (images.framebuffer) return {};
  const auto image = [&](GLenum format, const char* label) {
    return gl::Texture::create(
        {.format = format, .width = m_window.extent().x, .height = m_window.extent().y, .label = label});
  };
  if (!m_surface) m_surface = image(GL_RGBA32F, "surface");  // coordinates need 32 bits
  if (!m_tangent) m_tangent = image(GL_RGBA16F, "tangent");
  if (!m_far) m_far = image(GL_RGBA16F, "far side");
  // What is seen for a moment may be coarse; writing more costs a moving frame a tenth.
  images.sky = image(moving ? GL_RGBA8 : GL_RGBA16F, "sky share");
  images.bounce = image(moving ? GL_R11F_G11F_B10F : GL_RGBA16F, "bounce");
  if (!moving) images.gradients = image(GL_RGBA16F, "gradients of uv");
  images.framebuffer = gl::Framebuffer::create(moving ? "moving surfaces" : "surfaces");
  int count = 0;
  for (const gl::Texture* each : {&m_surface, &m_tangent, &images.sky, &m_far, &images.bounce, &images.gradients})
    if (*each) images.framebuffer.attachColour(static_cast<GLuint>(count++), *each);
  images.framebuffer.attachDepth(m_depth);
  images.framebuffer.drawTo(count);
  return images.framebuffer.check();
}

void RenderTargets::releaseWork() {
  m_movingSurfaces = {};
  m_stillSurfaces = {};
  m_spreading = {};
  for (gl::Texture* each : {&m_surface, &m_tangent, &m_far, &m_spread}) *each = {};
}

void RenderTargets::bindSurfaces(bool moving) const {
  const SurfaceImages& images = moving ? m_movingSurfaces : m_stillSurfaces;
  constexpr GLuint kFirstUnit = 21;
  m_surface.bind(kFirstUnit);
  m_tangent.bind(kFirstUnit + 1);
  m_depth.bind(kFirstUnit + 2);
  constexpr GLuint kBakedUnit = 29;
  images.sky.bind(kBakedUnit);
  m_far.bind(kBakedUnit + 1);
  images.bounce.bind(kBakedUnit + 2);
  if (images.gradients) images.gradients.bind(kBakedUnit + 3);
}

Result<void> RenderTargets::prepareSums(SceneImages images) {
  for (std::size_t i = 0; i < kSceneImageCount; ++i) {
    if ((images & m_images & (1U << i)) == 0 || m_sums.at(i)) continue;
    m_sums.at(i) = gl::Texture::create(
        {.format = GL_RGBA32F, .width = m_size.x, .height = m_size.y, .label = std::string("sum of ") + kNames.at(i)});
    m_sumBuffers.at(i) = gl::Framebuffer::create(std::string("sum of ") + kNames.at(i));
    m_sumBuffers.at(i).attachColour(0, m_sums.at(i));
    m_sumBuffers.at(i).drawTo(1);
    if (auto complete = m_sumBuffers.at(i).check(); !complete) return complete;
  }
  return {};
}

const gl::Framebuffer& RenderTargets::encoded() {
  if (!m_encoding) {
    m_encoded = gl::Texture::create(
        {.format = GL_RGBA8, .width = m_size.x, .height = m_size.y, .label = "encoded, to enlarge"});
    m_encoding = gl::Framebuffer::create("encoded, to enlarge");
    m_encoding.attachColour(0, m_encoded);
    m_encoding.drawTo(1);
  }
  return m_encoding;
}

void RenderTargets::drawToAll() const {
  std::vector<GLenum> attachments;
  attachments.reserve(kSurfaceImages.size());
  for (const SceneImage image : kSurfaceImages)
    attachments.push_back(has(image) ? GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(image) : GLenum{GL_NONE});
  m_scene.drawTo(attachments);
}
void RenderTargets::drawToBeauty() const { m_scene.drawTo(1); }

}  // namespace dermis
