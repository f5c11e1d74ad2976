// SPDX-License-Identifier: Apache-2.0
#pragma once

#define EGL_NO_X11
#define MESA_EGL_NO_X11_HEADERS
#include <EGL/egl.h>
#include <EGL/eglext.h>

namespace horopter::sim {

// clang-format off
#define HOROPTER_EGL_FUNCTIONS(X)                                                                  \
  X(BindAPI) X(ChooseConfig) X(CreateContext) X(CreatePbufferSurface) X(DestroyContext)            \
  X(DestroySurface) X(GetCurrentContext) X(GetError) X(GetProcAddress) X(Initialize)               \
  X(MakeCurrent) X(QueryString)
// clang-format on

/// libEGL, loaded at run time so that a process which never asks for it never exports it: MuJoCo
/// would take its OpenGL functions from it, and OSMesa would no longer work.
class EglLibrary {
 public:
  /// @throws RenderError when it is not installed or too old
  static const EglLibrary& Instance();

  /// Makes it visible to MuJoCo's loader, which takes whatever eglGetProcAddress the process
  /// exports.
  void Export() const;
  /// The display that every context of the process shares: EGL hands out one per device anyway.
  /// @throws RenderError with what each device said, when none can draw off-screen
  EGLDisplay Display() const;
  EGLConfig Config(EGLDisplay display) const;

#define HOROPTER_EGL_MEMBER(name) decltype(&::egl##name) name = nullptr;
  HOROPTER_EGL_FUNCTIONS(HOROPTER_EGL_MEMBER)
#undef HOROPTER_EGL_MEMBER

 private:
  EglLibrary();
};

}  // namespace horopter::sim
