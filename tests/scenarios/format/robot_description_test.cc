// SPDX-License-Identifier: Apache-2.0
#include "scenarios/format/robot_description.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "hardware/types/config_error.h"
#include "scenarios/format/scenes.h"
#include "tests/scenarios/format/corpus.h"

namespace horopter::scenarios {
namespace {

const std::filesystem::path kKoala = HOROPTER_SOURCE_DIR "/scenes/koala/robot.yaml";

TEST(RobotDescription, ShippedKoalaHasTheLimitsOfItsPanTiltUnit) {
  const RobotDescription robot = LoadRobotDescription(kKoala);
  EXPECT_EQ(robot.name, "koala");
  using hardware::HeadAxis;
  for (HeadAxis axis : {HeadAxis::kLeftPan, HeadAxis::kRightPan}) {
    const auto& limits = robot.head_limits[static_cast<std::size_t>(axis)];
    EXPECT_NEAR(limits.max_rad, 158.9 * M_PI / 180, 1e-9);
    EXPECT_NEAR(limits.min_rad, -limits.max_rad, 1e-9);
    EXPECT_GT(limits.max_speed_rad_s, 0);
  }
  EXPECT_FALSE(robot.head_limits[static_cast<std::size_t>(HeadAxis::kNeckPan)].exists());
  EXPECT_GT(robot.head_geometry.baseline_m, 0);
  EXPECT_GT(robot.head_geometry.X_BN.translation().z(), 0);
  ASSERT_TRUE(robot.wheels);
  EXPECT_EQ(robot.wheels->pulses_per_turn, 5850);
  EXPECT_GT(robot.encoder_step_deg, 0);
  EXPECT_EQ(robot.Cameras("").width_px, 640);
  EXPECT_NEAR(robot.Cameras("eyes").Model().horizontal_fov_rad(), M_PI / 3, 1e-9);
}

TEST(RobotDescription, RobotWithoutWheelsHasNone) {
  const RobotDescription robot = ParseRobotDescription(
      "{name: bust, radius_m: 0.2, height_m: 0.5, head: {neck_m: [0, 0, 0.4], baseline_m: 0.06},"
      " cameras: {eyes: {left: l, right: r, width_px: 64, height_px: 48, horizontal_fov_deg: 60}}}",
      "robot.yaml");
  EXPECT_FALSE(robot.wheels);
  for (const hardware::AxisLimits& axis : robot.head_limits) EXPECT_FALSE(axis.exists());
}

TEST(RobotDescription, UnknownPairIsRefusedWithTheNamesThereAre) {
  const RobotDescription robot = LoadRobotDescription(kKoala);
  try {
    robot.Cameras("fovea");
    FAIL();
  } catch (const hardware::ConfigError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("camera = fovea"));
    EXPECT_THAT(error.what(), testing::HasSubstr("eyes"));
  }
}

TEST(RobotDescription, UnknownAxisIsRefused) {
  std::string text = Slurp(kKoala);
  text.replace(text.find("left_pan:"), 9, "lift_pan:");
  EXPECT_THROW(ParseRobotDescription(text, "robot.yaml"), ScenarioError);
}

TEST(RobotDescription, MissingAndUnknownKeysAreAllNamed) {
  std::string text = Slurp(kKoala);
  const std::string key = "baseline_m:";
  text.replace(text.find(key), key.size(), "baselin_m:");
  try {
    ParseRobotDescription(text, "robot.yaml");
    FAIL();
  } catch (const ScenarioError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("required key 'baseline_m' is missing"));
    EXPECT_THAT(error.what(), testing::HasSubstr("did you mean 'baseline_m'?"));
  }
}

TEST(Scenes, RobotsAndScenesAreFoundBelowTheFolder) {
  TemporaryFolder folder;
  folder.Write("koala/robot.yaml", "");
  folder.Write("koala/room.xml", "");
  folder.Write("empty/readme.txt", "");
  EXPECT_THAT(RobotNames(folder.path()), testing::ElementsAre("koala"));
  EXPECT_THAT(SceneNames(folder.path()), testing::ElementsAre("koala/room.xml"));
  EXPECT_TRUE(SceneNames(folder.path() / "missing").empty());
}

}  // namespace
}  // namespace horopter::scenarios
