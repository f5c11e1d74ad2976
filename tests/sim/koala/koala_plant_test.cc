// SPDX-License-Identifier: Apache-2.0
#include "sim/koala/koala_plant.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "hardware/types/config_error.h"

namespace horopter::sim {
namespace {

const std::string kRoom = std::string(HOROPTER_SOURCE_DIR) + "/scenes/koala/room.xml";
constexpr double kMetresPerPulse = 0.045e-3;

/// A Koala that has settled on its wheels.
class KoalaPlantTest : public testing::Test {
 protected:
  KoalaPlantTest() { Coast(0.5); }

  int Steps(double seconds) const {
    return static_cast<int>(std::lround(seconds / hardware::ToSeconds(world_.step())));
  }
  void Drive(double left_m_s, double right_m_s, double seconds) {
    for (int i = 0; i < Steps(seconds); ++i) {
      plant_.Command({left_m_s, right_m_s});
      plant_.Update();
      world_.Step();
    }
  }
  void Coast(double seconds) {
    for (int i = 0; i < Steps(seconds); ++i) {
      plant_.Update();
      world_.Step();
    }
  }

  /// What happens in `seconds` of steady driving, after the ramps.
  struct Motion {
    double left_m, right_m;  ///< by the encoders
    double way_m, turn_rad;  ///< by truth
  };
  Motion Steady(double left_m_s, double right_m_s, double seconds) {
    Drive(left_m_s, right_m_s, 0.8);
    const WheelPulses pulses = plant_.Encoders();
    const hardware::Pose2 pose = plant_.TruePose();
    Drive(left_m_s, right_m_s, seconds);
    const WheelPulses now = plant_.Encoders();
    const hardware::Pose2 there = plant_.TruePose();
    return {(now.left - pulses.left) * kMetresPerPulse,
            (now.right - pulses.right) * kMetresPerPulse,
            std::hypot(there.x_m - pose.x_m, there.y_m - pose.y_m),
            hardware::WrapAngle(there.heading_rad - pose.heading_rad)};
  }

  World world_{kRoom};
  KoalaPlant plant_{world_};
};

TEST_F(KoalaPlantTest, RestsStably) {
  const hardware::Pose2 before = plant_.TruePose();
  Coast(3);
  const hardware::Pose2 after = plant_.TruePose();
  EXPECT_NEAR(after.x_m, before.x_m, 1e-4);
  EXPECT_NEAR(after.y_m, before.y_m, 1e-4);
  EXPECT_NEAR(after.heading_rad, before.heading_rad, 1e-4);
  EXPECT_NEAR(world_.X_WBody("base").translation().z(), 0, 5e-4);
  EXPECT_GT(world_.X_WBody("base").linear()(2, 2), std::cos(0.01));
  EXPECT_LE(std::abs(plant_.Encoders().left), 2);
}

TEST_F(KoalaPlantTest, DrivesStraightAtTheCommandedSpeed) {
  for (const double speed : {0.2, -0.1}) {
    const Motion motion = Steady(speed, speed, 1);
    EXPECT_NEAR(motion.way_m, std::abs(speed), 0.03 * std::abs(speed));
    EXPECT_NEAR(motion.left_m, speed, 0.03 * std::abs(speed));
    EXPECT_NEAR(motion.right_m, speed, 0.03 * std::abs(speed));
    EXPECT_NEAR(motion.turn_rad, 0, 0.005);
  }
}

TEST_F(KoalaPlantTest, TurnsWithTheEffectiveTrackOfRealKoalas) {
  for (const double rate_rad_s : {0.1, 0.25, -0.5, 0.5, 1.0}) {
    const double wheel = 0.31 / 2 * rate_rad_s;
    const Motion motion = Steady(-wheel, wheel, 1.5);
    const double track_m = (motion.right_m - motion.left_m) / motion.turn_rad;
    EXPECT_GT(track_m, 0.300) << rate_rad_s;
    EXPECT_LT(track_m, 0.320) << rate_rad_s;
    EXPECT_LT(motion.way_m, 0.02) << rate_rad_s;
  }
}

TEST_F(KoalaPlantTest, TurnsLikewiseWhileDriving) {
  const double wheel = 0.31 / 2 * 0.5;
  const Motion motion = Steady(0.2 - wheel, 0.2 + wheel, 1);
  const double track_m = (motion.right_m - motion.left_m) / motion.turn_rad;
  EXPECT_GT(track_m, 0.300);
  EXPECT_LT(track_m, 0.320);
}

TEST_F(KoalaPlantTest, RampsNoFasterThanItsAcceleration) {
  double last = 0;
  for (int i = 0; i < Steps(0.6); ++i) {
    plant_.Command({0.5, 0.5});
    plant_.Update();
    const double now = plant_.set_point().left_m_s;
    EXPECT_LE(now - last, 1.0 * hardware::ToSeconds(world_.step()) + 1e-12);
    last = now;
    world_.Step();
  }
  EXPECT_EQ(last, 0.5);
}

TEST_F(KoalaPlantTest, StopsByItselfWhenCommandsCease) {
  Drive(0.2, 0.2, 0.5);
  Coast(0.45);
  EXPECT_NEAR(plant_.TrueTwist().forward_m_s, 0.2, 0.01);
  Coast(0.45);
  EXPECT_NEAR(plant_.TrueTwist().forward_m_s, 0, 0.005);
  const double x = plant_.TruePose().x_m;
  Coast(1);
  EXPECT_NEAR(plant_.TruePose().x_m, x, 0.002);
}

TEST_F(KoalaPlantTest, ScalesTooFastCommandsDownTogether) {
  plant_.Command({3, 1.5});
  Drive(3, 1.5, 0.8);
  EXPECT_NEAR(plant_.set_point().left_m_s, 0.5715, 1e-12);
  EXPECT_NEAR(plant_.set_point().right_m_s, 0.5715 / 2, 1e-12);
}

TEST_F(KoalaPlantTest, SurvivesReversalsAtFullSpeed) {
  for (int i = 0; i < 6; ++i) {
    const double speed = i % 2 == 0 ? 0.6 : -0.6;
    Drive(speed, i < 3 ? speed : -speed, 0.5);
    for (int k = 0; k < world_.model().nq; ++k) ASSERT_TRUE(std::isfinite(world_.data().qpos[k]));
    EXPECT_GT(world_.X_WBody("base").linear()(2, 2), std::cos(0.1));
    EXPECT_LT(std::abs(world_.X_WBody("base").translation().z()), 0.01);
  }
}

TEST_F(KoalaPlantTest, RefusesSpeedsThatAreNotFinite) {
  Drive(0.1, 0.1, 0.1);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(plant_.Command({nan, 0}), std::invalid_argument);
  plant_.Update();
  EXPECT_TRUE(std::isfinite(plant_.set_point().left_m_s));
}

TEST_F(KoalaPlantTest, EncodersCountOnFromWhereTheyAreSet) {
  plant_.SetEncoders({1000, -2000});
  EXPECT_EQ(plant_.Encoders().left, 1000);
  EXPECT_EQ(plant_.Encoders().right, -2000);
  Drive(0.1, 0.1, 0.5);
  EXPECT_NEAR(plant_.Encoders().left - 1000, plant_.Encoders().right + 2000, 3);
  EXPECT_GT(plant_.Encoders().left, 1000 + 500);
}

TEST(KoalaPlant, RefusesScenesWithoutAKoalaAndBadConfigurations) {
  const auto empty = World::FromXml("<mujoco><worldbody/></mujoco>");
  EXPECT_THROW(KoalaPlant{*empty}, SceneError);
  World world(kRoom);
  KoalaPlantConfig config;
  config.metres_per_pulse = 0;
  config.max_wheel_speed_m_s = -1;
  try {
    KoalaPlant plant(world, config);
    FAIL() << "expected ConfigError";
  } catch (const hardware::ConfigError& error) {
    EXPECT_EQ(error.errors().size(), 2U);
  }
}

}  // namespace
}  // namespace horopter::sim
