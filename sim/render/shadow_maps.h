// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Core>
#include <array>
#include <opencv2/core/types.hpp>
#include <vector>

#include "sim/render/geom_shapes.h"

namespace horopter::sim {

/// The shadow maps of a scene's lights, one each, with the texels that mjr_render would give its
/// only one: back faces seen from the light, in the size and clipping that the model asks for.
///
/// A map is kept while it holds. Where a geom has moved, only the rectangles that it left and that
/// it covers now are drawn again, which gives the same texels as drawing all.
class ShadowMaps {
 public:
  ShadowMaps(const GlFunctions& gl, const mjrContext& mujoco, const GeomShapes& shapes);
  ~ShadowMaps();
  ShadowMaps(const ShadowMaps&) = delete;
  ShadowMaps& operator=(const ShadowMaps&) = delete;

  /// Brings the k-th map up to date for this light; the scene's first camera has the clip planes.
  /// Leaves another frame buffer, viewport, matrices and culling behind.
  void Update(int k, const mjvLight& light, const mjvScene& scene);
  GLuint texture(int k) const { return maps_[static_cast<std::size_t>(k)].texture; }
  /// World coordinates to those of the k-th map's texture and depth.
  const Eigen::Matrix4f& map_from_world(int k) const {
    return maps_[static_cast<std::size_t>(k)].map_from_world;
  }

 private:
  /// All of a geom that its shadow depends on.
  struct Caster {
    int type = -1;
    int dataid = -1;
    std::array<float, 3> size{};
    std::array<float, 3> pos{};
    std::array<float, 9> mat{};
    float radius = 0;  ///< of a ball around pos; 0 when not known
    bool operator==(const Caster&) const = default;
  };
  struct Map {
    GLuint frame = 0;
    GLuint texture = 0;
    bool drawn = false;
    mjvLight light{};
    float near = 0, far = 0;
    Eigen::Matrix4f projection, view, map_from_world;
    std::vector<Caster> casters;
  };

  static Caster CasterOf(const mjvGeom& geom);
  Map MakeMap() const;
  /// Gives the map this light and these clip planes; whether it had them already.
  bool TakeLight(Map& map, const mjvLight& light, float near, float far) const;
  /// The texels that a caster may touch; all of them when that cannot be said.
  cv::Rect Footprint(const Map& map, const Caster& caster) const;
  /// Where the map no longer holds for these casters: rectangles that do not overlap.
  std::vector<cv::Rect> Stale(const Map& map, const std::vector<Caster>& casters) const;
  void Redraw(const Map& map, const cv::Rect& area, const mjvScene& scene) const;

  const GlFunctions& gl_;
  const GeomShapes& shapes_;
  int size_;
  float clip_;
  float spot_scale_;
  std::vector<Map> maps_;
};

}  // namespace horopter::sim
