// SPDX-License-Identifier: Apache-2.0
#include "fixed_views.h"

#include <Eigen/Geometry>
#include <cmath>

namespace horopter::sim::testing {

using hardware::CameraModel;
using hardware::Pose;

const char* const kShowroomXml = R"(
<mujoco>
  <visual>
    <headlight active="0"/>
    <map shadowclip="1"/>
    <quality shadowsize="1024"/>
  </visual>
  <statistic extent="4" center="2 0 0"/>
  <asset>
    <texture name="sky" type="skybox" builtin="gradient" rgb1=".3 .5 .8" rgb2=".9 .9 .8" width="64"
             height="384"/>
    <texture name="tiles" type="2d" builtin="checker" rgb1=".7 .6 .5" rgb2=".3 .35 .4" width="128"
             height="128"/>
    <texture name="card" type="cube" builtin="checker" rgb1=".8 .7 .4" rgb2=".5 .3 .2" width="64"
             height="384" mark="edge" markrgb="1 1 1"/>
    <material name="tiles" texture="tiles" texrepeat="2 2" texuniform="true" specular=".2"/>
    <material name="paper" texture="tiles" texrepeat="3 2"/>
    <material name="card" texture="card" texuniform="true"/>
    <material name="shiny" rgba=".8 .2 .2 1" specular=".9" shininess=".7"/>
    <material name="glow" rgba=".1 .5 .2 1" emission=".6"/>
    <material name="glass" rgba=".3 .5 .9 .35"/>
  </asset>
  <worldbody>
    <light pos="1 1 3" dir=".2 -.2 -1" castshadow="true" cutoff="60" exponent="3"
           diffuse=".6 .6 .55" ambient=".1 .1 .1"/>
    <light pos="2 -2 3" dir="-.1 .5 -1" directional="true" castshadow="true" diffuse=".3 .3 .4"/>
    <light pos="0 0 2" dir="1 .2 -.4" directional="true" castshadow="false" diffuse=".3 .3 .3"
           ambient=".2 .2 .2" specular=".2 .2 .2"/>
    <geom name="floor" type="plane" size="0 0 .5" material="tiles"/>
    <geom name="wall" type="plane" size="1.5 .8 .4" pos="3.5 0 .8" xyaxes="0 -1 0 0 0 1"
          material="paper"/>
    <geom name="crate" type="box" pos="2 .5 .2" size=".2 .25 .2" euler="0 0 25" material="card"/>
    <geom name="ball" type="sphere" pos="1.7 -.3 .2" size=".2" material="shiny"/>
    <geom name="pill" type="capsule" fromto="2.4 -.7 .15 2.4 -.2 .5" size=".12" material="glow"/>
    <geom name="tin" type="cylinder" pos="2.5 .1 .25" size=".1 .25" material="paper"/>
    <geom name="egg" type="ellipsoid" pos="1.3 .3 .12" size=".08 .1 .12" rgba=".9 .9 .7 1"/>
    <geom name="pane" type="box" pos="1.5 .1 .4" size=".01 .4 .3" euler="0 0 15" material="glass"/>
    <body name="rover" pos="1.2 -.6 .1">
      <joint type="slide" axis="0 1 0"/>
      <geom name="rover" type="box" size=".1 .08 .06" material="card"/>
    </body>
  </worldbody>
</mujoco>)";

namespace {

Pose At(double x, double y, double z, double yaw, double pitch_down, double roll) {
  Pose X_WC = Pose::Identity();
  X_WC.translation() << x, y, z;
  X_WC.linear() = (Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()) *
                   Eigen::AngleAxisd(pitch_down, Eigen::Vector3d::UnitY()) *
                   Eigen::AngleAxisd(roll, Eigen::Vector3d::UnitX()))
                      .toRotationMatrix() *
                  hardware::OpticalToBody();
  return X_WC;
}

}  // namespace

std::vector<PosedCamera> FixedViews() {
  const auto wide = CameraModel::FromHorizontalFov(320, 240, 60 * M_PI / 180);
  const auto narrow = CameraModel::FromHorizontalFov(320, 240, 14 * M_PI / 180);
  const CameraModel odd({317, 211, 300, 300, 140.25, 120.5});
  return {{At(0, 0.03, 0.8, 0, 0.25, 0), wide},      {At(0, -0.03, 0.8, 0, 0.25, 0), wide},
          {At(0, 0.1, 0.6, -0.1, 0.2, 0.1), narrow}, {At(0.2, -0.8, 1.2, 0.5, 0.5, -0.2), odd},
          {At(4.5, 0.2, 1.0, 3.0, 0.2, 0), wide},    {At(1.5, 0, 2.5, 0.3, 1.3, 0), odd}};
}

std::uint64_t Hash(const cv::Mat& image, std::uint64_t seed) {
  constexpr std::uint64_t kPrime = 1099511628211ull;
  for (int y = 0; y < image.rows; ++y) {
    const auto* row = image.ptr<std::uint8_t>(y);
    for (std::size_t i = 0; i < image.cols * image.elemSize(); ++i) {
      seed = (seed ^ row[i]) * kPrime;
    }
  }
  return seed;
}

std::uint64_t Hash(const RenderedView& view, std::uint64_t seed) {
  return Hash(view.ids, Hash(view.depth, Hash(view.bgr, seed)));
}

}  // namespace horopter::sim::testing
