// SPDX-License-Identifier: Apache-2.0
#include "scenarios/runner/stack_config.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "scenarios/format/scenes.h"

namespace horopter::scenarios {
namespace {

class StackRecordTest : public testing::Test {
 protected:
  nlohmann::json Record() const { return nlohmann::json::parse(StackRecord(scenario_, robot_)); }

  Scenario scenario_;
  RobotDescription robot_ = LoadRobotDescription(RobotFile(ScenesDir(), "koala"));
};

TEST_F(StackRecordTest, HoldsTheNumbersThatAreInForceNotTheDefaults) {
  scenario_.navigation.obstacle_limit_m = 1.75;
  scenario_.vision.scales = 3;
  robot_.height_m = 0.5;
  const nlohmann::json record = Record();
  EXPECT_EQ(record.at("navigator").at("obstacle_distance_m"), 1.75);
  EXPECT_EQ(record.at("navigator").at("strips").at("corridor_half_width_m"),
            NavigatorConfigOf(scenario_, robot_).strips.corridor_half_width_m);
  EXPECT_EQ(record.at("disparity").at("scales"), 3);
  EXPECT_EQ(record.at("obstacles").at("robot_height_m"), ObstacleConfigOf(robot_).robot_height_m);
  EXPECT_GT(record.at("obstacles").at("robot_height_m"), 0.5);
  EXPECT_EQ(record.at("robot").at("height_m"), 0.5);
  EXPECT_EQ(record.at("robot").at("head").at("baseline_m"), robot_.head_geometry.baseline_m);
  EXPECT_GT(record.at("reconstruction").at("min_parallax_rad"), 0.0);
}

TEST_F(StackRecordTest, OfTheSameStackIsTheSameText) {
  const std::string record = StackRecord(scenario_, robot_);
  EXPECT_EQ(StackRecord(scenario_, robot_), record);
  scenario_.seed = 9;  // moves the world, not the stack
  EXPECT_EQ(StackRecord(scenario_, robot_), record);
  scenario_.navigation.rule = "paper";
  EXPECT_NE(StackRecord(scenario_, robot_), record);
}

TEST_F(StackRecordTest, SaysInfinityInWords) {
  scenario_.navigation.rule = "paper";
  const double beyond = NavigatorConfigOf(scenario_, robot_).memory.confirm_beyond_m;
  const nlohmann::json recorded = Record().at("navigator").at("memory").at("confirm_beyond_m");
  EXPECT_EQ(recorded, std::isinf(beyond) ? nlohmann::json("inf") : nlohmann::json(beyond));
}

}  // namespace
}  // namespace horopter::scenarios
