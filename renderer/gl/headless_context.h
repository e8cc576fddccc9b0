// An OpenGL 4.5 core context without a window or a display.
#pragma once

#include <memory>
#include <string>

#include "core/base/result.h"

namespace dermis::gl {

/// Owns the context; it is current in the creating thread after create(). Destroy GL objects before it.
class HeadlessContext {
 public:
  /// Tries EGL's surfaceless platform (Mesa), then the device platform (others). Errors: Runtime, one sentence that
  /// says what was tried.
  [[nodiscard]] static Result<std::unique_ptr<HeadlessContext>> create();
  ~HeadlessContext();
  HeadlessContext(const HeadlessContext&) = delete;
  HeadlessContext& operator=(const HeadlessContext&) = delete;

  void makeCurrent() const;
  void release() const;                                                     ///< makes none current
  [[nodiscard]] const std::string& platform() const { return m_platform; }  ///< "EGL surfaceless" or "EGL device"

 private:
  HeadlessContext() = default;
  void* m_display = nullptr;
  void* m_context = nullptr;
  std::string m_platform;
};

}  // namespace dermis::gl
