#include "gl/offscreen_target.h"

#include <algorithm>

#include "gl/gl_objects.h"

namespace dermis::gl {

struct OffscreenTarget::Objects {
  Texture picture;
  Framebuffer framebuffer;
};

OffscreenTarget::OffscreenTarget(glm::ivec2 size) : m_objects(std::make_unique<Objects>()) {
  m_objects->picture =
      Texture::create({.format = GL_RGBA8, .width = size.x, .height = size.y, .label = "offscreen picture"});
  m_objects->framebuffer = Framebuffer::create("offscreen picture");
  m_objects->framebuffer.attachColour(0, m_objects->picture);
  m_objects->framebuffer.drawTo(1);
}

OffscreenTarget::~OffscreenTarget() = default;

unsigned OffscreenTarget::framebuffer() const { return m_objects->framebuffer.id(); }

Image OffscreenTarget::read() const {
  const Texture& picture = m_objects->picture;
  Image image;
  image.width = picture.width();
  image.height = picture.height();
  image.channels = 4;
  image.type = PixelType::U8;
  const std::size_t row = image.rowBytes(), rows = static_cast<std::size_t>(image.height);
  image.pixels.resize(row * rows);
  glGetTextureImage(picture.id(), 0, GL_RGBA, GL_UNSIGNED_BYTE, static_cast<GLsizei>(image.pixels.size()),
                    image.pixels.data());
  const auto at = [&](std::size_t y) { return image.pixels.begin() + static_cast<std::ptrdiff_t>(y * row); };
  for (std::size_t y = 0; y < rows / 2; ++y) std::swap_ranges(at(y), at(y + 1), at(rows - 1 - y));
  return image;
}

}  // namespace dermis::gl
