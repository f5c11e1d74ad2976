// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Core>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "hardware/types/pose.h"

namespace horopter::sim {

/// The nearest approach of the robot to anything else.
struct Clearance {
  double distance_m = 0;  ///< negative: depth of penetration; the search limit when nothing is near
  std::string robot_geom;  ///< empty when nothing is within the search limit
  std::string other_geom;
  Eigen::Vector3d p_WRobot = Eigen::Vector3d::Zero();  ///< nearest points, world frame [m]
  Eigen::Vector3d p_WOther = Eigen::Vector3d::Zero();
};

/// The clearance of a path, and where on it.
struct PathClearance {
  Clearance nearest;
  std::size_t pose_index = 0;  ///< into the path; 0 when nothing is within the search limit
};

struct RayHit {
  double distance_m = 0;  ///< from the ray's start
  Eigen::Vector3d p_W = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal_W = Eigen::Vector3d::Zero();  ///< outward, unit length
  int geom = -1;                                       ///< MuJoCo's id
  std::string name;
};

struct ClearanceOptions {
  std::vector<int> ignored_geoms{};  ///< besides the floor
  double max_distance_m = 10;        ///< no farther than this is searched
};

/// A second collision world, made of the same geoms as MuJoCo's and computed by Bullet alone.
///
/// Holds every geom with a non-zero contype or conaffinity: boxes, cylinders, capsules, spheres and
/// ellipsoids exactly, meshes as convex hulls, planes as half-spaces (for rays: the front face of
/// the rectangle that MuJoCo gives them). Distances of flat-faced solids are exact to 1e-9 m, of
/// round ones to 1e-6 m apart and 1e-5 m overlapping; rays agree with mj_ray to 1e-7 of their
/// length on flat faces and 5e-5 on round ones. It keeps the poses of the last Sync() and looks at
/// MuJoCo for nothing else: where the two disagree, one of them is wrong.
///
/// The floor is no obstacle (IsFloor()); a plane that stands upright is a wall, and is one.
class CollisionOracle {
 public:
  /// Copies what it needs of the model, which may be changed or go afterwards.
  /// @throws std::invalid_argument naming a geom whose type it does not know (height field).
  explicit CollisionOracle(const mjModel& model);
  ~CollisionOracle();
  CollisionOracle(CollisionOracle&&) noexcept;
  CollisionOracle& operator=(CollisionOracle&&) noexcept;

  /// Takes over the poses of all bodies and geoms. @pre `data` belongs to the model it was made of,
  /// and its kinematics are up to date (World::Forward).
  void Sync(const mjData& data);

  /// Signed distance of two geoms. Two planes have none: infinity.
  /// @throws std::out_of_range when a geom does not exist or cannot collide.
  double Distance(int geom1, int geom2) const;

  /// Smallest distance between the geoms of the subtree below `robot_body` and all other geoms
  /// that could collide with them by MuJoCo's contype and conaffinity, except the floor.
  /// @throws std::out_of_range when there is no such body.
  Clearance ClearanceOf(int robot_body, const ClearanceOptions& options = {}) const;

  /// The same with the robot's root body at each pose X_WB in turn, its joints and all else as of
  /// the last Sync(). Says nothing of what lies between two poses: sample the path finely.
  PathClearance ClearanceAlong(int robot_body, std::span<const hardware::Pose> path,
                               const ClearanceOptions& options = {}) const;

  /// The first geom on the segment, floor included. Geoms that contain `from_W` and those of the
  /// subtree below `ignored_body` (-1: none) are transparent.
  std::optional<RayHit> CastRay(const Eigen::Vector3d& from_W, const Eigen::Vector3d& to_W,
                                int ignored_body = -1) const;

 private:
  struct Scene;
  std::unique_ptr<Scene> scene_;
};

}  // namespace horopter::sim
