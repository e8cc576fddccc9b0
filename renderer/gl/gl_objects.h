// OpenGL objects as move-only values: made with direct state access, labelled for debuggers, deleted with their owner.
//
// Every function here needs the context current in which the object was made. Private to dermis_renderer (and its
// tests): nothing outside includes a GL header.
#pragma once

#include <epoxy/gl.h>

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/result.h"

namespace dermis::gl {

/// Deletes one object of a kind; the template argument of Handle.
using Deleter = void (*)(GLuint);
void deleteBuffer(GLuint id);
void deleteTexture(GLuint id);
void deleteFramebuffer(GLuint id);
void deleteVertexArray(GLuint id);
void deleteSampler(GLuint id);
void deleteQuery(GLuint id);
void deleteProgram(GLuint id);

/// Owns one GL name; 0 is none.
template <Deleter Delete>
class Handle {
 public:
  Handle() = default;
  explicit Handle(GLuint id) : m_id(id) {}
  Handle(Handle&& other) noexcept : m_id(std::exchange(other.m_id, 0U)) {}
  Handle& operator=(Handle&& other) noexcept {
    if (this != &other) {
      reset();
      m_id = std::exchange(other.m_id, 0U);
    }
    return *this;
  }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  ~Handle() { reset(); }

  [[nodiscard]] GLuint id() const { return m_id; }
  explicit operator bool() const { return m_id != 0; }
  void reset() {
    if (m_id != 0) Delete(std::exchange(m_id, 0U));
  }

 private:
  GLuint m_id = 0;
};

/// Names an object for KHR_debug: `identifier` is GL_BUFFER, GL_TEXTURE, ….
void label(GLenum identifier, GLuint id, std::string_view text);

/// A buffer with immutable storage.
class Buffer : public Handle<deleteBuffer> {
 public:
  Buffer() = default;
  /// Filled once, never written again.
  [[nodiscard]] static Buffer fixed(std::string_view label, std::span<const std::byte> bytes);
  /// To be written with update(): uniform blocks.
  [[nodiscard]] static Buffer writable(std::string_view label, std::size_t size);

  void update(std::size_t offset, std::span<const std::byte> bytes) const;
  void bindUniform(GLuint binding) const;
  void bindStorage(GLuint binding) const;
  [[nodiscard]] std::size_t size() const { return m_size; }

 private:
  using Handle::Handle;
  std::size_t m_size = 0;
};

/// What a texture is made as.
struct TextureSpec {
  GLenum target = GL_TEXTURE_2D;  ///< 1D, 2D, 2D_MULTISAMPLE, 2D_ARRAY, 3D, CUBE_MAP or CUBE_MAP_ARRAY
  GLenum format = GL_RGBA16F;     ///< sized internal format
  int width = 1, height = 1;
  int depth = 1;    ///< layers of a 2D array, cubes of a cube array, slices of a 3D texture
  int levels = 1;   ///< 0: all down to 1×1
  int samples = 1;  ///< for 2D_MULTISAMPLE
  std::string label;
};

/// A texture with immutable storage. Fresh ones filter linearly (with mips where there are any) and clamp to the edge.
class Texture : public Handle<deleteTexture> {
 public:
  Texture() = default;
  [[nodiscard]] static Texture create(const TextureSpec& spec);

  /// Fills one level of a 2D texture; rows are tightly packed.
  void upload(int level, GLenum format, GLenum type, const void* pixels) const;
  /// Fills one layer of an array, one face of a cube (0..5), one layer-face of a cube array, or one slice of a 3D
  /// texture.
  void uploadLayer(int level, int layer, GLenum format, GLenum type, const void* pixels) const;
  /// Fills a whole level of a 3D texture, array or cube.
  void uploadAll(int level, GLenum format, GLenum type, const void* pixels) const;
  /// The same texels seen as an array of one layer, which filters and repeats as this one does.
  [[nodiscard]] Texture asArray() const;
  void setFilter(GLenum minification, GLenum magnification) const;
  void setWrap(GLenum mode) const;
  /// Clamped to what the driver offers.
  void setAnisotropy(float samples) const;
  void bind(GLuint unit) const { glBindTextureUnit(unit, id()); }
  void bindImage(GLuint unit, int level, GLenum access) const;  ///< all layers

  /// Reads a level as floats, `channels` each texel, all layers, first row lowest.
  [[nodiscard]] std::vector<float> readFloats(int channels, int level = 0) const;

  [[nodiscard]] const TextureSpec& spec() const { return m_spec; }
  [[nodiscard]] int width(int level = 0) const { return std::max(1, m_spec.width >> level); }
  [[nodiscard]] int height(int level = 0) const { return std::max(1, m_spec.height >> level); }
  [[nodiscard]] int levels() const { return m_spec.levels; }
  /// Bytes of video memory, about.
  [[nodiscard]] std::size_t bytes() const;

 private:
  using Handle::Handle;
  TextureSpec m_spec;
};

/// A framebuffer made of textures.
class Framebuffer : public Handle<deleteFramebuffer> {
 public:
  Framebuffer() = default;
  [[nodiscard]] static Framebuffer create(std::string_view label);

  void attachColour(GLuint index, const Texture& texture, int level = 0) const;
  /// One layer, cube face or layer-face.
  void attachColourLayer(GLuint index, const Texture& texture, int level, int layer) const;
  void attachDepth(const Texture& texture) const;
  /// Draws into colour attachments 0..count-1.
  void drawTo(int count) const;
  /// Draws into exactly these; GL_NONE leaves an output out.
  void drawTo(std::span<const GLenum> attachments) const;
  void bind() const { glBindFramebuffer(GL_FRAMEBUFFER, id()); }
  /// Errors: Runtime, incomplete.
  [[nodiscard]] Result<void> check() const;

 private:
  using Handle::Handle;
};

class VertexArray : public Handle<deleteVertexArray> {
 public:
  VertexArray() = default;
  [[nodiscard]] static VertexArray create(std::string_view label);
  void bind() const { glBindVertexArray(id()); }

 private:
  using Handle::Handle;
};

class Sampler : public Handle<deleteSampler> {
 public:
  Sampler() = default;
  [[nodiscard]] static Sampler create(std::string_view label);

 private:
  using Handle::Handle;
};

class Query : public Handle<deleteQuery> {
 public:
  Query() = default;
  [[nodiscard]] static Query create(GLenum target);

 private:
  using Handle::Handle;
};

using ProgramHandle = Handle<deleteProgram>;

/// Draws one triangle that covers the viewport; the vertex shader makes its corners from gl_VertexID.
void drawFullScreen();
/// Back to what OpenGL starts with, `framebuffer` bound: a host that draws after us finds what it expects.
void restoreDefaults(GLuint framebuffer);

/// Levels of a full mip chain.
[[nodiscard]] int fullMipCount(int width, int height);

}  // namespace dermis::gl
