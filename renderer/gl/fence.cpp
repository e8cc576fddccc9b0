#include "gl/fence.h"

namespace dermis::gl {

Fence Fence::here() {
  Fence fence(glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0));
  glFlush();
  return fence;
}

Fence& Fence::operator=(Fence&& other) noexcept {
  std::swap(m_sync, other.m_sync);
  return *this;
}

Fence::~Fence() {
  if (m_sync != nullptr) glDeleteSync(m_sync);
}

bool Fence::isPassed() const { return m_sync == nullptr || glClientWaitSync(m_sync, 0, 0) != GL_TIMEOUT_EXPIRED; }

}  // namespace dermis::gl
