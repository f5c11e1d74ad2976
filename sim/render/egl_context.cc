// SPDX-License-Identifier: Apache-2.0
#include "sim/render/egl_context.h"

#include <fmt/format.h>

#include <array>

#include "sim/render/egl_library.h"

namespace horopter::sim {
namespace {

class EglContext final : public GlContext {
 public:
  EglContext(const EglLibrary& egl, int width, int height) : egl_(egl), display_(egl.Display()) {
    const EGLConfig config = egl_.Config(display_);
    const std::array<EGLint, 5> size = {EGL_WIDTH, width, EGL_HEIGHT, height, EGL_NONE};
    egl_.BindAPI(EGL_OPENGL_API);
    surface_ = egl_.CreatePbufferSurface(display_, config, size.data());
    context_ = egl_.CreateContext(display_, config, EGL_NO_CONTEXT, nullptr);
    if (surface_ == EGL_NO_SURFACE || context_ == EGL_NO_CONTEXT) {
      const std::string problem = LastError();
      Destroy();
      throw RenderError(fmt::format("EGL could not create an OpenGL context: {}", problem));
    }
  }
  ~EglContext() override {
    Release();
    Destroy();
  }
  EglContext(const EglContext&) = delete;
  EglContext& operator=(const EglContext&) = delete;

  void MakeCurrent() override {
    egl_.BindAPI(EGL_OPENGL_API);  // the API is each thread's own
    if (egl_.GetCurrentContext() == context_) return;
    if (!egl_.MakeCurrent(display_, surface_, surface_, context_)) {
      throw RenderError(fmt::format("EGL could not make its context current: {}", LastError()));
    }
  }

  void Release() override {
    egl_.BindAPI(EGL_OPENGL_API);
    if (egl_.GetCurrentContext() != context_) return;
    egl_.MakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  }

  std::string_view name() const override { return "egl"; }

  std::string gl_renderer() override {
    using GetString = const unsigned char* (*)(unsigned);
    constexpr unsigned kRenderer = 0x1F01;  // GL_RENDERER
    MakeCurrent();
    const auto get_string = reinterpret_cast<GetString>(Function("glGetString"));
    const auto* name = get_string != nullptr ? get_string(kRenderer) : nullptr;
    return name == nullptr ? "unknown" : reinterpret_cast<const char*>(name);
  }

  AnyFunction Function(const char* gl_name) override { return egl_.GetProcAddress(gl_name); }

 private:
  std::string LastError() const { return fmt::format("EGL error {:#x}", egl_.GetError()); }

  void Destroy() {
    if (context_ != EGL_NO_CONTEXT) egl_.DestroyContext(display_, context_);
    if (surface_ != EGL_NO_SURFACE) egl_.DestroySurface(display_, surface_);
  }

  const EglLibrary& egl_;
  EGLDisplay display_;
  EGLSurface surface_ = EGL_NO_SURFACE;
  ::EGLContext context_ = EGL_NO_CONTEXT;
};

}  // namespace

std::unique_ptr<GlContext> CreateEglContext(int width, int height) {
  const EglLibrary& egl = EglLibrary::Instance();
  auto context = std::make_unique<EglContext>(egl, width, height);
  context->MakeCurrent();
  egl.Export();
  return context;
}

}  // namespace horopter::sim
