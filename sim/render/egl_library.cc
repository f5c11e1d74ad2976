// SPDX-License-Identifier: Apache-2.0
#include "sim/render/egl_library.h"

#include <dlfcn.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <string>
#include <vector>

#include "sim/render/gl_context.h"

namespace horopter::sim {
namespace {

constexpr const char* kLibrary = "libEGL.so.1";

template <typename Function>
void Load(void* library, const char* name, Function& function) {
  function = reinterpret_cast<Function>(dlsym(library, name));
  if (function == nullptr) throw RenderError(fmt::format("{} lacks {}", kLibrary, name));
}

std::string DeviceName(const EglLibrary& egl, EGLDeviceEXT device) {
  const auto query = reinterpret_cast<PFNEGLQUERYDEVICESTRINGEXTPROC>(
      egl.GetProcAddress("eglQueryDeviceStringEXT"));
  const char* file = query != nullptr ? query(device, EGL_DRM_DEVICE_FILE_EXT) : nullptr;
  return file != nullptr ? file : "a device without a file";
}

/// An initialised display that has a usable configuration, or the reason why not.
struct Attempt {
  std::string who;
  EGLDisplay display = EGL_NO_DISPLAY;
  std::string problem;
};

Attempt TryDisplay(const EglLibrary& egl, std::string who, EGLDisplay display) {
  Attempt attempt{std::move(who), EGL_NO_DISPLAY, ""};
  if (display == EGL_NO_DISPLAY) {
    attempt.problem = "no display";
  } else if (!egl.Initialize(display, nullptr, nullptr)) {
    attempt.problem = fmt::format("cannot be initialised (EGL error {:#x})", egl.GetError());
  } else if (egl.Config(display) == nullptr) {
    attempt.problem = "has no off-screen OpenGL configuration";
  } else {
    attempt.display = display;
  }
  return attempt;
}

/// EGL's devices in its own order (GPUs before software), then Mesa without any device.
EGLDisplay OpenDisplay(const EglLibrary& egl) {
  const auto query_devices =
      reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(egl.GetProcAddress("eglQueryDevicesEXT"));
  const auto platform_display = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(
      egl.GetProcAddress("eglGetPlatformDisplayEXT"));
  if (platform_display == nullptr) {
    throw RenderError(fmt::format("{} lacks eglGetPlatformDisplayEXT", kLibrary));
  }
  std::vector<std::string> problems;
  const auto usable = [&problems](const Attempt& attempt) {
    if (attempt.display != EGL_NO_DISPLAY) return true;
    problems.push_back(fmt::format("{}: {}", attempt.who, attempt.problem));
    return false;
  };
  std::array<EGLDeviceEXT, 16> devices{};
  EGLint count = 0;
  if (query_devices != nullptr) {
    query_devices(static_cast<EGLint>(devices.size()), devices.data(), &count);
  }
  for (EGLint i = 0; i < count; ++i) {
    const EGLDeviceEXT device = devices[static_cast<std::size_t>(i)];
    const Attempt attempt = TryDisplay(egl, DeviceName(egl, device),
                                       platform_display(EGL_PLATFORM_DEVICE_EXT, device, nullptr));
    if (usable(attempt)) return attempt.display;
  }
  const Attempt attempt =
      TryDisplay(egl, "surfaceless Mesa",
                 platform_display(EGL_PLATFORM_SURFACELESS_MESA,
                                  reinterpret_cast<void*>(EGL_DEFAULT_DISPLAY), nullptr));
  if (usable(attempt)) return attempt.display;
  throw RenderError(
      fmt::format("EGL cannot draw off-screen here ({}): install libegl-mesa0 or the "
                  "GPU's driver, or use 'osmesa'",
                  fmt::join(problems, "; ")));
}

}  // namespace

EglLibrary::EglLibrary() {
  void* library = dlopen(kLibrary, RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) {
    throw RenderError(
        fmt::format("EGL is not installed ({}): install libegl1, or use 'osmesa'", dlerror()));
  }
#define HOROPTER_EGL_LOAD(name) Load(library, "egl" #name, name);
  HOROPTER_EGL_FUNCTIONS(HOROPTER_EGL_LOAD)
#undef HOROPTER_EGL_LOAD
}

const EglLibrary& EglLibrary::Instance() {
  static const EglLibrary library;
  return library;
}

void EglLibrary::Export() const {
  if (dlopen(kLibrary, RTLD_NOW | RTLD_GLOBAL) == nullptr) throw RenderError(dlerror());
}

EGLDisplay EglLibrary::Display() const {
  static const EGLDisplay display = OpenDisplay(*this);
  return display;
}

EGLConfig EglLibrary::Config(EGLDisplay display) const {
  constexpr std::array<EGLint, 15> kWanted = {EGL_SURFACE_TYPE,
                                              EGL_PBUFFER_BIT,
                                              EGL_RENDERABLE_TYPE,
                                              EGL_OPENGL_BIT,
                                              EGL_RED_SIZE,
                                              8,
                                              EGL_GREEN_SIZE,
                                              8,
                                              EGL_BLUE_SIZE,
                                              8,
                                              EGL_ALPHA_SIZE,
                                              8,
                                              EGL_DEPTH_SIZE,
                                              24,
                                              EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  if (!ChooseConfig(display, kWanted.data(), &config, 1, &count) || count < 1) return nullptr;
  return config;
}

}  // namespace horopter::sim
