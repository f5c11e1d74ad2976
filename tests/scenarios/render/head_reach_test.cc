// SPDX-License-Identifier: Apache-2.0
#include "scenarios/render/head_reach.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "hardware/types/config_error.h"

namespace horopter::scenarios {
namespace {

using testing::HasSubstr;

HeadReach ReachOf(const std::string& robot) {
  const std::filesystem::path scenes = HOROPTER_SOURCE_DIR "/scenes";
  return HeadReach(LoadRobotDescription(scenes / robot / "robot.yaml"));
}

TEST(HeadReach, ConvergingEyesTurnTowardsEachOtherOnEveryHeadThatCan) {
  const auto koala = ReachOf("koala").AnglesOf({10, 5, 4});
  EXPECT_NEAR(koala.left.pan_rad, 8 * M_PI / 180, 1e-12);
  EXPECT_NEAR(koala.right.pan_rad, 12 * M_PI / 180, 1e-12);
  EXPECT_EQ(koala.neck.pan_rad, 0);
  const auto yorick = ReachOf("yorick").AnglesOf({10, 5, 4});
  EXPECT_NEAR(yorick.neck.pan_rad, 10 * M_PI / 180, 1e-12);
  EXPECT_NEAR(yorick.left.pan_rad, -2 * M_PI / 180, 1e-12);
  EXPECT_THROW(ReachOf("nao").AnglesOf({0, 0, 4}), hardware::ConfigError);
  EXPECT_THROW(ReachOf("yorick").AnglesOf({100, 0, 0}), hardware::ConfigError);
}

TEST(HeadReach, NaoPitchesAsFarAsItsShouldersAllowAtThatYaw) {
  const HeadReach nao = ReachOf("nao");
  EXPECT_NO_THROW(nao.AnglesOf({0, 29, 0}));
  EXPECT_NO_THROW(nao.AnglesOf({87.49, 11.4, 0}));
  EXPECT_NO_THROW(nao.AnglesOf({-87.49, -18.9, 0}));
  try {
    nao.AnglesOf({87, 29, 0}, "gazes.csv:4: ");
    FAIL();
  } catch (const hardware::ConfigError& error) {
    EXPECT_THAT(error.what(), testing::StartsWith("gazes.csv:4: tilt = 29 deg"));
    EXPECT_THAT(error.what(), HasSubstr("at a pan of 87 deg this head tilts from -19.0 to 11.6"));
  }
  EXPECT_NO_THROW(ReachOf("yorick").AnglesOf({87, 29, 0})) << "no other head has such a table";
}

TEST(HeadReach, EveryAxisIsHeldToItsOwnLimits) {
  const HeadReach yorick = ReachOf("yorick");
  hardware::HeadAngles angles;
  angles.left.pan_rad = -45 * M_PI / 180;
  angles.neck.tilt_rad = 40 * M_PI / 180;
  EXPECT_NO_THROW(yorick.Require(angles));
  angles.left.pan_rad = 0.1;  // diverges
  EXPECT_THROW(yorick.Require(angles), hardware::ConfigError);
  angles = {};
  angles.left.tilt_rad = 0.1;
  try {
    yorick.Require(angles);
    FAIL();
  } catch (const hardware::ConfigError& error) {
    EXPECT_THAT(error.what(), HasSubstr("left_tilt_deg"));
    EXPECT_THAT(error.what(), HasSubstr("has no such axis"));
  }
}

}  // namespace
}  // namespace horopter::scenarios
