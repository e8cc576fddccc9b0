// Somewhere to show pictures where there is no window: what a benchmark or a thumbnail draws into.
#pragma once

#include <glm/glm.hpp>
#include <memory>

#include "core/image/image.h"

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
  /// What was drawn, U8 RGBA, top row first.
  [[nodiscard]] Image read() const;

 private:
  struct Objects;
  std::unique_ptr<Objects> m_objects;
};

}  // namespace dermis::gl
