#include "gl/debug_output.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <mutex>
#include <utility>

namespace dermis::gl {

namespace {

constexpr std::size_t kKeptMessages = 64;

/// Everybody who listens: a renderer and a test may listen to one context, and either may go first. The driver may call
/// from a thread of its own.
struct Listeners {
  std::mutex mutex;
  std::vector<DebugOutput*> all;
};
Listeners& listeners() {
  static Listeners instance;
  return instance;
}

// GLAPIENTRY: the driver calls this.
void GLAPIENTRY onMessage(GLenum source, GLenum type, GLuint /*id*/, GLenum severity, GLsizei length,
                          const GLchar* text, const void* /*user*/) {
  // What the compiler says comes back from the shader library with its file and line.
  if (source == GL_DEBUG_SOURCE_SHADER_COMPILER) return;
  if (type != GL_DEBUG_TYPE_ERROR && severity != GL_DEBUG_SEVERITY_HIGH) return;
  const std::string message = length < 0 ? std::string(text) : std::string(text, static_cast<std::size_t>(length));
  const std::lock_guard lock(listeners().mutex);
  for (DebugOutput* listener : listeners().all) listener->record(message);
}

}  // namespace

DebugOutput::DebugOutput(bool synchronous) {
  glEnable(GL_DEBUG_OUTPUT);
  if (synchronous)
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
  else
    glDisable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
  glDebugMessageControl(GL_DONT_CARE, GL_DONT_CARE, GL_DEBUG_SEVERITY_NOTIFICATION, 0, nullptr, GL_FALSE);
  glDebugMessageCallback(onMessage, nullptr);
  while (glGetError() != GL_NO_ERROR) {  // what happened before us is not ours
  }
  const std::lock_guard lock(listeners().mutex);
  listeners().all.push_back(this);
}

DebugOutput::~DebugOutput() {
  // The callback stays with the context; with nobody listening it does nothing.
  const std::lock_guard lock(listeners().mutex);
  std::erase(listeners().all, this);
}

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
