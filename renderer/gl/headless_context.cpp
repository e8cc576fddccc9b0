#include "gl/headless_context.h"

#include <epoxy/egl.h>

#include <array>
#include <vector>

namespace dermis::gl {

namespace {

/// A 4.5 core context with KHR_debug on an initialised display, or EGL_NO_CONTEXT and the reason.
EGLContext makeContext(EGLDisplay display, std::string& reason) {
  EGLint major = 0;
  EGLint minor = 0;
  if (eglInitialize(display, &major, &minor) == EGL_FALSE) {
    reason = "EGL does not start";
    return EGL_NO_CONTEXT;
  }
  if (eglBindAPI(EGL_OPENGL_API) == EGL_FALSE) {
    reason = "EGL offers no desktop OpenGL";
    return EGL_NO_CONTEXT;
  }
  // No surface is ever made, so no config is needed; drivers without EGL_KHR_no_config_context take any one.
  EGLConfig config = EGL_NO_CONFIG_KHR;
  if (!epoxy_has_egl_extension(display, "EGL_KHR_no_config_context")) {
    const std::array<EGLint, 5> wanted = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE, EGL_PBUFFER_BIT,
                                          EGL_NONE};
    EGLint count = 0;
    if (eglChooseConfig(display, wanted.data(), &config, 1, &count) == EGL_FALSE || count == 0) {
      reason = "EGL offers no configuration for OpenGL";
      return EGL_NO_CONTEXT;
    }
  }
  const std::array<EGLint, 9> attributes = {EGL_CONTEXT_MAJOR_VERSION,
                                            4,
                                            EGL_CONTEXT_MINOR_VERSION,
                                            5,
                                            EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                            EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                            EGL_CONTEXT_OPENGL_DEBUG,
                                            EGL_TRUE,
                                            EGL_NONE};
  EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, attributes.data());
  if (context == EGL_NO_CONTEXT) {
    reason = "the driver has no OpenGL 4.5 core";
    return EGL_NO_CONTEXT;
  }
  if (eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) == EGL_FALSE) {
    eglDestroyContext(display, context);
    reason = "the driver needs a window";
    return EGL_NO_CONTEXT;
  }
  return context;
}

bool hasClientExtension(const char* name) { return epoxy_has_egl_extension(EGL_NO_DISPLAY, name); }

}  // namespace

Result<std::unique_ptr<HeadlessContext>> HeadlessContext::create() {
  std::string reason = "no EGL platform without a display";
  std::unique_ptr<HeadlessContext> made(new HeadlessContext);
  const auto attempt = [&](EGLDisplay display, const char* platform) {
    if (display == EGL_NO_DISPLAY) return false;
    std::string why;
    EGLContext context = makeContext(display, why);
    if (context == EGL_NO_CONTEXT) {
      reason = std::string(platform) + ": " + why;
      return false;
    }
    made->m_display = display;
    made->m_context = context;
    made->m_platform = platform;
    return true;
  };

  if (hasClientExtension("EGL_MESA_platform_surfaceless") &&
      attempt(eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr), "EGL surfaceless"))
    return made;

  if (hasClientExtension("EGL_EXT_platform_device") && hasClientExtension("EGL_EXT_device_enumeration")) {
    std::array<EGLDeviceEXT, 16> devices{};
    EGLint count = 0;
    eglQueryDevicesEXT(static_cast<EGLint>(devices.size()), devices.data(), &count);
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i)
      if (attempt(eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, devices.at(i), nullptr), "EGL device")) return made;
  }
  return runtimeError("OpenGL 4.5 is not available without a window (" + reason +
                      "); install a driver, or Mesa's software renderer (Debian: libegl1 and libgl1-mesa-dri).");
}

HeadlessContext::~HeadlessContext() {
  if (m_context == nullptr) return;
  if (eglGetCurrentContext() == m_context) release();
  eglDestroyContext(m_display, m_context);
  // The display stays initialised: EGL hands out one for the whole process, and another context may be using it.
}

void HeadlessContext::makeCurrent() const { eglMakeCurrent(m_display, EGL_NO_SURFACE, EGL_NO_SURFACE, m_context); }

void HeadlessContext::release() const { eglMakeCurrent(m_display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT); }

}  // namespace dermis::gl
