// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace horopter::sim {

/// OpenGL cannot do what is asked here: no such backend on this machine, no context, no memory.
class RenderError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// An off-screen OpenGL context (compatibility profile, as MuJoCo needs it).
///
/// Contract:
/// - MakeCurrent() makes it the calling thread's current context; cheap when it already is. One
///   context is used by one thread at a time. @throws RenderError
/// - Release() lets it go, when it is the calling thread's, so that another thread may have it.
/// - gl_renderer() is what the driver calls itself (GL_RENDERER), for reports.
/// - Function() gives a GL entry point, null when there is none of that name.
/// - Contexts are independent: destroying one leaves the others as they are.
class GlContext {
 public:
  using AnyFunction = void (*)();

  virtual ~GlContext() = default;

  virtual void MakeCurrent() = 0;
  virtual void Release() = 0;
  virtual std::string_view name() const = 0;
  virtual std::string gl_renderer() = 0;
  virtual AnyFunction Function(const char* gl_name) = 0;
};

/// The backends that CreateGlContext knows, whether or not this machine has them.
std::vector<std::string_view> GlBackends();

/// A context of exactly the backend named; there is no falling back from one to another. MuJoCo
/// loads its OpenGL functions once per process: the first context decides the backend of all.
/// @param width,height size of its default framebuffer [px]
/// @throws hardware::ConfigError when the name is unknown or the size below 1x1
/// @throws RenderError when the backend is known but not available here, or the process already
///         uses another
std::unique_ptr<GlContext> CreateGlContext(std::string_view backend, int width, int height);

/// The backend that this process draws with; empty before its first context.
std::string GlBackendInUse();

/// What a backend calls its driver (GL_RENDERER), or why there is none.
struct GlProbe {
  std::string renderer;  ///< empty when the backend cannot be used
  std::string problem;   ///< empty when it can
};

/// Tries a backend in a process of its own, so that this one may still choose any; in this one when
/// it draws already.
/// @throws RenderError when no process can be started
GlProbe ProbeGlBackend(std::string_view backend);

}  // namespace horopter::sim
