// SPDX-License-Identifier: Apache-2.0
// Holds scenes/nao/nao.xml to NAO's published tables and to the code's own numbers.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "sim/nao/head_limits.h"
#include "sim/nao/joint_servos.h"
#include "sim/nao/nao_cameras.h"
#include "sim/world/world.h"

namespace horopter::sim {
namespace {

class NaoModel : public testing::Test {
 protected:
  double Mass(const std::string& body) const {
    return world_.model().body_mass[world_.Id(mjOBJ_BODY, body)];
  }

  World world_{std::string(HOROPTER_SOURCE_DIR) + "/scenes/nao/workspace.xml"};
};

TEST_F(NaoModel, JointTableIsTheRobots) {
  const NaoJointServos servos(world_);
  // Name, least, greatest [rad], speed [rad/s]; right rolls mirror left ones.
  const struct {
    const char* name;
    double min, max, speed;
  } table[] = {{"HeadYaw", -2.08567, 2.08567, 8.268},
               {"HeadPitch", -0.671952, 0.514872, 7.194},
               {"LShoulderPitch", -2.0857, 2.0857, 8.268},
               {"LShoulderRoll", -0.314, 1.326, 7.19},
               {"LElbowYaw", -2.0857, 2.0857, 8.268},
               {"LElbowRoll", -1.545, -0.035, 7.19},
               {"LWristYaw", -1.824, 1.824, 24.62},
               {"LHand", 0, 1, 8.33},
               {"LHipYawPitch", -1.145, 0.741, 4.162},
               {"LHipRoll", -0.379, 0.790, 4.16},
               {"LHipPitch", -1.536, 0.484, 6.402},
               {"LKneePitch", -0.0923, 2.1126, 6.402},
               {"LAnklePitch", -1.189, 0.923, 6.402},
               {"LAnkleRoll", -0.398, 0.769, 4.16},
               {"RHipRoll", -0.790, 0.379, 4.16},
               {"RHipPitch", -1.536, 0.484, 6.402},
               {"RKneePitch", -0.0923, 2.1126, 6.402},
               {"RAnklePitch", -1.189, 0.923, 6.402},
               {"RAnkleRoll", -0.769, 0.398, 4.16},
               {"RShoulderPitch", -2.0857, 2.0857, 8.268},
               {"RShoulderRoll", -1.326, 0.314, 7.19},
               {"RElbowYaw", -2.0857, 2.0857, 8.268},
               {"RElbowRoll", 0.035, 1.545, 7.19},
               {"RWristYaw", -1.824, 1.824, 24.62},
               {"RHand", 0, 1, 8.33}};
  ASSERT_EQ(servos.joints().size(), std::size(table));
  ASSERT_EQ(std::size(table), 25U) << "the H25 has 25 degrees of freedom";
  for (std::size_t i = 0; i < std::size(table); ++i) {
    const hardware::HumanoidJoint& joint = servos.joints()[i];
    EXPECT_EQ(joint.name, table[i].name);
    EXPECT_NEAR(joint.min_rad, table[i].min, 1e-9) << joint.name;
    EXPECT_NEAR(joint.max_rad, table[i].max, 1e-9) << joint.name;
    EXPECT_NEAR(joint.max_speed_rad_s, table[i].speed, 1e-9) << joint.name;
  }
}

TEST_F(NaoModel, HeadLimitsAreTheJoints) {
  const NaoJointServos servos(world_);
  const hardware::HeadLimits limits = NaoHeadLimits();
  for (int i = 0; i < 2; ++i) {
    EXPECT_EQ(limits[i].min_rad, servos.joints()[i].min_rad);
    EXPECT_EQ(limits[i].max_rad, servos.joints()[i].max_rad);
    EXPECT_EQ(limits[i].max_speed_rad_s, servos.joints()[i].max_speed_rad_s);
  }
}

TEST_F(NaoModel, LinksHaveTheirMasses) {
  EXPECT_NEAR(Mass("torso"), 1.0496, 1e-9);
  EXPECT_NEAR(Mass("head"), 0.6053, 1e-9);
  EXPECT_NEAR(Mass("neck"), 0.0784, 1e-9);
  for (const std::string side : {"l_", "r_"}) {
    EXPECT_NEAR(Mass(side + "thigh"), 0.3897, 1e-9);
    EXPECT_NEAR(Mass(side + "tibia"), 0.3014, 1e-9);
    EXPECT_NEAR(Mass(side + "hip"), 0.1405, 1e-9);
    EXPECT_NEAR(Mass(side + "pelvis"), 0.0698, 1e-9);
    EXPECT_NEAR(Mass(side + "ankle"), 0.1342, 1e-9);
    EXPECT_NEAR(Mass(side + "foot"), 0.1718, 1e-9);
    EXPECT_NEAR(Mass(side + "shoulder"), 0.0930, 1e-9);
    EXPECT_NEAR(Mass(side + "biceps"), 0.1578, 1e-9);
    EXPECT_NEAR(Mass(side + "elbow"), 0.0648, 1e-9);
    EXPECT_NEAR(Mass(side + "forearm"), 0.0776, 1e-9);
    EXPECT_NEAR(Mass(side + "hand") + Mass(side + "fingers"), 0.1853, 1e-9);
  }
  const double robot = world_.model().body_subtreemass[world_.Id(mjOBJ_BODY, "base")];
  EXPECT_NEAR(robot - Mass("camera_plate"), 5.305, 5e-4);
}

TEST_F(NaoModel, JointsAreWhereTheKinematicsHasThem) {
  mju_copy(world_.mutable_data().qpos + 7, std::vector<mjtNum>(26).data(), 26);
  world_.Forward();
  const hardware::Pose X_TW = world_.X_WBody("torso").inverse();
  const auto expect_at = [&](const std::string& body, double x, double y, double z) {
    const Eigen::Vector3d p = (X_TW * world_.X_WBody(body)).translation();
    EXPECT_LT((p - Eigen::Vector3d(x, y, z)).norm(), 1e-9) << body << " at " << p.transpose();
  };
  expect_at("neck", 0, 0, 0.1265);
  expect_at("head", 0, 0, 0.1265);
  for (const double side : {1.0, -1.0}) {
    const std::string s = side > 0 ? "l_" : "r_";
    expect_at(s + "pelvis", 0, side * 0.05, -0.085);
    expect_at(s + "thigh", 0, side * 0.05, -0.085);
    expect_at(s + "tibia", 0, side * 0.05, -0.185);
    expect_at(s + "ankle", 0, side * 0.05, -0.2879);
    expect_at(s + "foot", 0, side * 0.05, -0.2879);
    expect_at(s + "shoulder", 0, side * 0.098, 0.1);
    expect_at(s + "elbow", 0.105, side * 0.113, 0.1);
    expect_at(s + "hand", 0.105 + 0.05595, side * 0.113, 0.1);
  }
}

TEST_F(NaoModel, SolesAreAFootHeightBelowTheAnkles) {
  const int foot = world_.Id(mjOBJ_GEOM, "l_foot");
  const double sole =
      world_.data().geom_xpos[3 * foot + 2] - world_.model().geom_size[3 * foot + 2];
  EXPECT_NEAR(world_.X_WBody("l_foot").translation().z() - sole, 0.04519, 1e-9);
  EXPECT_NEAR(sole, 0, 1e-5);
}

TEST_F(NaoModel, EyesAreSixtyMillimetresApartWhereTheHeadGeometryPutsThem) {
  const hardware::HeadGeometry geometry = NaoHeadGeometry();
  EXPECT_EQ(geometry.baseline_m, 0.06);
  for (const double yaw : {0.0, 0.8, -1.9}) {
    for (const double pitch : {0.0, 0.2, -0.4}) {
      mjtNum* q = world_.mutable_data().qpos;
      q[world_.model().jnt_qposadr[world_.Id(mjOBJ_JOINT, "neck_pan")]] = yaw;
      q[world_.model().jnt_qposadr[world_.Id(mjOBJ_JOINT, "neck_tilt")]] = pitch;
      world_.Forward();
      hardware::Pose X_BH = geometry.X_BN;
      X_BH.rotate(Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()));
      X_BH.rotate(Eigen::AngleAxisd(pitch, Eigen::Vector3d::UnitY()));
      X_BH.translate(
          Eigen::Vector3d(geometry.axis_to_optical_centre_m, 0, geometry.tilt_to_eyes_m));
      const hardware::Pose X_WB = world_.X_WBody("base");
      for (const double side : {0.5, -0.5}) {
        hardware::Pose X_WC = X_WB * X_BH;
        X_WC.translate(Eigen::Vector3d(0, side * geometry.baseline_m, 0));
        X_WC.rotate(hardware::OpticalToBody());
        EXPECT_TRUE(world_.X_WCamera(side > 0 ? "left_eye" : "right_eye").isApprox(X_WC, 1e-9));
      }
    }
  }
  const double baseline =
      (world_.X_WCamera("left_eye").translation() - world_.X_WCamera("right_eye").translation())
          .norm();
  EXPECT_NEAR(baseline, 0.060, 1e-9);
}

TEST_F(NaoModel, CameraConfigurationsAreThePapers) {
  EXPECT_EQ(NaoCamera(NaoLens::kWide).intrinsics().fx, 561);
  EXPECT_EQ(NaoCamera(NaoLens::kNarrow).intrinsics().fy, 1250);
  EXPECT_EQ(NaoCamera(NaoLens::kNarrow).intrinsics().cx, 319.5);
  EXPECT_NEAR(NaoCamera(NaoLens::kNarrow, 320, 240).horizontal_fov_rad(),
              NaoCamera(NaoLens::kNarrow).horizontal_fov_rad(), 1e-12);
  const int eye = world_.Id(mjOBJ_CAMERA, "left_eye");
  EXPECT_NEAR(world_.model().cam_fovy[eye] * M_PI / 180,
              NaoCamera(NaoLens::kWide).vertical_fov_rad(), 1e-5);
}

/// The plate must not hide the view: nothing of the robot is within the wide camera's field.
TEST_F(NaoModel, TheCamerasLookPastTheirOwnRobot) {
  const hardware::CameraModel camera = NaoCamera(NaoLens::kWide);
  constexpr mjtByte kVisible[mjNGROUP] = {1, 1, 1, 0, 0, 0};
  for (const char* eye : {"left_eye", "right_eye"}) {
    const hardware::Pose X_WC = world_.X_WCamera(eye);
    for (int row = 0; row < 480; row += 20) {
      for (int column = 0; column < 640; column += 20) {
        const Eigen::Vector3d ray = X_WC.linear() * *camera.Unproject({column, row});
        int geom = -1;
        mj_ray(&world_.model(), &world_.data(), X_WC.translation().data(), ray.data(), kVisible, 1,
               -1, &geom);
        ASSERT_GE(geom, 0);
        EXPECT_NE(world_.model().geom_group[geom], 1) << world_.Name(mjOBJ_GEOM, geom);
      }
    }
  }
}

}  // namespace
}  // namespace horopter::sim
