// SPDX-License-Identifier: Apache-2.0
// Holds every shipped robot.yaml to its MuJoCo model: axes, optical centres, fields of view.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "control/kinematics/head_kinematics.h"
#include "scenarios/format/robot_description.h"
#include "sim/head/pose_head.h"
#include "sim/world/world.h"

namespace horopter::scenarios {
namespace {

using hardware::Eye;

struct Shipped {
  const char* robot;
  const char* scene;
};

class ShippedRobot : public testing::TestWithParam<Shipped> {
 protected:
  const std::string scenes_ = HOROPTER_SOURCE_DIR "/scenes/" + std::string(GetParam().robot) + "/";
  const RobotDescription robot_ = LoadRobotDescription(scenes_ + "robot.yaml");
  sim::World world_{scenes_ + GetParam().scene};
};

TEST_P(ShippedRobot, AxesAreWithinTheJointsRanges) {
  const mjModel& m = world_.model();
  for (int axis = 0; axis < hardware::kHeadAxisCount; ++axis) {
    const std::string name(hardware::kHeadAxisNames[axis]);
    const int joint = mj_name2id(&m, mjOBJ_JOINT, name.c_str());
    EXPECT_EQ(joint >= 0, robot_.head_limits[axis].exists()) << name;
    if (joint < 0) continue;
    EXPECT_GE(robot_.head_limits[axis].min_rad, m.jnt_range[2 * joint] - 1e-3) << name;
    EXPECT_LE(robot_.head_limits[axis].max_rad, m.jnt_range[2 * joint + 1] + 1e-3) << name;
  }
}

TEST_P(ShippedRobot, CamerasAreWhereTheGeometryPutsThem) {
  for (const double part : {0.0, 0.4, 0.9}) {
    hardware::HeadAxisArray angles{};
    for (int axis = 0; axis < hardware::kHeadAxisCount; ++axis) {
      const hardware::AxisLimits& limits = robot_.head_limits[axis];
      angles[axis] = limits.min_rad + part * (limits.max_rad - limits.min_rad);
    }
    const hardware::HeadAngles head = hardware::FromArray(angles);
    sim::PoseHead(world_, head);
    for (const auto& [name, pair] : robot_.cameras) {
      const auto geometry = robot_.GeometryOf(pair);
      const hardware::Pose X_WB = world_.X_WBody("base");
      for (const Eye eye : hardware::kBothEyes) {
        const std::string& camera = eye == Eye::kLeft ? pair.left : pair.right;
        const hardware::Pose expected = X_WB * control::EyePose(geometry, head, eye);
        EXPECT_TRUE(world_.X_WCamera(camera).isApprox(expected, 1e-5))
            << name << " " << camera << "\n"
            << world_.X_WCamera(camera).matrix() << "\n\n"
            << expected.matrix();
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(, ShippedRobot,
                         testing::Values(Shipped{"koala", "room.xml"},
                                         Shipped{"nao", "workspace.xml"},
                                         Shipped{"yorick", "tabletop.xml"}),
                         [](const auto& info) { return std::string(info.param.robot); });

}  // namespace
}  // namespace horopter::scenarios
