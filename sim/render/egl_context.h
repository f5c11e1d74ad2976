// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "sim/render/gl_context.h"

namespace horopter::sim {

/// OpenGL through EGL without a window system: on a GPU where there is one, else Mesa's software
/// renderer. libEGL is loaded when first asked for. The first of EGL's devices that gives a context
/// is used, then Mesa's surfaceless platform.
/// @pre width, height >= 1
/// @throws RenderError when libEGL is not installed or no device gives a context, with every reason
std::unique_ptr<GlContext> CreateEglContext(int width, int height);

}  // namespace horopter::sim
