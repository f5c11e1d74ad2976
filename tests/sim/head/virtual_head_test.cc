// SPDX-License-Identifier: Apache-2.0
#include "sim/head/virtual_head.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "hardware/types/config_error.h"

namespace horopter::sim {
namespace {

constexpr double kDegree = M_PI / 180;
const std::string kRoom = std::string(HOROPTER_SOURCE_DIR) + "/scenes/koala/room.xml";

VirtualHeadConfig KoalaHead() {
  VirtualHeadConfig config;
  const hardware::AxisLimits pan{-158 * kDegree, 158 * kDegree, 120 * kDegree, 600 * kDegree};
  const hardware::AxisLimits tilt{-31 * kDegree, 46 * kDegree, 120 * kDegree, 600 * kDegree};
  config.limits = {pan, tilt, pan, tilt, pan, tilt};
  return config;
}

double Largest(const hardware::HeadAngles& a, const hardware::HeadAngles& b) {
  const auto x = hardware::ToArray(a), y = hardware::ToArray(b);
  double most = 0;
  for (int i = 0; i < hardware::kHeadAxisCount; ++i) most = std::max(most, std::abs(x[i] - y[i]));
  return most;
}

void Play(World& world, VirtualHead& head, double seconds) {
  for (int i = 0; i < seconds / hardware::ToSeconds(world.step()); ++i) {
    head.Update();
    world.Step();
  }
}

const hardware::HeadAngles kLookAround{
    {}, {40 * kDegree, 25 * kDegree}, {-35 * kDegree, -20 * kDegree}};

TEST(VirtualHead, JointsFollowTheProfileInMotionAndAtRest) {
  World world(kRoom);
  VirtualHead head(world, KoalaHead());
  Play(world, head, 0.3);
  head.Command(kLookAround);
  double in_motion = 0;
  while (!head.AtTarget()) {
    Play(world, head, 0.002);
    in_motion = std::max(in_motion, Largest(head.TrueAngles(), head.SetPoint()));
  }
  EXPECT_LT(in_motion, 1.0 * kDegree);
  Play(world, head, 0.3);
  EXPECT_LT(Largest(head.TrueAngles(), kLookAround), 0.05 * kDegree);
}

TEST(VirtualHead, PanTurnsACameraLeftAndTiltTurnsItDown) {
  World world(kRoom);
  VirtualHead head(world, KoalaHead());
  head.Command({{}, {30 * kDegree, 0}, {0, 20 * kDegree}});
  Play(world, head, 1.0);
  const Eigen::Vector3d left = world.X_WCamera("left").linear().col(2);
  const Eigen::Vector3d right = world.X_WCamera("right").linear().col(2);
  EXPECT_NEAR(std::atan2(left.y(), left.x()), 30 * kDegree, 0.1 * kDegree);
  EXPECT_NEAR(-std::asin(right.z()), 20 * kDegree, 0.1 * kDegree);
}

TEST(VirtualHead, ReachesEveryLimitAndStaysThere) {
  World world(kRoom);
  const VirtualHeadConfig config = KoalaHead();
  VirtualHead head(world, config);
  for (const double sign : {1.0, -1.0}) {
    head.Command({{}, {9 * sign, 9 * sign}, {9 * sign, 9 * sign}});
    Play(world, head, 3.5);
    const auto reached = hardware::ToArray(head.TrueAngles());
    for (int i = 2; i < hardware::kHeadAxisCount; ++i) {
      const double limit = sign > 0 ? config.limits[i].max_rad : config.limits[i].min_rad;
      EXPECT_NEAR(reached[i], limit, 0.05 * kDegree);
    }
  }
}

TEST(VirtualHead, IgnoresAxesThatTheSceneLacks) {
  World world(kRoom);
  VirtualHead head(world, KoalaHead());
  EXPECT_FALSE(head.limits()[0].exists());
  EXPECT_TRUE(head.limits()[2].exists());
  head.Command({{1, 1}, {}, {}});
  Play(world, head, 0.1);
  EXPECT_EQ(head.TrueAngles().neck.pan_rad, 0);
  EXPECT_TRUE(head.AtTarget());
}

TEST(VirtualHead, EncodersRoundToWholeStepsAndRepeatWithTheirSeed) {
  World world(kRoom);
  VirtualHeadConfig config = KoalaHead();
  config.encoder_resolution_rad = 0.0514285 * kDegree;
  VirtualHead exact(world, config);
  exact.Command(kLookAround);
  Play(world, exact, 1.0);
  const double steps = exact.ReadEncoders().left.pan_rad / config.encoder_resolution_rad;
  EXPECT_NEAR(steps, std::round(steps), 1e-9);
  EXPECT_LE(Largest(exact.ReadEncoders(), exact.TrueAngles()),
            config.encoder_resolution_rad / 2 + 1e-12);

  config.encoder_noise_rad = 0.3 * kDegree;
  config.seed = 5;
  VirtualHead a(world, config), b(world, config);
  config.seed = 6;
  VirtualHead c(world, config);
  double spread = 0;
  bool differs = false;
  for (int i = 0; i < 200; ++i) {
    const double reading = a.ReadEncoders().left.pan_rad;
    EXPECT_EQ(reading, b.ReadEncoders().left.pan_rad);
    differs = differs || reading != c.ReadEncoders().left.pan_rad;
    spread += std::pow(reading - a.TrueAngles().left.pan_rad, 2) / 200;
  }
  EXPECT_TRUE(differs);
  EXPECT_NEAR(std::sqrt(spread), 0.3 * kDegree, 0.06 * kDegree);
}

TEST(VirtualHead, RefusesLimitsBeyondTheJointsAndScenesWithoutAHead) {
  World world(kRoom);
  VirtualHeadConfig config = KoalaHead();
  config.limits[3].max_rad = 60 * kDegree;
  try {
    VirtualHead head(world, config);
    FAIL() << "expected ConfigError";
  } catch (const hardware::ConfigError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("left_tilt"));
  }
  const auto empty = World::FromXml("<mujoco><worldbody/></mujoco>");
  EXPECT_THROW(VirtualHead(*empty, KoalaHead()), SceneError);
  const auto bare = World::FromXml(R"(<mujoco><worldbody><body><joint name="left_pan"/>
      <geom size="0.1"/></body></worldbody></mujoco>)");
  EXPECT_THROW(VirtualHead(*bare, KoalaHead()), SceneError);
}

hardware::HeadAngles AfterLooking(const VirtualHeadConfig& config, double seconds,
                                  hardware::HeadAngles* reading = nullptr) {
  World world(kRoom);
  VirtualHead head(world, config);
  head.Command(kLookAround);
  Play(world, head, seconds);
  if (reading != nullptr) *reading = head.ReadEncoders();
  return head.TrueAngles();
}

hardware::Time At(double s) { return hardware::Time(hardware::FromSeconds(s)); }

TEST(VirtualHeadFaults, OfOneAxisLeaveTheOthersAsTheyWere) {
  VirtualHeadConfig sound = KoalaHead(), faulty = KoalaHead();
  faulty.faults = {{Backlash{hardware::HeadAxis::kLeftPan, 1 * kDegree}},
                   {EncoderBias{hardware::HeadAxis::kLeftTilt, 2 * kDegree}}};
  hardware::HeadAngles read_sound, read_faulty;
  const auto a = AfterLooking(sound, 1, &read_sound), b = AfterLooking(faulty, 1, &read_faulty);
  // Backlash shakes the body, which the joints of one eye hang on; what is commanded is the same.
  EXPECT_NEAR(a.right.pan_rad, b.right.pan_rad, 1e-6);
  EXPECT_NEAR(a.left.pan_rad - b.left.pan_rad, 0.5 * kDegree, 0.01 * kDegree);
  EXPECT_NEAR(read_faulty.left.pan_rad, read_sound.left.pan_rad, 0.01 * kDegree);
  EXPECT_NEAR(read_faulty.left.tilt_rad - read_sound.left.tilt_rad, 2 * kDegree, 1e-6);
  EXPECT_NEAR(b.left.tilt_rad, a.left.tilt_rad, 1e-6);
}

TEST(VirtualHeadFaults, ThatNeverBeginChangeNoBit) {
  VirtualHeadConfig sound = KoalaHead(), later = KoalaHead();
  sound.encoder_noise_rad = later.encoder_noise_rad = 0.1 * kDegree;
  const TimeWindow never{At(100), At(101)};
  using hardware::HeadAxis;
  later.faults = {{Backlash{HeadAxis::kLeftPan, 1}, never},
                  {ZeroOff{hardware::Eye::kRight, 0.1, 0.1}, never},
                  {EncoderNoise{HeadAxis::kLeftTilt, 1}, never},
                  {StuckAxis{HeadAxis::kRightPan}, never}};
  hardware::HeadAngles read_sound, read_later;
  const auto a = AfterLooking(sound, 0.5, &read_sound), b = AfterLooking(later, 0.5, &read_later);
  EXPECT_EQ(hardware::ToArray(a), hardware::ToArray(b));
  EXPECT_EQ(hardware::ToArray(read_sound), hardware::ToArray(read_later));
}

TEST(VirtualHeadFaults, AZeroThatIsOffTurnsTheCameraAndNotTheReading) {
  World world(kRoom);
  VirtualHeadConfig config = KoalaHead();
  config.faults = {{ZeroOff{hardware::Eye::kLeft, 2 * kDegree, 0}}};
  VirtualHead head(world, config);
  Play(world, head, 0.5);
  const Eigen::Vector3d axis = world.X_WCamera("left").linear().col(2);
  EXPECT_NEAR(std::atan2(axis.y(), axis.x()), 2 * kDegree, 0.02 * kDegree);
  EXPECT_NEAR(head.ReadEncoders().left.pan_rad, 0, 0.02 * kDegree);
}

TEST(VirtualHeadFaults, AStuckAxisStaysAndGoesOnWhenItIsReleased) {
  World world(kRoom);
  VirtualHeadConfig config = KoalaHead();
  config.time_zero = hardware::FromSeconds(0.1);
  config.faults = {{StuckAxis{hardware::HeadAxis::kLeftPan}, {At(0.1), At(0.6)}}};
  VirtualHead head(world, config);
  head.Command(kLookAround);
  Play(world, head, 0.3);
  const double held = head.TrueAngles().left.pan_rad;
  EXPECT_GT(held, 5 * kDegree) << "it had begun to move";
  EXPECT_LT(held, 30 * kDegree);
  Play(world, head, 0.35);
  EXPECT_NEAR(head.TrueAngles().left.pan_rad, held, 0.05 * kDegree);
  EXPECT_NEAR(head.TrueAngles().right.pan_rad, kLookAround.right.pan_rad, 0.05 * kDegree);
  EXPECT_FALSE(head.AtTarget());
  Play(world, head, 0.8);
  EXPECT_NEAR(head.TrueAngles().left.pan_rad, kLookAround.left.pan_rad, 0.05 * kDegree);
}

TEST(VirtualHeadFaults, OfAxesThatTheSceneLacksAreRefused) {
  World world(kRoom);
  VirtualHeadConfig config = KoalaHead();
  config.faults = {{StuckAxis{hardware::HeadAxis::kNeckPan}}};
  try {
    VirtualHead head(world, config);
    FAIL() << "expected ConfigError";
  } catch (const hardware::ConfigError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("neck_pan"));
  }
}

}  // namespace
}  // namespace horopter::sim
