// SPDX-License-Identifier: Apache-2.0
#include "sim/render/gl_functions.h"

#include <fmt/format.h>

namespace horopter::sim {
namespace {

template <typename Function>
void Load(GlContext& context, const char* gl_name, Function& function) {
  function = reinterpret_cast<Function>(context.Function(gl_name));
  if (function == nullptr) {
    throw RenderError(fmt::format("{} lacks {}", context.gl_renderer(), gl_name));
  }
}

}  // namespace

GlFunctions::GlFunctions(GlContext& context) {
#define HOROPTER_GL_LOAD(name) Load(context, "gl" #name, name);
  HOROPTER_GL_FUNCTIONS(HOROPTER_GL_LOAD)
#undef HOROPTER_GL_LOAD
}

}  // namespace horopter::sim
