// SPDX-License-Identifier: Apache-2.0
#include "scenarios/format/robot_description.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

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
  EXPECT_NEAR(robot.base.metres_per_pulse * robot.pulses_per_turn, 2 * M_PI * robot.wheel_radius_m,
              1e-4);
}

TEST(RobotDescription, MissingAndUnknownKeysAreAllNamed) {
  std::string text = Slurp(kKoala);
  const std::string key = "baseline_m:";
  text.replace(text.find("\n" + key) + 1, key.size(), "baselin_m:");
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
