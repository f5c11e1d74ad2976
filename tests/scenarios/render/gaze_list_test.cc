// SPDX-License-Identifier: Apache-2.0
#include "scenarios/render/gaze_list.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "hardware/types/config_error.h"
#include "scenarios/format/robot_description.h"

namespace horopter::scenarios {
namespace {

HeadReach ReachOf(const std::string& robot) {
  const std::filesystem::path scenes = HOROPTER_SOURCE_DIR "/scenes";
  return HeadReach(LoadRobotDescription(scenes / robot / "robot.yaml"));
}

TEST(ParseInterval, ReadsANumberOrTwo) {
  EXPECT_EQ(ParseInterval("--pan", "-3.5").low, -3.5);
  EXPECT_EQ(ParseInterval("--pan", "-3.5").high, -3.5);
  EXPECT_EQ(ParseInterval("--pan", "-10:20").low, -10);
  EXPECT_EQ(ParseInterval("--pan", "-10:20").high, 20);
  for (const char* bad : {"", "x", "1:", ":2", "3:1", "1:2:3", "1 2", "1:2x", "5x"}) {
    EXPECT_THROW(ParseInterval("--pan", bad), hardware::ConfigError) << bad;
  }
}

TEST(SampleGazes, StaysWithinWhatEveryHeadCanDo) {
  GazeBounds wide;
  wide.pan_deg = {-170, 170};
  wide.tilt_deg = {-80, 80};
  wide.vergence_deg = {0, 60};
  for (const char* robot : {"koala", "nao", "yorick"}) {
    const HeadReach reach = ReachOf(robot);
    for (const Gaze& gaze : SampleGazes(wide, 300, 5, reach)) {
      EXPECT_NO_THROW(reach.AnglesOf(gaze)) << robot;
    }
  }
}

TEST(SampleGazes, OneQuantityDoesNotDisturbAnother) {
  GazeBounds a;
  GazeBounds b = a;
  b.pan_deg = {-1, 1};
  const HeadReach reach = ReachOf("yorick");
  const auto first = SampleGazes(a, 20, 9, reach);
  const auto second = SampleGazes(b, 20, 9, reach);
  for (std::size_t i = 0; i < first.size(); ++i) {
    EXPECT_EQ(first[i].tilt_deg, second[i].tilt_deg);
    EXPECT_EQ(first[i].vergence_deg, second[i].vergence_deg);
  }
  EXPECT_NE(SampleGazes(a, 1, 1, reach)[0].pan_deg, SampleGazes(a, 1, 2, reach)[0].pan_deg);
}

TEST(SampleGazes, TiltsOfTheNaoAreThoseThatItsShouldersAllow) {
  GazeBounds aside;
  aside.pan_deg = {80, 95};
  aside.tilt_deg = {5, 29};
  aside.vergence_deg = {0, 0};
  const HeadReach reach = ReachOf("nao");
  double highest = 0;
  for (const Gaze& gaze : SampleGazes(aside, 200, 2, reach)) {
    EXPECT_LE(gaze.tilt_deg, reach.NeckTiltAt(gaze.pan_deg).high);
    EXPECT_GE(gaze.tilt_deg, 5);
    highest = std::max(highest, gaze.tilt_deg);
  }
  EXPECT_GT(highest, 11) << "the range there is was not used";
  aside.tilt_deg = {25, 29};
  EXPECT_THROW(SampleGazes(aside, 1, 2, reach), hardware::ConfigError);
  aside.pan_deg = {0, 90};  // the pans drawn again are those near 0
  for (const Gaze& gaze : SampleGazes(aside, 50, 2, reach)) EXPECT_LT(gaze.pan_deg, 25);
}

}  // namespace
}  // namespace horopter::scenarios
