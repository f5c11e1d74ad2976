// SPDX-License-Identifier: Apache-2.0
#include "scenarios/render/motion.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <string>

#include "hardware/types/config_error.h"
#include "scenarios/format/diagnostics.h"
#include "scenarios/format/scenes.h"
#include "tests/scenarios/format/corpus.h"

namespace horopter::scenarios {
namespace {

using testing::HasSubstr;

constexpr double kRadians = M_PI / 180;

class MotionTest : public testing::Test {
 protected:
  Motion Read(const std::string& yaml) const {
    return ReadMotionFile(folder_.Write("motion.yaml", yaml));
  }

  static RobotDescription Robot(const std::string& name) {
    return LoadRobotDescription(RobotFile(ScenesDir(), name));
  }

  void ExpectRefused(const std::string& robot, const std::string& yaml,
                     const std::string& why) const {
    try {
      CheckMotion(Read(yaml), Robot(robot));
      ADD_FAILURE() << yaml;
    } catch (const std::exception& error) {
      EXPECT_THAT(error.what(), HasSubstr(why)) << yaml;
    }
  }

  TemporaryFolder folder_;
};

TEST_F(MotionTest, AFileSaysWhatIsDoneAndWhen) {
  const Motion motion = Read(R"(
duration_s: 6
commands:
  - saccade: {at_s: 0.5, pan_deg: 20, tilt_deg: -5}
  - walk_to: {at_s: 1, x_m: 0.3, turn_deg: 20}
  - walk: {at_s: 5, forward_m_s: 0.05}
)");
  EXPECT_EQ(motion.duration_s, 6);
  ASSERT_EQ(motion.commands.size(), 3u);
  EXPECT_EQ(motion.commands[0].at_s, 0.5);
  const auto& saccade = std::get<SaccadeCommand>(motion.commands[0].what);
  EXPECT_EQ(saccade.gaze_deg[1], -5);
  EXPECT_FALSE(saccade.gaze_deg[2].has_value());
  EXPECT_EQ(motion.commands[1], (MotionCommand{1, WalkToCommand{0.3, 0, 20}}));
  EXPECT_EQ(motion.commands[2], (MotionCommand{5, WalkCommand{0.05, 0, 0}}));
  EXPECT_NO_THROW(CheckMotion(motion, Robot("nao")));
}

TEST_F(MotionTest, WhatIsNotKnownIsRefusedWithItsPlace) {
  const auto refused = [this](const std::string& yaml, const std::string& place) {
    try {
      Read(yaml);
      ADD_FAILURE() << yaml;
    } catch (const ScenarioError& error) {
      EXPECT_THAT(error.what(), HasSubstr("motion.yaml:" + place)) << yaml;
    }
  };
  refused("commands:\n  - sacade: {pan_deg: 3}\n", "2:5");
  refused("commands:\n  - saccade: {pan: 3}\n", "2:15");
  refused("duration_s: 0\n", "1:13");
  refused("commands:\n  - saccade: {at_s: -1}\n", "2:21");
}

TEST_F(MotionTest, WhatARobotCannotDoIsRefused) {
  ExpectRefused("yorick", "commands: [{walk_to: {x_m: 1}}]", "cannot walk: robot nao can");
  ExpectRefused("koala", "commands: [{walk: {forward_m_s: 0.1}}]", "cannot walk");
  ExpectRefused("nao", "commands: [{drive: {forward_m_s: 0.1}}]", "has no wheels");
  ExpectRefused("nao", "commands: [{walk: {forward_m_s: 0.5}}]", "walk: forward_m_s = 0.5");
  ExpectRefused("koala", "commands: [{drive: {forward_m_s: 0.57, turn_deg_s: 10}}]",
                "it turns at 0.5715 m/s at most");
  ExpectRefused("koala", "commands: [{saccade: {neck_pan_deg: 3}}]", "has no such axis");
  ExpectRefused("koala", "commands: [{saccade: {pan_deg: 3, left_pan_deg: 3}}]",
                "give one or the other");
  ExpectRefused("nao", "commands: [{saccade: {pan_deg: 87, tilt_deg: 29}}]",
                "tilts from -19.0 to 11.6 deg");
  ExpectRefused("koala", "commands: [{saccade: {at_s: 1, pan_deg: 3}}]", "the motion ends at 1 s");
  try {
    CheckMotion({.duration_s = 601, .commands = {}}, Robot("koala"));
    ADD_FAILURE() << "too long";
  } catch (const hardware::ConfigError& error) {
    EXPECT_THAT(error.what(), HasSubstr("at most 600 s"));
  }
}

TEST_F(MotionTest, ASaccadeLeadsWhereTheGazeOrTheAxesSay) {
  const HeadReach koala(Robot("koala"));
  SaccadeCommand gaze;
  gaze.gaze_deg = {10, -5, std::nullopt};
  const hardware::HeadAngles turned = AnglesOf(gaze, {}, koala, "");
  EXPECT_NEAR(turned.left.pan_rad, 10 * kRadians, 1e-12);
  EXPECT_NEAR(turned.right.tilt_rad, -5 * kRadians, 1e-12);
  SaccadeCommand axes;
  axes.axis_deg[2] = 7;
  const hardware::HeadAngles one = AnglesOf(axes, {}, koala, "");
  EXPECT_NEAR(one.left.pan_rad, 7 * kRadians, 1e-12);
  EXPECT_EQ(one.right.pan_rad, 0);
}

TEST_F(MotionTest, WhatASaccadeLeavesOutStaysAsItWas) {
  for (const char* name : {"koala", "nao", "yorick"}) {
    const HeadReach reach(Robot(name));
    const double vergence_deg = std::string(name) == "nao" ? 0 : 4;
    const hardware::HeadAngles before = reach.AnglesOf({5, 12, vergence_deg});
    SaccadeCommand pan;
    pan.gaze_deg[0] = 15;
    EXPECT_EQ(hardware::ToArray(AnglesOf(pan, before, reach, "")),
              hardware::ToArray(reach.AnglesOf({15, 12, vergence_deg})))
        << name;
  }
  const HeadReach yorick(Robot("yorick"));
  SaccadeCommand axis;
  axis.axis_deg[2] = -3;
  const hardware::HeadAngles turned = AnglesOf(axis, yorick.AnglesOf({20, 10, 2}), yorick, "");
  EXPECT_NEAR(turned.left.pan_rad, -3 * kRadians, 1e-12);
  EXPECT_NEAR(turned.neck.pan_rad, 20 * kRadians, 1e-12);
  EXPECT_NEAR(turned.neck.tilt_rad, 10 * kRadians, 1e-12);
  EXPECT_NEAR(turned.right.pan_rad, 1 * kRadians, 1e-12);
}

TEST_F(MotionTest, WhatStaysIsHeldAgainstTheRobotToo) {
  const Motion motion = Read("commands: [{saccade: {pan_deg: 87}}]");
  EXPECT_NO_THROW(CheckMotion(motion, Robot("nao")));
  const hardware::HeadAngles down = HeadReach(Robot("nao")).AnglesOf({0, 29, 0});
  EXPECT_THROW(CheckMotion(motion, Robot("nao"), down), hardware::ConfigError);
}

TEST_F(MotionTest, EveryBadCommandIsNamed) {
  ExpectRefused("nao", "commands: [{drive: {}}, {walk: {at_s: 2, forward_m_s: 0.5}}]",
                "motion: at 0 s: drive");
  ExpectRefused("nao", "commands: [{drive: {}}, {walk: {at_s: 2, forward_m_s: 0.5}}]",
                "motion: at 2 s: walk: forward_m_s = 0.5");
  ExpectRefused("nao", "commands: [{drive: {}}, {walk: {at_s: 2, forward_m_s: 0.5}}]",
                "the motion ends at 1 s");
}

}  // namespace
}  // namespace horopter::scenarios
