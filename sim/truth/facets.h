// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "sim/truth/box_tree.h"
#include "sim/truth/drawn_shape.h"

namespace horopter::sim {

struct FacetHit {
  double t = 0;                    ///< in units of the ray's direction
  Eigen::Vector3d outward_normal;  ///< of the facet, unit length
};

/// The facets of one solid, ready for rays.
class Facets {
 public:
  /// @param two_sided whether facets are seen from behind too
  Facets(const std::vector<Triangle>& triangles, bool two_sided);

  const Eigen::AlignedBox3d& bounds() const { return bounds_; }
  bool two_sided() const { return two_sided_; }

  /// The first facet met in [t_min, t_max] (Moeller and Trumbore 1997).
  std::optional<FacetHit> FirstHit(const Ray& ray, double t_min, double t_max) const;

 private:
  struct Facet {
    Eigen::Vector3d a, ab, ac;
  };

  double Meet(const Ray& ray, const Facet& facet) const;

  bool two_sided_;
  Eigen::AlignedBox3d bounds_;
  std::vector<Facet> facets_;
  BoxTree tree_;
};

}  // namespace horopter::sim
