// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

#include "hardware/types/pose.h"
#include "sim/world/world.h"

namespace horopter::sim {

/// Something that can stand on a table: a body without joints, in a frame of its own.
class Thing {
 public:
  /// @throws SceneError when there is no such body or it has no shape
  Thing(const World& world, const std::string& body);

  const std::string& name() const { return name_; }

  /// Bounding box in the body's frame: exact for boxes and meshes, for other shapes that of the box
  /// around them.
  const Eigen::AlignedBox3d& box() const { return box_; }
  /// Centre of its bounding box at a pose, and radius of the sphere about there that holds it.
  Eigen::Vector3d Centre(const hardware::Pose& X_WB) const { return X_WB * box_.center(); }
  double radius_m() const { return box_.diagonal().norm() / 2; }

  /// How far along a ray from p_W (direction d_W, unit length) the thing is hit when it stands at
  /// X_WB; nothing when it is missed.
  std::optional<double> Ray(const hardware::Pose& X_WB, const Eigen::Vector3d& p_W,
                            const Eigen::Vector3d& d_W) const;

 private:
  const World* world_;
  std::string name_;
  int body_;
  std::vector<int> geoms_;
  Eigen::AlignedBox3d box_;
};

/// The rectangle that a thing stands on, and its shadow from straight above.
struct GroundPlan {
  Eigen::Vector2d centre_m;
  Eigen::Vector2d half_m;
  double yaw_rad;

  std::vector<Eigen::Vector2d> Corners() const;
};

GroundPlan PlanOf(const Thing& thing, const hardware::Pose& X_WB);

/// Whether a gap of at least this lies between two rectangles along one of their edges' directions
/// (separating axes; sufficient, and necessary but for corner against corner).
bool Apart(const GroundPlan& a, const GroundPlan& b, double gap_m);

}  // namespace horopter::sim
