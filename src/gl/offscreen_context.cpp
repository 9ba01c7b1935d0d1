// Displays are tried in this order: Mesa's surfaceless platform, the first device (drivers without Mesa), the
// default display. A display is shared by the whole process, so it is never terminated.
#include "gl/offscreen_context.h"

#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <string>
#include <vector>

namespace cg {

namespace {

[[noreturn]] void fail(const char* en, const char* ja) { throw NoContext(Text{en, ja}); }

std::vector<EGLDisplay> candidate_displays() {
  std::vector<EGLDisplay> displays;
  const bool platforms = epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_platform_base");
  if (platforms && epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless"))
    displays.push_back(eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr));
  if (platforms && epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_platform_device") &&
      epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_device_enumeration")) {
    EGLDeviceEXT device = nullptr;
    EGLint count = 0;
    if (eglQueryDevicesEXT(1, &device, &count) && count > 0)
      displays.push_back(eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, device, nullptr));
  }
  displays.push_back(eglGetDisplay(EGL_DEFAULT_DISPLAY));
  return displays;
}

EGLDisplay open_display() {
  for (EGLDisplay display : candidate_displays())
    if (display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr)) {
      if (epoxy_has_egl_extension(display, "EGL_KHR_surfaceless_context")) return display;
    }
  fail("EGL finds no driver that draws off screen", "画面なしで描ける EGL ドライバーがありません");
}

EGLConfig any_config(EGLDisplay display) {
  const EGLint wanted[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  if (!eglChooseConfig(display, wanted, &config, 1, &count) || count == 0)
    fail("EGL offers no configuration for OpenGL", "EGL に OpenGL 用の構成がありません");
  return config;
}

// Whether the current context still has glLight and glMaterial.
bool has_fixed_function() {
  if (epoxy_gl_version() < 31) return true;
  if (epoxy_gl_version() >= 32) {
    GLint mask = 0;
    glGetIntegerv(GL_CONTEXT_PROFILE_MASK, &mask);
    return mask & GL_CONTEXT_COMPATIBILITY_PROFILE_BIT;
  }
  return epoxy_has_gl_extension("GL_ARB_compatibility");
}

// RGBA32F and 32F depth to draw into, vertex and fragment clamping that can be switched off.
bool has_float_framebuffers() { return epoxy_gl_version() >= 30; }

}  // namespace

OffscreenContext::OffscreenContext(GlProfile profile) {
  display_ = open_display();
  if (!eglBindAPI(EGL_OPENGL_API)) fail("EGL offers no desktop OpenGL here", "この EGL では OpenGL を使えません");
  // Without a version EGL gives the newest context that is compatible with OpenGL 1.0.
  const std::vector<EGLint> core = {EGL_CONTEXT_MAJOR_VERSION_KHR,
                                    3,
                                    EGL_CONTEXT_MINOR_VERSION_KHR,
                                    3,
                                    EGL_CONTEXT_OPENGL_PROFILE_MASK_KHR,
                                    EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT_KHR,
                                    EGL_NONE};
  const std::vector<EGLint> legacy = {EGL_NONE};
  const bool fixed = profile == GlProfile::legacy;
  const bool any = epoxy_has_egl_extension(display_, "EGL_KHR_no_config_context");
  context_ = eglCreateContext(display_, any ? EGL_NO_CONFIG_KHR : any_config(display_), EGL_NO_CONTEXT,
                              (fixed ? legacy : core).data());
  if (context_ == EGL_NO_CONTEXT) {
    if (fixed) fail("the driver gives no legacy OpenGL context", "ドライバーに旧式の OpenGL コンテキストがありません");
    fail("the driver has no OpenGL 3.3", "ドライバーが OpenGL 3.3 に対応していません");
  }
  const char* missing_en = nullptr;
  const char* missing_ja = nullptr;
  if (!eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_))
    missing_en = "the OpenGL context cannot be used", missing_ja = "OpenGL コンテキストを使えません";
  else if (fixed && !has_fixed_function())
    missing_en = "the driver's OpenGL has no fixed function (glLight, glMaterial)",
    missing_ja = "このドライバーの OpenGL には固定機能（glLight、glMaterial）がありません";
  else if (!has_float_framebuffers())
    missing_en = "the driver cannot draw into floating-point pictures",
    missing_ja = "ドライバーが浮動小数点の画像に描けません";
  if (missing_en) {
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display_, context_);
    fail(missing_en, missing_ja);
  }
}

OffscreenContext::~OffscreenContext() {
  eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglDestroyContext(display_, context_);
  eglReleaseThread();
}

}  // namespace cg
