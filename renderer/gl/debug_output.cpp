#include "gl/debug_output.h"

#include <epoxy/gl.h>

#include <utility>

namespace dermis::gl {

namespace {

constexpr std::size_t kKeptMessages = 64;

// GLAPIENTRY: the driver calls this.
void GLAPIENTRY onMessage(GLenum /*source*/, GLenum type, GLuint /*id*/, GLenum severity, GLsizei length,
                          const GLchar* text, const void* user) {
  if (type != GL_DEBUG_TYPE_ERROR && severity != GL_DEBUG_SEVERITY_HIGH) return;
  // GL hands back the pointer as const; the listener was registered as a mutable object.
  auto* listener = static_cast<DebugOutput*>(const_cast<void*>(user));
  listener->record(length < 0 ? std::string(text) : std::string(text, static_cast<std::size_t>(length)));
}

}  // namespace

DebugOutput::DebugOutput(bool synchronous) {
  glEnable(GL_DEBUG_OUTPUT);
  if (synchronous)
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
  else
    glDisable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
  glDebugMessageControl(GL_DONT_CARE, GL_DONT_CARE, GL_DEBUG_SEVERITY_NOTIFICATION, 0, nullptr, GL_FALSE);
  glDebugMessageCallback(onMessage, this);
  while (glGetError() != GL_NO_ERROR) {  // what happened before us is not ours
  }
}

DebugOutput::~DebugOutput() { glDebugMessageCallback(nullptr, nullptr); }

void DebugOutput::record(std::string message) {
  ++m_count;
  if (m_messages.size() < kKeptMessages) m_messages.push_back(std::move(message));
}

void DebugOutput::poll() {
  // A callback has already recorded the errors of a debug context; glGetError then only repeats them.
  const bool heard = !m_messages.empty();
  for (int i = 0; i < 16; ++i) {
    const GLenum error = glGetError();
    if (error == GL_NO_ERROR) return;
    if (!heard) record("OpenGL error " + std::to_string(error));
  }
}

Warnings DebugOutput::take() {
  poll();
  return std::exchange(m_messages, {});
}

}  // namespace dermis::gl
