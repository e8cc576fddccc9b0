#include "passes/render_targets.h"

#include <string>
#include <vector>

namespace dermis {

namespace {

constexpr std::array<const char*, kSceneImageCount> kNames = {"beauty", "diffuse", "specular",
                                                              "normal", "data",    "profile id"};

void drawTo(const gl::Framebuffer& framebuffer, SceneImages images) {
  std::vector<GLenum> attachments;
  for (std::size_t i = 0; i < kSceneImageCount; ++i)
    attachments.push_back((images & (1U << i)) != 0 ? GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(i) : GLenum{GL_NONE});
  framebuffer.drawTo(attachments);
}

}  // namespace

SceneImage sceneImageOf(Aov aov) {
  switch (aov) {
    case Aov::Diffuse:
      return SceneImage::Diffuse;
    case Aov::Specular:
      return SceneImage::Specular;
    case Aov::Normal:
      return SceneImage::Normal;
    case Aov::Occlusion:
    case Aov::Depth:
      return SceneImage::Data;
    case Aov::ProfileId:
      return SceneImage::ProfileId;
    default:
      return SceneImage::Beauty;
  }
}

Result<bool> RenderTargets::prepare(glm::ivec2 size, SceneImages images, bool precise, bool multisampled) {
  if (size == m_size && images == m_images && precise == m_precise) {
    if (!multisampled || m_hasMultisampled) return false;
  } else {
    const bool hadContent = m_size.x > 0;
    *this = RenderTargets();
    m_size = size;
    m_images = images;
    m_precise = precise;
    m_scene = gl::Framebuffer::create("scene");
    for (std::size_t i = 0; i < kSceneImageCount; ++i) {
      if ((images & (1U << i)) == 0) continue;
      GLenum format = i == 0 && !precise ? GL_RGBA16F : GL_RGBA32F;
      if (i == static_cast<std::size_t>(SceneImage::ProfileId)) format = GL_R32F;
      m_imagesOf.at(i) =
          gl::Texture::create({.format = format, .width = size.x, .height = size.y, .label = kNames.at(i)});
      m_scene.attachColour(static_cast<GLuint>(i), m_imagesOf.at(i));
    }
    m_depth =
        gl::Texture::create({.format = GL_DEPTH_COMPONENT32F, .width = size.x, .height = size.y, .label = "depth"});
    m_scene.attachDepth(m_depth);
    drawToAll();
    if (auto complete = m_scene.check(); !complete) return tl::unexpected(complete.error());
    if (!multisampled) return hadContent;
  }
  constexpr int kSamples = 4;
  m_msColour = gl::Texture::create({.target = GL_TEXTURE_2D_MULTISAMPLE,
                                    .format = m_precise ? GLenum{GL_RGBA32F} : GLenum{GL_RGBA16F},
                                    .width = size.x,
                                    .height = size.y,
                                    .samples = kSamples,
                                    .label = "multisampled beauty"});
  m_msDepth = gl::Texture::create({.target = GL_TEXTURE_2D_MULTISAMPLE,
                                   .format = GL_DEPTH_COMPONENT32F,
                                   .width = size.x,
                                   .height = size.y,
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

Result<void> RenderTargets::prepareSurfaces() {
  if (m_surfaces) return {};
  m_surface = gl::Texture::create({.format = GL_RGBA32F, .width = m_size.x, .height = m_size.y, .label = "surface"});
  m_tangent = gl::Texture::create({.format = GL_RGBA16F, .width = m_size.x, .height = m_size.y, .label = "tangent"});
  m_surfaces = gl::Framebuffer::create("surfaces");
  m_surfaces.attachColour(0, m_surface);
  m_surfaces.attachColour(1, m_tangent);
  m_surfaces.attachDepth(m_depth);
  m_surfaces.drawTo(2);
  m_beautyAlone = gl::Framebuffer::create("beauty without depth");
  m_beautyAlone.attachColour(0, image(SceneImage::Beauty));
  m_beautyAlone.drawTo(1);
  if (auto complete = m_surfaces.check(); !complete) return complete;
  return m_beautyAlone.check();
}

void RenderTargets::bindSurfaces() const {
  constexpr GLuint kFirstUnit = 21;
  m_surface.bind(kFirstUnit);
  m_tangent.bind(kFirstUnit + 1);
  m_depth.bind(kFirstUnit + 2);
}

Result<void> RenderTargets::prepareSums() {
  for (std::size_t i = 0; i < kSceneImageCount; ++i) {
    if ((m_images & (1U << i)) == 0 || m_sums.at(i)) continue;
    const bool single = i == static_cast<std::size_t>(SceneImage::ProfileId);
    m_sums.at(i) = gl::Texture::create({.format = single ? GLenum{GL_R32F} : GLenum{GL_RGBA32F},
                                        .width = m_size.x,
                                        .height = m_size.y,
                                        .label = std::string("sum of ") + kNames.at(i)});
    m_sumBuffers.at(i) = gl::Framebuffer::create(std::string("sum of ") + kNames.at(i));
    m_sumBuffers.at(i).attachColour(0, m_sums.at(i));
    m_sumBuffers.at(i).drawTo(1);
    if (auto complete = m_sumBuffers.at(i).check(); !complete) return complete;
  }
  return {};
}

void RenderTargets::drawToAll() const { drawTo(m_scene, m_images); }
void RenderTargets::drawToRadiance() const {
  drawTo(m_scene, m_images & (bitOf(SceneImage::Beauty) | bitOf(SceneImage::Diffuse) | bitOf(SceneImage::Specular)));
}
void RenderTargets::drawToBeauty() const { drawTo(m_scene, kBeautyOnly); }

}  // namespace dermis
