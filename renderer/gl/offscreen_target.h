// Somewhere to show pictures where there is no window: what a benchmark or a thumbnail draws into.
#pragma once

#include <glm/glm.hpp>
#include <memory>

namespace dermis::gl {

/// An RGBA8 framebuffer in the current context; goes before the context does.
class OffscreenTarget {
 public:
  explicit OffscreenTarget(glm::ivec2 size);
  ~OffscreenTarget();
  OffscreenTarget(const OffscreenTarget&) = delete;
  OffscreenTarget& operator=(const OffscreenTarget&) = delete;

  /// For FrameRequest::framebuffer.
  [[nodiscard]] unsigned framebuffer() const;

 private:
  struct Objects;
  std::unique_ptr<Objects> m_objects;
};

}  // namespace dermis::gl
