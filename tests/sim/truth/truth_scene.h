// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <memory>
#include <string_view>

#include "hardware/types/camera_model.h"
#include "hardware/types/pose.h"
#include "sim/truth/ground_truth.h"
#include "sim/truth/scene_snapshot.h"
#include "sim/world/world.h"

namespace horopter::sim {

constexpr double kDegree = M_PI / 180;

/// A world and the shapes in it.
class TruthScene {
 public:
  explicit TruthScene(std::string_view mjcf)
      : world_(World::FromXml(mjcf)), shapes_(std::make_shared<SceneShapes>(world_->model())) {}

  World& world() { return *world_; }
  const std::shared_ptr<const SceneShapes>& shapes() const { return shapes_; }
  SceneSnapshot Now() const { return SceneSnapshot(shapes_, world_->data()); }
  int Geom(std::string_view name) const { return world_->Id(mjOBJ_GEOM, name); }

 private:
  std::unique_ptr<World> world_;
  std::shared_ptr<const SceneShapes> shapes_;
};

/// An eye of a head that looks along x: pan left, tilt down, then roll about the optical axis.
inline hardware::Pose EyePose(const Eigen::Vector3d& p_WC, double pan, double tilt, double roll) {
  hardware::Pose X = hardware::Pose::Identity();
  X.translation() = p_WC;
  X.linear() = (Eigen::AngleAxisd(pan, Eigen::Vector3d::UnitZ()) *
                Eigen::AngleAxisd(tilt, Eigen::Vector3d::UnitY()) *
                Eigen::AngleAxisd(roll, Eigen::Vector3d::UnitX()))
                   .toRotationMatrix() *
               hardware::OpticalToBody();
  return X;
}

/// Verged by 9 degrees, tilted and rolled against each other, not at one height.
inline EyeView VergedLeft(const hardware::CameraModel& camera) {
  return {EyePose({0, 0.06, 1}, -4 * kDegree, 3 * kDegree, 2 * kDegree), camera};
}
inline EyeView VergedRight(const hardware::CameraModel& camera) {
  return {EyePose({0.01, -0.06, 1.005}, 5 * kDegree, 1 * kDegree, -3 * kDegree), camera};
}

/// A webcam as one buys it: a bent lens, its axis off the middle, pixels not quite square.
inline hardware::CameraModel DistortedCamera() {
  return hardware::CameraModel({160, 120, 170, 165, 81, 58},
                               {.k1 = -0.2, .k2 = 0.05, .p1 = 1e-3, .p2 = -2e-3, .k3 = 0.01});
}

/// The ray of a pixel in the world, its direction's length being one unit of depth.
inline Ray PixelRay(const EyeView& view, double x, double y) {
  return Ray(view.X_WC.translation(),
             view.X_WC.linear() * *view.camera.Unproject(Eigen::Vector2d(x, y)));
}

struct AnalyticHit {
  double depth = -1;  ///< negative: nothing
  int geom = -1;
};

/// Where a pixel's ray meets MuJoCo's analytic shapes; groups as cameras see them.
inline AnalyticHit CastAnalytic(const World& world, const Ray& ray) {
  constexpr mjtByte kGroups[mjNGROUP] = {1, 1, 1, 0, 0, 0};
  AnalyticHit hit;
  hit.depth = mj_ray(&world.model(), &world.data(), ray.origin.data(), ray.direction.data(),
                     kGroups, 1, -1, &hit.geom);
  return hit;
}

/// Flat things at many slants and distances, before and behind each other, in a room.
inline constexpr const char* kBoxes = R"(
<mujoco>
  <worldbody>
    <geom name="wall" type="box" pos="3 0 1" size=".05 4 4"/>
    <geom name="floor" type="plane" pos="0 0 0" size="5 5 .1"/>
    <geom name="near" type="box" pos="1.2 .1 1" size=".1 .15 .2" euler="0 0 25"/>
    <geom name="slanted" type="box" pos="1.7 -.4 .9" size=".05 .3 .2" euler="20 -30 40"/>
    <geom name="poster" type="box" pos="2.94 .7 1.3" size=".011 .3 .2"/>
    <geom name="pole" type="box" pos="2 .5 1" size=".02 .02 1"/>
  </worldbody>
</mujoco>)";

/// One of each round shape before a wall.
inline constexpr const char* kRound = R"(
<mujoco>
  <visual><quality numslices="48" numstacks="16"/></visual>
  <worldbody>
    <geom name="wall" type="box" pos="3 0 1" size=".05 4 4"/>
    <geom name="ball" type="sphere" pos="1.2 .35 1.2" size=".12"/>
    <geom name="can" type="cylinder" pos="1.1 0 .9" size=".1 .15" euler="20 10 0"/>
    <geom name="egg" type="ellipsoid" pos="1.3 -.35 1.1" size=".1 .15 .2" euler="0 30 50"/>
    <geom name="pill" type="capsule" pos="1.5 0 1.4" size=".08 .2" euler="70 0 20"/>
  </worldbody>
</mujoco>)";

}  // namespace horopter::sim
