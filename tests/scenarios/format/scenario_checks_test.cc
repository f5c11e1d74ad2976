// SPDX-License-Identifier: Apache-2.0
#include "scenarios/format/scenario_checks.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "control/navigator/navigator_config.h"
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
    for (int eye = 0; eye < 2; ++eye) {
      Replace(robot, "min_deg: -158.9, max_deg: 158.9", "min_deg: -60, max_deg: 60");
    }
    scenes_.Write("koala/robot.yaml", robot);
    scenes_.Write("koala/koala.xml",
                  "<mujoco><worldbody><body name='base'><freejoint/><body name='head'><camera "
                  "name='left'/><camera name='right'/></body></body></worldbody></mujoco>");
    scenes_.Write("koala/room.xml",
                  "<mujoco><include file='koala.xml'/><worldbody><geom name='floor' type='plane' "
                  "size='2.6 2 0.5' pos='1.6 0 0'/><body name='board'><geom name='board'/><body "
                  "name='stand'/></body></worldbody>"
                  "</mujoco>");
    scenes_.Write("koala/shell.xml", "<mujoco/>");
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
  EXPECT_EQ(Faults("goto: {x_m: -0.9, y_m: 0}\n  - fixate: {x_m: -3, y_m: 0, z_m: 0.3}"), "");
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

TEST_F(ScenarioChecks, TheSceneMustHoldTheRobot) {
  EXPECT_THAT(Faults("wait: {duration_s: 1}", "koala/shell.xml"),
              HasSubstr("s.yaml:1:8: scene 'koala/shell.xml' has no camera 'left'"));
}

TEST_F(ScenarioChecks, BodiesToPlaceMustBeInTheScene) {
  const auto placed = [this](const std::string& body) {
    return Faults("wait: {duration_s: 1}", "koala/room.xml",
                  "bodies: {" + body + ": {position_m: [1, 0, 0]}}\n");
  };
  EXPECT_EQ(placed("board"), "");
  EXPECT_THAT(placed("bord"), HasSubstr("s.yaml:2:16: bodies.bord: scene 'koala/room.xml'"));
  EXPECT_THAT(placed("bord"), HasSubstr("did you mean 'board'?"));
}

TEST_F(ScenarioChecks, OnlyWhatStandsInTheSceneCanBePlaced) {
  const auto placed = [this](const std::string& body) {
    return Faults("wait: {duration_s: 1}", "koala/room.xml",
                  "bodies: {" + body + ": {position_m: [1, 0, 0]}}\n");
  };
  EXPECT_EQ(placed("stand"), "");
  EXPECT_THAT(placed("base"), HasSubstr("s.yaml:2:16: bodies.base: moves on joints"));
  EXPECT_THAT(placed("head"), HasSubstr("bodies.head: moves on joints"));
}

TEST_F(ScenarioChecks, BodiesLeaveTheRobotItsStart) {
  const auto placed = [this](const std::string& position) {
    return Faults("wait: {duration_s: 1}", "koala/room.xml",
                  "bodies: {board: {position_m: " + position + "}}\n");
  };
  EXPECT_THAT(placed("[0, 0, 0]"),
              HasSubstr("s.yaml:2:17: bodies.board: position_m = [0, 0, 0] is inside the robot at "
                        "its start; place it more than 0.235 m from there"));
  EXPECT_THAT(placed("[0.1, -0.2, 0.3]"), HasSubstr("is inside the robot"));
  EXPECT_EQ(placed("[0.1, -0.22, 0.3]"), "");
  EXPECT_EQ(placed("[0, 0, 0.5]"), "");
}

TEST_F(ScenarioChecks, GoalsAreOnTheFloor) {
  EXPECT_EQ(Faults("goto: {x_m: 4.1, y_m: -1.9}"), "");
  EXPECT_THAT(Faults("wait: {duration_s: 1}\n  - goto: {x_m: 100, y_m: 100}"),
              HasSubstr("s.yaml:4:5: goto (100, 100) is off the floor of scene 'koala/room.xml': "
                        "give x_m from -1 to 4.2 and y_m from -2 to 2"));
  EXPECT_THAT(Faults("goto: {x_m: 1, y_m: -2.1}"), HasSubstr("is off the floor"));
  scenes_.Write("koala/room.xml",
                "<mujoco><include file='koala.xml'/><worldbody><geom name='floor' type='plane' "
                "size='0 0 1'/></worldbody></mujoco>");
  EXPECT_EQ(Faults("goto: {x_m: 90, y_m: 90}"), "");  // a floor without end
}

TEST_F(ScenarioChecks, BoardsAreJudgedWhereThereIsOne) {
  const auto faults = [this](const std::string& scene) {
    try {
      ParseScenarioText("scene: " + scene +
                            "\nsteps:\n  - fixate: {x_m: 1, y_m: 0, z_m: 0.3}\nexpect:\n"
                            "  - board.depth_error.mean <= 1 cm\n  - board.density >= 0.5\n",
                        "s.yaml", {scenes_.path()});
    } catch (const ScenarioError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  scenes_.Write("koala/bare.xml", "<mujoco><include file='koala.xml'/></mujoco>");
  EXPECT_EQ(faults("koala/room.xml"), "");
  EXPECT_THAT(
      faults("koala/bare.xml"),
      testing::AllOf(HasSubstr("s.yaml:5:5: 'board.depth_error.mean <= 1 cm' judges a board, "
                               "but scene 'koala/bare.xml' has no geom 'board'"),
                     HasSubstr("s.yaml:6:5: 'board.density >= 0.5' judges a board")));
}

TEST_F(ScenarioChecks, HoldsAndTimeoutsFitIntoTheTimeLimit) {
  EXPECT_THAT(Faults("goto: {x_m: 1, y_m: 0, timeout_s: 500}"), HasSubstr("goto.timeout_s = 500"));
  EXPECT_THAT(Faults("wait: {duration_s: 500}"), HasSubstr("lasts at least 500 s"));
  EXPECT_THAT(Faults("wait: {duration_s: 100}\n  - wait: {duration_s: 30}"),
              HasSubstr("s.yaml:4:5: with this step the run lasts at least 130 s"));
  EXPECT_EQ(Faults("wait: {duration_s: 100}"), "");
}

TEST_F(ScenarioChecks, WhatTheNavigatorCannotDoIsOutOfRange) {
  EXPECT_THAT(Faults("goto: {x_m: 1, y_m: 0, tolerance_m: 0.03}"),
              HasSubstr("tolerance_m = 0.03: must be a number from 0.05"));
  EXPECT_THAT(
      Faults("wait: {duration_s: 1}", "koala/room.xml",
             "navigation: {cruise_speed_m_s: 0.02, obstacle_limit_m: 5}\n"),
      testing::AllOf(HasSubstr("cruise_speed_m_s = 0.02"), HasSubstr("obstacle_limit_m = 5")));
}

TEST(NavigationSpec, LeavesTheObstacleLimitAtTheNavigatorsOwn) {
  EXPECT_EQ(NavigationSpec{}.obstacle_limit_m, control::NavigatorConfig{}.obstacle_distance_m);
}

TEST_F(ScenarioChecks, RobotWithoutWheelsPlaysNoScenarioYet) {
  std::string robot = Slurp(HOROPTER_SOURCE_DIR "/scenes/koala/robot.yaml");
  robot.erase(robot.find("wheels:"), robot.find("head:") - robot.find("wheels:"));
  scenes_.Write("koala/robot.yaml", robot);
  EXPECT_THAT(Faults("wait: {duration_s: 1}", "koala/room.xml", "robot: koala\n"),
              HasSubstr("s.yaml:2:8: robot 'koala' plays no scenarios yet"));
}

TEST_F(ScenarioChecks, WhatIsLeftOutIsTheRobots) {
  const auto parsed = [this](const std::string& more) {
    return ParseScenarioText(
        "scene: koala/room.xml\n" + more + "steps:\n  - wait: {duration_s: 1}\nexpect: []\n",
        "s.yaml", {scenes_.path()});
  };
  EXPECT_EQ(parsed("").camera.horizontal_fov_deg, 60);
  EXPECT_EQ(parsed("").head.encoder_step_deg, 0.0514285);
  EXPECT_EQ(parsed("camera: {horizontal_fov_deg: 40}\n").camera.horizontal_fov_deg, 40);
  EXPECT_EQ(parsed("head: {encoder_step_deg: 0}\n").head.encoder_step_deg, 0);
  const Scenario whole = parsed("");
  EXPECT_THAT(ResolvedYaml(whole), HasSubstr("horizontal_fov_deg: 60"));
}

TEST_F(ScenarioChecks, ProfileIsNamedAndThenChangedByHand) {
  const Scenario s = ParseScenarioText(
      "scene: koala/room.xml\n"
      "camera: {timing: {rate_hz: 15}, lens: {distortion: [-0.3, 0, 0, 0, 0]}, profile: "
      "webcam_vga}\n"
      "steps:\n  - wait: {duration_s: 1}\nexpect: []\n",
      "s.yaml", {scenes_.path()});
  const auto webcam = sim::CameraProfile::Named("webcam_vga");
  EXPECT_EQ(s.camera.profile.timing.rate_hz, 15);
  EXPECT_EQ(s.camera.profile.timing.latency_s, webcam.timing.latency_s);
  EXPECT_EQ(s.camera.profile.lens.distortion.k1, -0.3);
  EXPECT_EQ(s.camera.profile.lens.blur_px, webcam.lens.blur_px);
  EXPECT_EQ(s.camera.profile.shutter, webcam.shutter);
  EXPECT_THAT(Faults("wait: {duration_s: 1}", "koala/room.xml",
                     "camera: {timing: {drop_probability: 0.1}}\n"),
              HasSubstr("camera.timing.rate_hz = 0: must be positive for frames to be dropped"));
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

TEST_F(ScenarioChecks, FaultsAreOfAxesThatTheRobotHas) {
  const std::string step = "wait: {duration_s: 1}";
  const auto faults = [&](const std::string& fault) {
    return Faults(step, "koala/room.xml", "faults:\n  - " + fault + "\n");
  };
  EXPECT_EQ(faults("stuck_axis: {axis: left_pan}"), "");
  EXPECT_THAT(faults("stuck_axis: {axis: neck_pan}"),
              HasSubstr("s.yaml:3:5: robot 'koala' has no axis 'neck_pan'"));
  EXPECT_EQ(faults("zero_off: {eye: left, pan_deg: 2, tilt_deg: 1}"), "");
  EXPECT_THAT(faults("swapped_pair: {from_s: 3, until_s: 3}"),
              HasSubstr("until_s = 3: must be later than from_s = 3"));
}

TEST_F(ScenarioChecks, RoomsHaveAGoalAndNoFewerObstaclesThanTheirLeast) {
  EXPECT_EQ(Faults("goto: {x_m: 2, y_m: 0}", "koala/room.xml", "room: {}\n"), "");
  EXPECT_THAT(Faults("wait: {duration_s: 1}", "koala/room.xml", "room: {}\n"),
              HasSubstr("s.yaml:2:7: room: its path leads to the goals of goto steps"));
  EXPECT_THAT(Faults("goto: {x_m: 2, y_m: 0}", "koala/room.xml", "room: {max_obstacles: 2}\n"),
              HasSubstr("room.max_obstacles = 2: must be at least room.min_obstacles = 4"));
}

}  // namespace
}  // namespace horopter::scenarios
