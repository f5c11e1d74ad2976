// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Core>
#include <cstddef>
#include <map>
#include <memory>
#include <opencv2/core/types.hpp>
#include <string>
#include <vector>

#include "sim/render/geom_shapes.h"
#include "sim/render/lit_program.h"
#include "sim/render/shadow_maps.h"

namespace horopter::sim {

/// Draws an mjvScene as mjr_render does, at less cost: each surface is lit once for all lights
/// instead of once for each that casts a shadow, shadow maps are kept for as long as they hold, and
/// the number of the geom that a pixel shows is written beside its colour.
///
/// Numbers are 1 + the geom's index in the scene, 0 where there is nothing: the low byte is alpha,
/// the high byte the stencil. Transparent geoms are blended into the colours of what is behind them
/// and are solid to depth and numbers; the sky has neither.
class OnePass {
 public:
  /// Both must outlive it; their context is current in every call.
  OnePass(const GlFunctions& gl, const mjrContext& mujoco);

  /// How many numbers a pixel of this scene may show, as a table of them must be long.
  static std::size_t NumbersOf(const mjvScene& scene) {
    return scene.ngeom > kLowNumbers ? 1u << 16 : 1u << 8;
  }

  /// Why a scene must be left to mjr_render; empty when it need not.
  static std::string CannotDraw(const mjvScene& scene);

  /// Draws into the lower left corner of MuJoCo's off-screen buffer.
  /// @param colours or else numbers and depth only, which any scene of model geoms has
  /// @pre both cameras of the scene are the same; CannotDraw(scene) is empty if colours are wanted
  void Draw(const mjvScene& scene, cv::Size size, bool colours);
  /// Brings the shadow maps up to date, which Draw() with colours would do as well.
  void UpdateShadows(const mjvScene& scene);

 private:
  static constexpr int kLowNumbers = 255;  // geoms that alpha alone can number

  struct Order {
    std::vector<int> opaque;       // front to back
    std::vector<int> transparent;  // front to back
  };

  /// Those that may be seen.
  Order Sort(const mjvScene& scene, cv::Size size) const;
  /// All that the fixed pipeline may have been left in.
  void SetState() const;
  void SetView(const mjvScene& scene, cv::Size size);
  void ClearAll(cv::Size size, bool many) const;
  void PlaceLights(const mjvScene& scene) const;
  void DrawNumbers(const mjvScene& scene, const std::vector<int>& geoms) const;
  void DrawOpaque(const mjvScene& scene, const std::vector<int>& geoms);
  void DrawSky(const mjvScene& scene) const;
  void DrawHaze(const mjvScene& scene, float radius) const;
  void DrawTransparent(const mjvScene& scene, const std::vector<int>& geoms);
  /// @param opaque receives shadows and writes its number, or else is blended
  void DrawLit(const mjvScene& scene, int geom, bool opaque);
  const LitProgram& ProgramFor(const mjvScene& scene, const mjvGeom& geom, bool opaque);
  void BindImage(const mjvGeom& geom, const LitProgram& program) const;
  void SetNumber(const mjvScene& scene, int geom) const;

  const GlFunctions& gl_;
  const mjrContext& mujoco_;
  GeomShapes shapes_;
  ShadowMaps shadows_;
  bool own_levels_;
  std::map<LitProgramKind, std::unique_ptr<LitProgram>> programs_;
  const LitProgram* in_use_ = nullptr;
  Eigen::Matrix4f world_from_eye_;
};

}  // namespace horopter::sim
