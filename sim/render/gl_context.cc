// SPDX-License-Identifier: Apache-2.0
#include "sim/render/gl_context.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <mutex>
#include <utility>

#include "hardware/types/config_error.h"
#include "sim/render/egl_context.h"
#include "sim/render/osmesa_context.h"

namespace horopter::sim {
namespace {

struct ProcessBackend {
  std::mutex mutex;
  std::string backend;  // empty until the first context
};

ProcessBackend& Process() {
  static ProcessBackend process;
  return process;
}

}  // namespace

std::vector<std::string_view> GlBackends() { return {"osmesa", "egl"}; }

std::string GlBackendInUse() {
  const std::lock_guard lock(Process().mutex);
  return Process().backend;
}

std::unique_ptr<GlContext> CreateGlContext(std::string_view backend, int width, int height) {
  std::vector<hardware::FieldError> errors;
  const auto known = GlBackends();
  if (std::find(known.begin(), known.end(), backend) == known.end()) {
    errors.push_back({"renderer.gl_backend", std::string(backend),
                      fmt::format("must be one of {}", fmt::join(known, ", "))});
  }
  if (width < 1) errors.push_back({"renderer.width", std::to_string(width), "must be at least 1"});
  if (height < 1) {
    errors.push_back({"renderer.height", std::to_string(height), "must be at least 1"});
  }
  hardware::ThrowIfAny(std::move(errors));

  const std::lock_guard lock(Process().mutex);
  std::string& used = Process().backend;
  if (!used.empty() && used != backend) {
    throw RenderError(
        fmt::format("GL backend '{}' cannot be used: this process already draws with '{}', and "
                    "MuJoCo loads its "
                    "OpenGL functions once per process. Use one backend per process",
                    backend, used));
  }
  auto context =
      backend == "egl" ? CreateEglContext(width, height) : CreateOsmesaContext(width, height);
  used = backend;
  return context;
}

}  // namespace horopter::sim
