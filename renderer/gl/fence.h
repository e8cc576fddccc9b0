// A place in the stream of commands.
#pragma once

#include <epoxy/gl.h>

#include <utility>

namespace dermis::gl {

/// Tells when the driver has done what was asked of it before. Needs the context current in which it was made.
class Fence {
 public:
  Fence() = default;
  /// After all that has been asked for so far, which is sent on its way.
  [[nodiscard]] static Fence here();
  Fence(Fence&& other) noexcept : m_sync(std::exchange(other.m_sync, nullptr)) {}
  Fence& operator=(Fence&& other) noexcept;
  Fence(const Fence&) = delete;
  Fence& operator=(const Fence&) = delete;
  ~Fence();

  /// Asks without waiting; one that stands nowhere is passed.
  [[nodiscard]] bool isPassed() const;

 private:
  explicit Fence(GLsync sync) : m_sync(sync) {}
  GLsync m_sync = nullptr;
};

}  // namespace dermis::gl
