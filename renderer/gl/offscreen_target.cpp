#include "gl/offscreen_target.h"

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

}  // namespace dermis::gl
