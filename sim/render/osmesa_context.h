// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "sim/render/gl_context.h"

namespace horopter::sim {

/// Mesa's software renderer (llvmpipe) in memory of our own: needs neither a GPU nor a display.
/// @pre width, height >= 1
/// @throws RenderError
std::unique_ptr<GlContext> CreateOsmesaContext(int width, int height);

}  // namespace horopter::sim
