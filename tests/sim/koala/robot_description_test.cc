// SPDX-License-Identifier: Apache-2.0
// Holds scenes/koala/koala.xml to scenes/koala/robot.yaml, and the plant's defaults to both.
#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <cmath>
#include <string>

#include "hardware/types/head_angles.h"
#include "hardware/types/pose.h"
#include "sim/koala/koala_plant.h"

namespace horopter::sim {
namespace {

const std::string kScenes = std::string(HOROPTER_SOURCE_DIR) + "/scenes/koala/";
constexpr double kDegree = M_PI / 180;

class RobotDescription : public testing::Test {
 protected:
  double Wheels(const char* key) const { return robot_["wheels"][key].as<double>(); }
  double Head(const char* key) const { return robot_["head"][key].as<double>(); }
  double Axis(const std::string& axis, const char* key) const {
    return robot_["head"]["axes"][axis][key].as<double>();
  }

  int Joint(const std::string& name) const { return world_.Id(mjOBJ_JOINT, name); }

  YAML::Node robot_ = YAML::LoadFile(kScenes + "robot.yaml");
  World world_{kScenes + "room.xml"};
};

/// Pose of an optical frame in the base: neck, half a baseline aside, pan, tilt.
hardware::Pose ForwardKinematics(const Eigen::Vector3d& p_BN, double side_m,
                                 const hardware::PanTilt& angles) {
  hardware::Pose X = hardware::Pose::Identity();
  X.translation() = p_BN + Eigen::Vector3d(0, side_m, 0);
  X.linear() = (Eigen::AngleAxisd(angles.pan_rad, Eigen::Vector3d::UnitZ()) *
                Eigen::AngleAxisd(angles.tilt_rad, Eigen::Vector3d::UnitY()))
                   .toRotationMatrix() *
               hardware::OpticalToBody();
  return X;
}

TEST_F(RobotDescription, CamerasAreWhereForwardKinematicsPutsThem) {
  const YAML::Node neck = robot_["head"]["neck_m"];
  const Eigen::Vector3d p_BN(neck[0].as<double>(), neck[1].as<double>(), neck[2].as<double>());
  const double half = Head("baseline_m") / 2;
  const hardware::PanTilt poses[] = {{0, 0}, {0.5, 0.3}, {-0.7, 0.1}, {1.9, -0.4}, {-2.5, 0.7}};
  for (const hardware::PanTilt& left : poses) {
    for (const hardware::PanTilt& right : poses) {
      mjtNum* q = world_.mutable_data().qpos;
      q[world_.model().jnt_qposadr[Joint("left_pan")]] = left.pan_rad;
      q[world_.model().jnt_qposadr[Joint("left_tilt")]] = left.tilt_rad;
      q[world_.model().jnt_qposadr[Joint("right_pan")]] = right.pan_rad;
      q[world_.model().jnt_qposadr[Joint("right_tilt")]] = right.tilt_rad;
      world_.Forward();
      const hardware::Pose X_WB = world_.X_WBody("base");
      EXPECT_TRUE(
          world_.X_WCamera("left").isApprox(X_WB * ForwardKinematics(p_BN, half, left), 1e-9));
      EXPECT_TRUE(
          world_.X_WCamera("right").isApprox(X_WB * ForwardKinematics(p_BN, -half, right), 1e-9));
    }
  }
}

TEST_F(RobotDescription, JointRangesAreTheHeadsLimits) {
  for (const std::string axis : {"left_pan", "right_pan", "left_tilt", "right_tilt"}) {
    const mjtNum* range = world_.model().jnt_range + 2 * Joint(axis);
    EXPECT_NEAR(range[0], Axis(axis, "min_deg") * kDegree, 1e-9);
    EXPECT_NEAR(range[1], Axis(axis, "max_deg") * kDegree, 1e-9);
  }
}

TEST_F(RobotDescription, CameraFieldOfViewIsHorizontal) {
  const YAML::Node eyes = robot_["cameras"]["eyes"];
  const double aspect = eyes["width_px"].as<double>() / eyes["height_px"].as<double>();
  for (const char* side : {"left", "right"}) {
    const auto name = eyes[side].as<std::string>();
    const double fovy = world_.model().cam_fovy[world_.Id(mjOBJ_CAMERA, name)] * kDegree;
    const double horizontal = 2 * std::atan(std::tan(fovy / 2) * aspect);
    EXPECT_NEAR(horizontal, eyes["horizontal_fov_deg"].as<double>() * kDegree, 1e-4);
  }
}

TEST_F(RobotDescription, WheelRadiusMakesPulsesAndTurnsAgree) {
  const double radius = Wheels("metres_per_pulse") * Wheels("pulses_per_turn") / (2 * M_PI);
  for (const char* name : {"left_middle_wheel", "right_front_wheel", "left_rear_wheel"}) {
    EXPECT_NEAR(world_.model().geom_size[3 * world_.Id(mjOBJ_GEOM, name)], radius, 1e-6);
  }
}

TEST_F(RobotDescription, PlantDefaultsAreTheRobots) {
  const KoalaPlantConfig plant;
  EXPECT_EQ(plant.metres_per_pulse, Wheels("metres_per_pulse"));
  EXPECT_EQ(plant.pulses_per_turn, Wheels("pulses_per_turn"));
  EXPECT_EQ(plant.max_wheel_speed_m_s, Wheels("max_speed_m_s"));
  EXPECT_EQ(plant.max_wheel_acceleration_m_s2, Wheels("max_acceleration_m_s2"));
  EXPECT_EQ(plant.deadman, hardware::FromSeconds(Wheels("deadman_s")));
}

TEST_F(RobotDescription, WeighsWhatAKoalaWeighs) {
  EXPECT_NEAR(world_.model().body_subtreemass[world_.Id(mjOBJ_BODY, "base")], 3.8, 0.01);
}

TEST_F(RobotDescription, RadiusAndHeightContainEverythingSolid) {
  const int base = world_.Id(mjOBJ_BODY, "base");
  for (int geom = 0; geom < world_.model().ngeom; ++geom) {
    const mjModel& m = world_.model();
    if (m.body_rootid[m.geom_bodyid[geom]] != base || m.geom_contype[geom] == 0) continue;
    const mjtNum* p = world_.data().geom_xpos + 3 * geom;
    const mjtNum* size = m.geom_size + 3 * geom;
    EXPECT_LE(std::hypot(std::abs(p[0]) + size[0], std::abs(p[1]) + size[1]),
              robot_["radius_m"].as<double>());
    EXPECT_LE(p[2] + size[2], robot_["height_m"].as<double>());
  }
}

}  // namespace
}  // namespace horopter::sim
