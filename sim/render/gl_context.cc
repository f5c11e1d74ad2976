// SPDX-License-Identifier: Apache-2.0
#include "sim/render/gl_context.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "hardware/types/config_error.h"
#include "sim/render/osmesa_context.h"

namespace horopter::sim {

std::vector<std::string_view> GlBackends() { return {"osmesa", "egl"}; }

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

  if (backend == "osmesa") return CreateOsmesaContext(width, height);
  throw RenderError(
      fmt::format("GL backend '{}' is not available in this build; use 'osmesa'", backend));
}

}  // namespace horopter::sim
