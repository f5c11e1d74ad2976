// SPDX-License-Identifier: Apache-2.0
#include "scenarios/format/scenario_checks.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scenarios/format/scenario_format.h"
#include "tests/scenarios/format/corpus.h"

namespace horopter::scenarios {
namespace {

using testing::HasSubstr;

/// A scenes folder with one scene and the shipped Koala, its pan cut to +-60 deg.
class ScenarioChecks : public testing::Test {
 protected:
  ScenarioChecks() {
    std::string robot = Slurp(HOROPTER_SOURCE_DIR "/scenes/koala/robot.yaml");
    Replace(robot, "pan_min_deg: -158.9", "pan_min_deg: -60");
    Replace(robot, "pan_max_deg: 158.9", "pan_max_deg: 60");
    scenes_.Write("koala/robot.yaml", robot);
    scenes_.Write("koala/room.xml", "");
  }

  static void Replace(std::string& text, const std::string& from, const std::string& to) {
    ASSERT_NE(text.find(from), std::string::npos) << from;
    text.replace(text.find(from), from.size(), to);
  }

  std::string Faults(const std::string& step, const std::string& scene = "koala/room.xml",
                     const std::string& more = "") {
    try {
      ParseScenarioText("scene: " + scene + "\n" + more + "steps:\n  - " + step + "\nexpect: []\n",
                        "s.yaml", {scenes_.path()});
    } catch (const ScenarioError& error) {
      return error.what();
    }
    return "";
  }

  TemporaryFolder scenes_;
};

TEST_F(ScenarioChecks, TargetsBehindTheRobotAreRefused) {
  EXPECT_EQ(Faults("fixate: {x_m: 1, y_m: 0.3, z_m: 0.3}"), "");
  EXPECT_THAT(Faults("fixate: {x_m: -1, y_m: 0.1, z_m: 0.3}"),
              HasSubstr("s.yaml:3:5: target is behind the robot: "));
  EXPECT_THAT(Faults("look_at: {x_m: -1, y_m: -2, z_m: 0.3}"), HasSubstr("behind the robot"));
  EXPECT_THAT(Faults("look_at: {x_m: 0.3, y_m: 2, z_m: 0.3}"),
              HasSubstr("out of the head's reach"));
  EXPECT_THAT(Faults("fixate: {x_m: 0.4, y_m: 0, z_m: 3}"), HasSubstr("out of the head's reach"));
}

TEST_F(ScenarioChecks, TargetsAfterADriveAreLeftToTheRun) {
  EXPECT_EQ(Faults("goto: {x_m: -2, y_m: 0}\n  - fixate: {x_m: -3, y_m: 0, z_m: 0.3}"), "");
}

TEST_F(ScenarioChecks, SaccadesStayWithinTheHeadsRange) {
  EXPECT_EQ(Faults("saccade: {pan_deg: 50, tilt_deg: 10, vergence_deg: 10}"), "");
  EXPECT_THAT(Faults("saccade: {pan_deg: 70}"), HasSubstr("pan of 70 deg"));
  EXPECT_THAT(Faults("saccade: {pan_deg: 58, vergence_deg: 10}"), HasSubstr("right pan of 63 deg"));
  EXPECT_THAT(Faults("saccade: {tilt_deg: 80}"), HasSubstr("tilt of 80 deg"));
}

TEST_F(ScenarioChecks, ScenesAndRobotsMustExist) {
  EXPECT_THAT(Faults("wait: {duration_s: 1}", "koala/rom.xml"),
              HasSubstr("s.yaml:1:8: scene 'koala/rom.xml' is not in"));
  EXPECT_THAT(Faults("wait: {duration_s: 1}", "koala/rom.xml"),
              HasSubstr("did you mean 'koala/room.xml'?"));
  EXPECT_THAT(Faults("wait: {duration_s: 1}", "koala/room.xml", "robot: koalla\n"),
              HasSubstr("s.yaml:2:8: unknown robot 'koalla'"));
}

TEST_F(ScenarioChecks, AFaultInOneStepDoesNotHideAnother) {
  const std::string faults = Faults("fixate: {x_m: -1, y_m: 0, z_m: 0.3}\n  - fixate: {x_m: 1}");
  EXPECT_THAT(faults, HasSubstr("s.yaml:3:5: target is behind"));
  EXPECT_THAT(faults, HasSubstr("s.yaml:4:13: steps[1].fixate: required key 'y_m'"));
}

TEST(ShippedScenarios, AreValid) {
  const std::filesystem::path root = HOROPTER_SOURCE_DIR;
  int found = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(root / "scenarios")) {
    if (entry.path().extension() != ".yaml") continue;
    ++found;
    try {
      ParseScenario(entry.path(), {root / "scenes"});
    } catch (const ScenarioError& error) {
      ADD_FAILURE() << error.what();
    }
  }
  EXPECT_GT(found, 0);
}

}  // namespace
}  // namespace horopter::scenarios
