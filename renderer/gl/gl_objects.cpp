#include "gl/gl_objects.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace dermis::gl {

void deleteBuffer(GLuint id) { glDeleteBuffers(1, &id); }
void deleteTexture(GLuint id) { glDeleteTextures(1, &id); }
void deleteFramebuffer(GLuint id) { glDeleteFramebuffers(1, &id); }
void deleteVertexArray(GLuint id) { glDeleteVertexArrays(1, &id); }
void deleteSampler(GLuint id) { glDeleteSamplers(1, &id); }
void deleteQuery(GLuint id) { glDeleteQueries(1, &id); }
void deleteProgram(GLuint id) { glDeleteProgram(id); }

void label(GLenum identifier, GLuint id, std::string_view text) {
  if (text.empty()) return;
  // 256 is the least GL_MAX_LABEL_LENGTH allowed, its closing zero included.
  glObjectLabel(identifier, id, static_cast<GLsizei>(std::min<std::size_t>(text.size(), 255)), text.data());
}

int fullMipCount(int width, int height) {
  int levels = 1;
  for (int size = std::max(width, height); size > 1; size /= 2) ++levels;
  return levels;
}

// ---- Buffer

Buffer Buffer::fixed(std::string_view labelText, std::span<const std::byte> bytes) {
  GLuint id = 0;
  glCreateBuffers(1, &id);
  Buffer buffer(id);
  buffer.m_size = bytes.size();
  // A zero-sized store is an error in GL; four bytes keep empty inputs legal.
  if (bytes.empty())
    glNamedBufferStorage(id, 4, nullptr, 0);
  else
    glNamedBufferStorage(id, static_cast<GLsizeiptr>(bytes.size()), bytes.data(), 0);
  label(GL_BUFFER, id, labelText);
  return buffer;
}

Buffer Buffer::writable(std::string_view labelText, std::size_t size) {
  GLuint id = 0;
  glCreateBuffers(1, &id);
  Buffer buffer(id);
  buffer.m_size = size;
  glNamedBufferStorage(id, static_cast<GLsizeiptr>(std::max<std::size_t>(size, 4)), nullptr, GL_DYNAMIC_STORAGE_BIT);
  label(GL_BUFFER, id, labelText);
  return buffer;
}

void Buffer::update(std::size_t offset, std::span<const std::byte> bytes) const {
  if (bytes.empty()) return;
  glNamedBufferSubData(id(), static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(bytes.size()), bytes.data());
}

void Buffer::bindUniform(GLuint binding) const { glBindBufferBase(GL_UNIFORM_BUFFER, binding, id()); }
void Buffer::bindStorage(GLuint binding) const { glBindBufferBase(GL_SHADER_STORAGE_BUFFER, binding, id()); }

// ---- Texture

namespace {

bool isCube(GLenum target) { return target == GL_TEXTURE_CUBE_MAP || target == GL_TEXTURE_CUBE_MAP_ARRAY; }

GLenum formatOf(int channels) {
  switch (channels) {
    case 1:
      return GL_RED;
    case 2:
      return GL_RG;
    case 3:
      return GL_RGB;
    default:
      return GL_RGBA;
  }
}

std::size_t bytesPerTexel(GLenum format) {
  switch (format) {
    case GL_R8:
      return 1;
    case GL_RG8:
    case GL_R16:
    case GL_R16F:
      return 2;
    case GL_RGB8:
    case GL_SRGB8:
      return 3;
    case GL_RGB16F:
      return 6;
    case GL_RG32F:
    case GL_RGBA16F:
    case GL_RGBA16:
      return 8;
    case GL_RGB32F:
      return 12;
    case GL_RGBA32F:
      return 16;
    default:
      return 4;
  }
}

}  // namespace

Texture Texture::create(const TextureSpec& spec) {
  GLuint id = 0;
  glCreateTextures(spec.target, 1, &id);
  Texture texture(id);
  texture.m_spec = spec;
  if (spec.levels == 0) texture.m_spec.levels = fullMipCount(spec.width, spec.height);
  const int levels = texture.m_spec.levels;
  switch (spec.target) {
    case GL_TEXTURE_1D:
      glTextureStorage1D(id, levels, spec.format, spec.width);
      break;
    case GL_TEXTURE_2D_MULTISAMPLE:
      glTextureStorage2DMultisample(id, spec.samples, spec.format, spec.width, spec.height, GL_TRUE);
      break;
    case GL_TEXTURE_2D_ARRAY:
    case GL_TEXTURE_3D:
      glTextureStorage3D(id, levels, spec.format, spec.width, spec.height, spec.depth);
      break;
    case GL_TEXTURE_CUBE_MAP_ARRAY:
      glTextureStorage3D(id, levels, spec.format, spec.width, spec.height, 6 * spec.depth);
      break;
    default:
      glTextureStorage2D(id, levels, spec.format, spec.width, spec.height);
      break;
  }
  if (spec.target != GL_TEXTURE_2D_MULTISAMPLE) {
    texture.setFilter(levels > 1 ? GL_LINEAR_MIPMAP_LINEAR : GL_LINEAR, GL_LINEAR);
    texture.setWrap(GL_CLAMP_TO_EDGE);
  }
  label(GL_TEXTURE, id, spec.label);
  return texture;
}

void Texture::upload(int level, GLenum format, GLenum type, const void* pixels) const {
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  if (m_spec.target == GL_TEXTURE_1D)
    glTextureSubImage1D(id(), level, 0, width(level), format, type, pixels);
  else
    glTextureSubImage2D(id(), level, 0, 0, width(level), height(level), format, type, pixels);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
}

void Texture::uploadLayer(int level, int layer, GLenum format, GLenum type, const void* pixels) const {
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTextureSubImage3D(id(), level, 0, 0, layer, width(level), height(level), 1, format, type, pixels);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
}

void Texture::uploadAll(int level, GLenum format, GLenum type, const void* pixels) const {
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  int layers = m_spec.depth;
  if (m_spec.target == GL_TEXTURE_3D) layers = std::max(1, m_spec.depth >> level);
  if (isCube(m_spec.target)) layers = 6 * m_spec.depth;
  glTextureSubImage3D(id(), level, 0, 0, 0, width(level), height(level), layers, format, type, pixels);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
}

Texture Texture::asArray() const {
  GLuint id = 0;
  glGenTextures(1, &id);
  Texture view(id);
  view.m_spec = m_spec;
  view.m_spec.target = GL_TEXTURE_2D_ARRAY;
  glTextureView(id, GL_TEXTURE_2D_ARRAY, this->id(), m_spec.format, 0, static_cast<GLuint>(m_spec.levels), 0, 1);
  for (const GLenum name : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER, GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T}) {
    GLint value = 0;
    glGetTextureParameteriv(this->id(), name, &value);
    glTextureParameteri(id, name, value);
  }
  std::array<GLint, 4> swizzle{};
  glGetTextureParameteriv(this->id(), GL_TEXTURE_SWIZZLE_RGBA, swizzle.data());
  glTextureParameteriv(id, GL_TEXTURE_SWIZZLE_RGBA, swizzle.data());
  GLfloat samples = 1.0F;
  glGetTextureParameterfv(this->id(), GL_TEXTURE_MAX_ANISOTROPY, &samples);
  view.setAnisotropy(samples);
  label(GL_TEXTURE, id, m_spec.label);
  return view;
}

void Texture::setFilter(GLenum minification, GLenum magnification) const {
  glTextureParameteri(id(), GL_TEXTURE_MIN_FILTER, static_cast<GLint>(minification));
  glTextureParameteri(id(), GL_TEXTURE_MAG_FILTER, static_cast<GLint>(magnification));
}

void Texture::setWrap(GLenum mode) const {
  for (const GLenum axis : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
    glTextureParameteri(id(), axis, static_cast<GLint>(mode));
}

void Texture::setAnisotropy(float samples) const {
  if (!epoxy_has_gl_extension("GL_EXT_texture_filter_anisotropic") &&
      !epoxy_has_gl_extension("GL_ARB_texture_filter_anisotropic"))
    return;
  GLfloat most = 1.0F;
  glGetFloatv(GL_MAX_TEXTURE_MAX_ANISOTROPY, &most);
  glTextureParameterf(id(), GL_TEXTURE_MAX_ANISOTROPY, std::min(samples, most));
}

void Texture::bindImage(GLuint unit, int level, GLenum access) const {
  glBindImageTexture(unit, id(), level, GL_TRUE, 0, access, m_spec.format);
}

std::vector<float> Texture::readFloats(int channels, int level) const {
  std::size_t layers = static_cast<std::size_t>(m_spec.depth);
  if (m_spec.target == GL_TEXTURE_3D) layers = static_cast<std::size_t>(std::max(1, m_spec.depth >> level));
  if (isCube(m_spec.target)) layers *= 6;
  const std::size_t rows = m_spec.target == GL_TEXTURE_1D ? 1 : static_cast<std::size_t>(height(level));
  std::vector<float> values(static_cast<std::size_t>(width(level)) * rows * layers *
                            static_cast<std::size_t>(channels));
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
  glGetTextureImage(id(), level, formatOf(channels), GL_FLOAT, static_cast<GLsizei>(values.size() * sizeof(float)),
                    values.data());
  return values;
}

std::size_t Texture::bytes() const {
  if (id() == 0) return 0;
  std::size_t total = 0;
  for (int level = 0; level < m_spec.levels; ++level)
    total += static_cast<std::size_t>(width(level)) * static_cast<std::size_t>(height(level));
  total *= bytesPerTexel(m_spec.format) * static_cast<std::size_t>(m_spec.depth * m_spec.samples);
  return isCube(m_spec.target) ? 6 * total : total;
}

// ---- Framebuffer

Framebuffer Framebuffer::create(std::string_view labelText) {
  GLuint id = 0;
  glCreateFramebuffers(1, &id);
  label(GL_FRAMEBUFFER, id, labelText);
  return Framebuffer(id);
}

void Framebuffer::attachColour(GLuint index, const Texture& texture, int level) const {
  glNamedFramebufferTexture(id(), GL_COLOR_ATTACHMENT0 + index, texture.id(), level);
}

void Framebuffer::attachColourLayer(GLuint index, const Texture& texture, int level, int layer) const {
  glNamedFramebufferTextureLayer(id(), GL_COLOR_ATTACHMENT0 + index, texture.id(), level, layer);
}

void Framebuffer::attachDepth(const Texture& texture) const {
  glNamedFramebufferTexture(id(), GL_DEPTH_ATTACHMENT, texture.id(), 0);
}

void Framebuffer::drawTo(int count) const {
  std::vector<GLenum> attachments(static_cast<std::size_t>(count));
  std::iota(attachments.begin(), attachments.end(), GLenum{GL_COLOR_ATTACHMENT0});
  drawTo(attachments);
}

void Framebuffer::drawTo(std::span<const GLenum> attachments) const {
  glNamedFramebufferDrawBuffers(id(), static_cast<GLsizei>(attachments.size()), attachments.data());
}

Result<void> Framebuffer::check() const {
  const GLenum status = glCheckNamedFramebufferStatus(id(), GL_FRAMEBUFFER);
  if (status == GL_FRAMEBUFFER_COMPLETE) return {};
  return runtimeError("The graphics driver can't draw into one of the images we need (framebuffer status " +
                      std::to_string(status) + "); a newer driver or Mesa's software renderer will.");
}

// ---- the rest

VertexArray VertexArray::create(std::string_view labelText) {
  GLuint id = 0;
  glCreateVertexArrays(1, &id);
  label(GL_VERTEX_ARRAY, id, labelText);
  return VertexArray(id);
}

Sampler Sampler::create(std::string_view labelText) {
  GLuint id = 0;
  glCreateSamplers(1, &id);
  label(GL_SAMPLER, id, labelText);
  return Sampler(id);
}

Query Query::create(GLenum target) {
  GLuint id = 0;
  glCreateQueries(target, 1, &id);
  return Query(id);
}

void drawFullScreen() {
  // Core profiles draw nothing without a vertex array bound; any will do, so the caller's stays if there is one.
  GLint bound = 0;
  glGetIntegerv(GL_VERTEX_ARRAY_BINDING, &bound);
  if (bound != 0) {
    glDrawArrays(GL_TRIANGLES, 0, 3);
    return;
  }
  const VertexArray empty = VertexArray::create("full screen");
  empty.bind();
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glBindVertexArray(0);
}

void restoreDefaults(GLuint framebuffer) {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glUseProgram(0);
  glBindVertexArray(0);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  glDisable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ZERO);
  glDepthFunc(GL_LESS);
  glDepthMask(GL_TRUE);
  glCullFace(GL_BACK);
  glClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
  glActiveTexture(GL_TEXTURE0);
}

}  // namespace dermis::gl
