// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "hardware/types/pose.h"
#include "sim/tabletop/thing.h"

namespace horopter::sim {

/// What a point of view sees of one thing, as rays on a regular grid, and which of them others
/// hide.
class Silhouette {
 public:
  /// @param grid rays across the thing's bounding sphere
  Silhouette(const Thing& thing, const hardware::Pose& X_WB, const Eigen::Vector3d& viewpoint_W,
             int grid);

  /// Marks what another thing hides. Hidden stays hidden.
  void Hide(const Thing& other, const hardware::Pose& X_WO);

  /// Share of the silhouette that is hidden, or would be if another thing stood there as well.
  double hidden() const;
  double HiddenWith(const Thing& other, const hardware::Pose& X_WO) const;

 private:
  struct Ray {
    Eigen::Vector3d direction_W;
    double distance_m;  ///< to the thing
    bool hidden;
  };
  bool MayHide(const Thing& other, const hardware::Pose& X_WO) const;
  bool Hides(const Ray& ray, const Thing& other, const hardware::Pose& X_WO) const;

  Eigen::Vector3d viewpoint_W_;
  Eigen::Vector3d centre_W_;
  double radius_m_;
  std::vector<Ray> rays_;
};

}  // namespace horopter::sim
