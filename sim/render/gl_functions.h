// SPDX-License-Identifier: Apache-2.0
#pragma once

#ifndef GL_GLEXT_PROTOTYPES
#define GL_GLEXT_PROTOTYPES  // for the types of the functions; none is linked by its name
#endif
#include <GL/gl.h>
#include <GL/glext.h>

#include "sim/render/gl_context.h"

namespace horopter::sim {

// clang-format off
#define HOROPTER_GL_FUNCTIONS(X)                                                                   \
  X(ActiveTexture) X(AttachShader) X(BindFramebuffer) X(BindTexture) X(BlendFunc) X(CallList)      \
  X(CheckFramebufferStatus) X(Clear) X(ClearColor) X(ClearDepth) X(ClearStencil) X(Color4f)        \
  X(ColorMask) X(CompileShader) X(CreateProgram) X(CreateShader) X(CullFace)                       \
  X(DeleteFramebuffers) X(DeleteProgram) X(DeleteShader) X(DeleteTextures) X(DepthFunc)            \
  X(DepthMask) X(DepthRange) X(Disable) X(DrawBuffer) X(Enable) X(Finish) X(FramebufferTexture2D)  \
  X(FrontFace) X(Frustum) X(GenFramebuffers) X(GenTextures) X(GetFloatv) X(GetIntegerv)            \
  X(GetProgramInfoLog) X(GetProgramiv) X(GetShaderInfoLog) X(GetShaderiv) X(GetString)             \
  X(GetUniformLocation) X(LightModelfv) X(Lightf) X(Lightfv) X(LinkProgram) X(LoadIdentity)        \
  X(LoadMatrixf) X(MatrixMode) X(MultMatrixf) X(Ortho) X(PolygonMode) X(PopMatrix) X(PushMatrix)   \
  X(ReadPixels) X(Scalef) X(Scissor) X(ShadeModel) X(ShaderSource) X(StencilFunc) X(StencilOp)     \
  X(TexEnvi) X(TexGenfv) X(TexGeni) X(TexImage2D) X(TexParameteri) X(Translatef) X(Uniform1f)      \
  X(Uniform1i) X(Uniform3f) X(Uniform4f) X(UniformMatrix4fv) X(UseProgram) X(Viewport)
// clang-format on

/// The OpenGL entry points that the renderer calls, taken from a context by name, since the process
/// may hold several OpenGL libraries: gl.Clear(...) is glClear(...) of that context's library.
struct GlFunctions {
#define HOROPTER_GL_MEMBER(name) decltype(&::gl##name) name = nullptr;
  HOROPTER_GL_FUNCTIONS(HOROPTER_GL_MEMBER)
#undef HOROPTER_GL_MEMBER

  /// @throws RenderError naming the function that this OpenGL lacks
  explicit GlFunctions(GlContext& context);
};

}  // namespace horopter::sim
