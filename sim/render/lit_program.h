// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <compare>
#include <string_view>
#include <vector>

#include "sim/render/gl_functions.h"

namespace horopter::sim {

enum class ImageKind { kNone, kFlat, kFlatGenerated, kCube };

/// What a light does to a program: its parameters are GL's own (glLightfv), its number is its
/// place.
struct LightKind {
  bool directional = false;
  bool shadow = false;
  auto operator<=>(const LightKind&) const = default;
};

/// What a program is compiled for.
struct LitProgramKind {
  ImageKind image = ImageKind::kNone;
  bool shiny = false;
  std::vector<LightKind> lights;
  /// The image's mipmap level is found by the program, not by the driver (FindsOwnLevels).
  bool own_levels = false;
  auto operator<=>(const LitProgramKind&) const = default;
};

/// Whether programs should find the mipmap level of an image themselves. OpenGL leaves its formula
/// to drivers, and pictures depend on it. llvmpipe, the renderer of every day, comes within 0.05 of
/// the one that OpenGL recommends; others are made to take it (results/paper/render_agreement.md).
/// @param gl_renderer what the driver calls itself
bool FindsOwnLevels(std::string_view gl_renderer);

/// A GLSL program that lights a surface once for all lights, as the fixed pipeline of OpenGL 2.1
/// does in a pass per shadow light (OpenGL 2.1 specification, 2.14.1): per vertex, clamped, times
/// the texture; the sum of the passes, each rounded to eight bits. A shadow light counts where its
/// shadow map says so.
///
/// Texture unit 0 has the image; unit 1 + k the shadow map of the k-th shadow light. Alpha is
/// whatever number the caller gives.
class LitProgram {
 public:
  /// @throws RenderError with the compiler's words
  LitProgram(const GlFunctions& gl, const LitProgramKind& kind);
  ~LitProgram();
  LitProgram(const LitProgram&) = delete;
  LitProgram& operator=(const LitProgram&) = delete;

  void Use() const { gl_.UseProgram(program_); }
  // These are for the program in use.
  void SetAlpha(float alpha) const { gl_.Uniform1f(alpha_, alpha); }
  void SetMaterial(float emission, float specular, float shininess) const {
    gl_.Uniform3f(material_, emission, specular, shininess);
  }
  /// Factors of the vertex that give the image's coordinates; two more terms for flat ones.
  void SetImageScale(float x, float y, float z) const { gl_.Uniform3f(image_scale_, x, y, z); }
  /// Eye coordinates to those of the k-th shadow map, column by column.
  void SetShadowMatrix(int k, const float matrix[16]) const;

 private:
  const GlFunctions& gl_;
  GLuint program_ = 0;
  GLint alpha_ = -1;
  GLint material_ = -1;
  GLint image_scale_ = -1;
  std::vector<GLint> shadow_matrices_;
};

}  // namespace horopter::sim
