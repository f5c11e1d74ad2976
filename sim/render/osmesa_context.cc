// SPDX-License-Identifier: Apache-2.0
#include "sim/render/osmesa_context.h"

#include <GL/osmesa.h>
#include <dlfcn.h>
#include <fmt/format.h>

#include <cstddef>
#include <cstdint>

namespace horopter::sim {
namespace {

class OsmesaContext final : public GlContext {
 public:
  OsmesaContext(int width, int height)
      : width_(width),
        height_(height),
        pixels_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4),
        context_(OSMesaCreateContextExt(OSMESA_RGBA, kDepthBits, kStencilBits, 0, nullptr)) {
    if (context_ == nullptr) throw RenderError("OSMesa could not create an OpenGL context");
    try {
      MakeCurrent();
    } catch (...) {
      OSMesaDestroyContext(context_);
      throw;
    }
  }
  ~OsmesaContext() override { OSMesaDestroyContext(context_); }
  OsmesaContext(const OsmesaContext&) = delete;
  OsmesaContext& operator=(const OsmesaContext&) = delete;

  void MakeCurrent() override {
    if (OSMesaGetCurrentContext() == context_) return;
    if (!OSMesaMakeCurrent(context_, pixels_.data(), GL_UNSIGNED_BYTE, width_, height_)) {
      throw RenderError(fmt::format("OSMesa could not use a {}x{} framebuffer", width_, height_));
    }
  }

  void Release() override {
    if (OSMesaGetCurrentContext() == context_) OSMesaMakeCurrent(nullptr, nullptr, 0, 0, 0);
  }

  std::string_view name() const override { return "osmesa"; }

  std::string gl_renderer() override {
    MakeCurrent();
    const GLubyte* name = glGetString(GL_RENDERER);
    return name == nullptr ? "unknown" : reinterpret_cast<const char*>(name);
  }

  AnyFunction Function(const char* gl_name) override { return OSMesaGetProcAddress(gl_name); }

 private:
  static constexpr int kDepthBits = 24;
  static constexpr int kStencilBits = 8;

  int width_;
  int height_;
  std::vector<std::uint8_t> pixels_;
  ::OSMesaContext context_;
};

}  // namespace

std::unique_ptr<GlContext> CreateOsmesaContext(int width, int height) {
  // MuJoCo's loader takes the first of the two that the process exports.
  if (dlsym(RTLD_DEFAULT, "eglGetProcAddress") != nullptr) {
    throw RenderError(
        "OSMesa cannot be used in a process that exports libEGL: MuJoCo would load its OpenGL "
        "functions from there. Unlink libEGL, or load it with dlopen(RTLD_LOCAL)");
  }
  return std::make_unique<OsmesaContext>(width, height);
}

}  // namespace horopter::sim
