// SPDX-License-Identifier: Apache-2.0
#include "sim/nao/nao_plant.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "sim/head/virtual_head.h"
#include "sim/nao/head_limits.h"
#include "sim/nao/leg_ik.h"

namespace horopter::sim {
namespace {

using hardware::Pose2;

NaoPlantConfig WithoutSlip() {
  NaoPlantConfig config;
  config.gait.slip_gain = config.gait.slip_step = config.gait.slip_turn_rad = 0;
  return config;
}

VirtualHeadConfig Head() {
  VirtualHeadConfig config;
  config.limits = NaoHeadLimits();
  return config;
}

/// A NAO that stands on open ground.
class NaoPlantTest : public testing::Test {
 protected:
  NaoPlantTest() { Pass(0.3); }

  void Step() {
    head_.Update();
    plant_.Update();
    world_.Step();
  }
  void Pass(double seconds) {
    const int steps = static_cast<int>(std::lround(seconds / hardware::ToSeconds(world_.step())));
    for (int i = 0; i < steps; ++i) Step();
  }
  /// Until it stands, and a moment longer.
  void Walk(double most_s = 60) {
    for (double t = 0; plant_.walking() && t < most_s; t += 0.002) Step();
    ASSERT_FALSE(plant_.walking());
    Pass(0.5);
  }
  void Push(double x_N, double y_N, double seconds) {
    mjtNum* force = world_.mutable_data().xfrc_applied + 6 * world_.Id(mjOBJ_BODY, "torso");
    force[0] = x_N;
    force[1] = y_N;
    Pass(seconds);
    force[0] = force[1] = 0;
  }
  double Tilt() const { return std::acos(std::min(1.0, world_.X_WBody("base").linear()(2, 2))); }

  World world_{std::string(HOROPTER_SOURCE_DIR) + "/scenes/nao/outdoor.xml"};
  VirtualHead head_{world_, Head()};
  NaoPlant plant_{world_, WithoutSlip()};
};

TEST_F(NaoPlantTest, StandsStillUnderPhysics) {
  const Pose2 before = plant_.TruePose();
  Pass(5);
  EXPECT_TRUE(plant_.upright());
  EXPECT_LT(Tilt(), 0.005);
  EXPECT_NEAR(world_.X_WBody("base").translation().z(), 0, 2e-3);
  EXPECT_NEAR(plant_.TruePose().x_m, before.x_m, 1e-3);
  EXPECT_NEAR(plant_.TruePose().y_m, before.y_m, 1e-3);
  for (const Contact& contact : world_.Contacts()) {
    EXPECT_TRUE(contact.body1.ends_with("_foot") || contact.body2.ends_with("_foot"));
  }
}

TEST_F(NaoPlantTest, StandsWithTheWeldReleasedSoThatALightPushMovesItAndItRecovers) {
  for (const auto& [x_N, y_N] : {std::pair{8.0, 0.0}, {-8.0, 0.0}, {0.0, 8.0}, {0.0, -8.0}}) {
    Push(x_N, y_N, 0.1);
    const double pushed = Tilt();
    EXPECT_GT(pushed, 1e-4) << "held by something other than its legs";
    Pass(2);
    EXPECT_TRUE(plant_.upright());
    EXPECT_LT(Tilt(), 0.005) << x_N << " " << y_N;
  }
}

TEST_F(NaoPlantTest, FallsWhenPushedHardAndSaysSo) {
  Push(60, 0, 0.4);
  Pass(2);
  EXPECT_FALSE(plant_.upright());
}

TEST_F(NaoPlantTest, WalksToItsTargetInTruthToo) {
  for (const Pose2& target :
       {Pose2{0.25, 0, 0}, Pose2{0, 0, M_PI / 2}, Pose2{0, 0.1, 0}, Pose2{-0.1, 0.05, -0.6}}) {
    const hardware::Pose X_WB = hardware::ToPose(plant_.TruePose());
    plant_.MoveTo(target);
    Walk();
    const Pose2 moved = hardware::ToPose2(X_WB.inverse() * hardware::ToPose(plant_.TruePose()));
    EXPECT_NEAR(moved.x_m, target.x_m, 0.005);
    EXPECT_NEAR(moved.y_m, target.y_m, 0.005);
    EXPECT_NEAR(hardware::WrapAngle(moved.heading_rad - target.heading_rad), 0, 0.02);
    EXPECT_LT(Tilt(), 0.01);
  }
}

TEST_F(NaoPlantTest, WalksNoFasterThanItsTopSpeed) {
  plant_.Move({1, 0, 0});
  Pass(2 * 0.42);
  const double before = plant_.TruePose().x_m;
  Pass(4 * 0.42);
  EXPECT_NEAR((plant_.TruePose().x_m - before) / (4 * 0.42), 0.0952, 0.001);
}

TEST_F(NaoPlantTest, StopsWithinItsStopTimeAndStandsOn) {
  plant_.Move({0.09, 0, 0.2});
  Pass(2.1);
  plant_.Stop();
  Pass(hardware::ToSeconds(plant_.max_stop_time()));
  EXPECT_FALSE(plant_.walking());
  const Pose2 stopped = plant_.TruePose();
  Pass(3);
  EXPECT_NEAR(plant_.TruePose().x_m, stopped.x_m, 2e-3);
  EXPECT_NEAR(plant_.TruePose().y_m, stopped.y_m, 2e-3);
  EXPECT_LT(Tilt(), 0.005);
}

TEST_F(NaoPlantTest, CarryingFeetStayWhereTheyStand) {
  plant_.MoveTo({0.4, 0, 0.3});
  Pass(3 * 0.42);
  for (int step = 0; step < 4; ++step) {
    Pass(0.05);
    const std::string foot = plant_.gait().stance() == hardware::Eye::kLeft ? "l_foot" : "r_foot";
    const Eigen::Vector3d before = world_.X_WBody(foot).translation();
    Pass(0.30);
    EXPECT_LT((world_.X_WBody(foot).translation() - before).norm(), 0.003) << foot;
    Pass(0.07);
  }
}

TEST_F(NaoPlantTest, HeadSwaysWithTheStepsBesideItsPathAndUpAndDown) {
  plant_.Move({0.08, 0, 0});
  Pass(4 * 0.42);
  std::vector<double> y, z;
  for (int i = 0; i < 10 * 210; ++i) {
    Step();
    y.push_back(world_.X_WCamera("left_eye").translation().y() - 0.03);
    z.push_back(world_.X_WCamera("left_eye").translation().z());
  }
  const auto [left, right] = std::minmax_element(y.begin(), y.end());
  // The hips' sway, and the roll over the height of the eyes.
  const double amplitude = 0.018 + 0.0175 * world_.X_WCamera("left_eye").translation().z();
  EXPECT_NEAR((*right - *left) / 2, amplitude, 0.1 * amplitude);
  int crossings = 0;
  const double middle = (*right + *left) / 2;
  for (std::size_t i = 1; i < y.size(); ++i) crossings += (y[i] > middle) != (y[i - 1] > middle);
  EXPECT_NEAR(crossings, 10, 1) << "one crossing a step";
  const auto [low, high] = std::minmax_element(z.begin(), z.end());
  EXPECT_GT(*high - *low, 0.003);
  EXPECT_LT(*high - *low, 0.008);
}

TEST_F(NaoPlantTest, SlipMovesTheTruthAwayFromTheOdometry) {
  World world(std::string(HOROPTER_SOURCE_DIR) + "/scenes/nao/outdoor.xml");
  NaoPlantConfig config;
  config.seed = 5;
  NaoPlant plant(world, config);
  plant.MoveTo({0.4, 0, 0});
  while (plant.walking()) {
    plant.Update();
    world.Step();
  }
  EXPECT_NEAR(plant.Odometry().x_m, 0.4, 1e-3);
  const double error = std::hypot(plant.TruePose().x_m - 0.4, plant.TruePose().y_m);
  EXPECT_GT(error, 1e-4);
  EXPECT_LT(error, 0.05);
}

TEST_F(NaoPlantTest, PitchStaysWithinItsRangeAtEveryYawOnTheWay) {
  const int pan = world_.model().jnt_qposadr[world_.Id(mjOBJ_JOINT, "neck_pan")];
  const int tilt = world_.model().jnt_qposadr[world_.Id(mjOBJ_JOINT, "neck_tilt")];
  for (const hardware::PanTilt& target :
       {hardware::PanTilt{0, -0.67}, hardware::PanTilt{1.6, -0.67}, hardware::PanTilt{-1.5, 0.5},
        hardware::PanTilt{0, 0.5}, hardware::PanTilt{2.0, 0.5}}) {
    head_.Command({target, {}, {}});
    for (int i = 0; i < 600; ++i) {
      Step();
      const PitchRange range = NaoPitchRange(world_.data().qpos[pan]);
      ASSERT_LT(world_.data().qpos[tilt], range.max_rad + 0.01);
      ASSERT_GT(world_.data().qpos[tilt], range.min_rad - 0.01);
    }
    const hardware::PanTilt reached = NaoReachable({target, {}, {}}).neck;
    EXPECT_NEAR(world_.data().qpos[pan], reached.pan_rad, 0.002);
    EXPECT_NEAR(world_.data().qpos[tilt], reached.tilt_rad, 0.002);
  }
  EXPECT_TRUE(plant_.upright()) << "the head's motions must not throw it over";
}

TEST_F(NaoPlantTest, JointPositionsComeInTheOrderOfTheTable) {
  const std::vector<double> positions = plant_.JointPositions();
  ASSERT_EQ(positions.size(), NaoJointNames().size());
  head_.Command({{0.3, 0.1}, {}, {}});
  Pass(1);
  EXPECT_NEAR(plant_.JointPositions()[0], 0.3, 0.002);
  EXPECT_NEAR(plant_.JointPositions()[1], 0.1, 0.002);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    EXPECT_GE(positions[i], plant_.joints()[i].min_rad - 1e-3) << plant_.joints()[i].name;
    EXPECT_LE(positions[i], plant_.joints()[i].max_rad + 1e-3) << plant_.joints()[i].name;
  }
}

TEST_F(NaoPlantTest, JointsKeepTheirSpeedLimitsWhileWalking) {
  plant_.Move({0.09, 0, 0});
  std::vector<double> last = plant_.JointPositions();
  for (int i = 0; i < 1500; ++i) {
    Step();
    const std::vector<double> now = plant_.JointPositions();
    for (std::size_t j = 2; j < now.size(); ++j) {
      EXPECT_LT(std::abs(now[j] - last[j]) / 0.002, 1.15 * plant_.joints()[j].max_speed_rad_s)
          << plant_.joints()[j].name;
    }
    last = now;
  }
}

TEST_F(NaoPlantTest, WalkingIntoSomethingItStepsBackStandsAndCanGoElsewhere) {
  hardware::Pose X_WBox = hardware::Pose::Identity();
  X_WBox.translation().x() = 0.6;
  world_.PlaceBody("box", X_WBox);
  plant_.MoveTo({0.6, 0, 0});
  double deepest = 0;
  for (int i = 0; i < 10000 && plant_.walking(); ++i) {
    Step();
    for (const Contact& c : world_.Contacts()) deepest = std::min(deepest, c.distance_m);
  }
  ASSERT_FALSE(plant_.walking());
  Pass(1);
  EXPECT_TRUE(plant_.upright());
  EXPECT_LT(Tilt(), 0.02);
  EXPECT_GT(deepest, -0.012);
  EXPECT_LT(plant_.TruePose().x_m, 0.45 - 0.1) << "its toes stop at the box's near side";
  EXPECT_LT(plant_.Odometry().x_m, 0.5) << "it knows that it did not arrive";
  const Pose2 before = plant_.TruePose();
  plant_.MoveTo({-0.1, 0, 0});
  Walk();
  EXPECT_NEAR(before.x_m - plant_.TruePose().x_m, 0.1, 0.01);
}

TEST(NaoPlant, RefusesScenesWithoutANao) {
  World koala(std::string(HOROPTER_SOURCE_DIR) + "/scenes/koala/room.xml");
  EXPECT_THROW(NaoPlant{koala}, SceneError);
}

}  // namespace
}  // namespace horopter::sim
