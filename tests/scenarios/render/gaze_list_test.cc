// SPDX-License-Identifier: Apache-2.0
#include "scenarios/render/gaze_list.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "hardware/types/config_error.h"
#include "scenarios/dataset/format_error.h"
#include "scenarios/format/robot_description.h"

namespace horopter::scenarios {
namespace {

using testing::HasSubstr;

hardware::HeadLimits LimitsOf(const std::string& robot) {
  const std::filesystem::path scenes = HOROPTER_SOURCE_DIR "/scenes";
  return LoadRobotDescription(scenes / robot / "robot.yaml").head_limits;
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

TEST(DecodeGazes, ReadsRowsAndNamesTheLineOfABadOne) {
  const auto gazes = DecodeGazes("pan_deg,tilt_deg,vergence_deg\n1,2,3\n-4,0,0.5\n", "g.csv");
  ASSERT_EQ(gazes.size(), 2u);
  EXPECT_EQ(gazes[1].pan_deg, -4);
  EXPECT_EQ(gazes[1].vergence_deg, 0.5);
  EXPECT_THROW(DecodeGazes("pan_deg,tilt_deg,vergence_deg\n", "g.csv"), FormatError);
  EXPECT_THROW(DecodeGazes("pan,tilt\n1,2\n", "g.csv"), FormatError);
  try {
    DecodeGazes("pan_deg,tilt_deg,vergence_deg\n1,2,3\n1,left,3\n", "g.csv");
    FAIL();
  } catch (const FormatError& error) {
    EXPECT_THAT(error.what(), HasSubstr("g.csv:3"));
  }
}

TEST(SampleGazes, StaysWithinWhatEveryHeadCanDo) {
  GazeBounds wide;
  wide.pan_deg = {-170, 170};
  wide.tilt_deg = {-80, 80};
  wide.vergence_deg = {0, 60};
  for (const char* robot : {"koala", "nao", "yorick"}) {
    const hardware::HeadLimits limits = LimitsOf(robot);
    for (const Gaze& gaze : SampleGazes(wide.Within(limits), 300, 5)) {
      EXPECT_NO_THROW(AnglesOf(gaze, limits)) << robot;
    }
  }
}

TEST(SampleGazes, OneQuantityDoesNotDisturbAnother) {
  GazeBounds a;
  GazeBounds b = a;
  b.pan_deg = {-1, 1};
  const auto first = SampleGazes(a, 20, 9);
  const auto second = SampleGazes(b, 20, 9);
  for (std::size_t i = 0; i < first.size(); ++i) {
    EXPECT_EQ(first[i].tilt_deg, second[i].tilt_deg);
    EXPECT_EQ(first[i].vergence_deg, second[i].vergence_deg);
  }
  EXPECT_NE(SampleGazes(a, 1, 1)[0].pan_deg, SampleGazes(a, 1, 2)[0].pan_deg);
}

TEST(AnglesOf, ConvergingEyesTurnTowardsEachOtherOnEveryHeadThatCan) {
  const auto koala = AnglesOf({10, 5, 4}, LimitsOf("koala"));
  EXPECT_NEAR(koala.left.pan_rad, 8 * M_PI / 180, 1e-12);
  EXPECT_NEAR(koala.right.pan_rad, 12 * M_PI / 180, 1e-12);
  EXPECT_EQ(koala.neck.pan_rad, 0);
  const auto yorick = AnglesOf({10, 5, 4}, LimitsOf("yorick"));
  EXPECT_NEAR(yorick.neck.pan_rad, 10 * M_PI / 180, 1e-12);
  EXPECT_NEAR(yorick.left.pan_rad, -2 * M_PI / 180, 1e-12);
  EXPECT_THROW(AnglesOf({0, 0, 4}, LimitsOf("nao")), hardware::ConfigError);
  EXPECT_THROW(AnglesOf({100, 0, 0}, LimitsOf("yorick")), hardware::ConfigError);
}

}  // namespace
}  // namespace horopter::scenarios
