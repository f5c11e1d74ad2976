// SPDX-License-Identifier: Apache-2.0
#include "scenarios/render/pose_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "hardware/types/config_error.h"
#include "scenarios/dataset/format_error.h"

namespace horopter::scenarios {
namespace {

using testing::HasSubstr;

HeadReach ReachOf(const std::string& robot) {
  const std::filesystem::path scenes = HOROPTER_SOURCE_DIR "/scenes";
  return HeadReach(LoadRobotDescription(scenes / robot / "robot.yaml"));
}

/// What is wrong with a table for a robot.
std::string Complaint(const std::string& csv, const std::string& robot = "koala") {
  try {
    ViewsOf(DecodePoseTable(csv, "p.csv"), ReachOf(robot));
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

TEST(PoseTable, ReadsGazesInAnyOrderOfColumns) {
  const PoseTable table = DecodePoseTable("vergence_deg,pan_deg\n4,10\n0,-3.5\n", "p.csv");
  EXPECT_EQ(table.columns, (std::vector<std::string>{"vergence_deg", "pan_deg"}));
  const auto views = ViewsOf(table, ReachOf("koala"));
  ASSERT_EQ(views.size(), 2u);
  EXPECT_NEAR(views[0].head.left.pan_rad, 8 * M_PI / 180, 1e-12);
  EXPECT_NEAR(views[0].head.right.pan_rad, 12 * M_PI / 180, 1e-12);
  EXPECT_EQ(views[1].head.left.tilt_rad, 0);
  EXPECT_TRUE(views[0].bodies.empty());
}

TEST(PoseTable, IndependentEyesHaveAColumnPerAxis) {
  const auto koala =
      ViewsOf(DecodePoseTable("left_pan_deg,left_tilt_deg,right_pan_deg,right_tilt_deg\n"
                              "-5,10,20,-15\n",
                              "p.csv"),
              ReachOf("koala"))[0]
          .head;
  EXPECT_NEAR(koala.left.pan_rad, -5 * M_PI / 180, 1e-12);
  EXPECT_NEAR(koala.left.tilt_rad, 10 * M_PI / 180, 1e-12);
  EXPECT_NEAR(koala.right.pan_rad, 20 * M_PI / 180, 1e-12);
  EXPECT_NEAR(koala.right.tilt_rad, -15 * M_PI / 180, 1e-12);
  const auto yorick =
      ViewsOf(DecodePoseTable("neck_pan_deg,neck_tilt_deg,left_pan_deg,right_pan_deg\n"
                              "30,-10,-2,7\n",
                              "p.csv"),
              ReachOf("yorick"))[0]
          .head;
  EXPECT_NEAR(yorick.neck.pan_rad, 30 * M_PI / 180, 1e-12);
  EXPECT_NEAR(yorick.left.pan_rad, -2 * M_PI / 180, 1e-12);
  EXPECT_NEAR(yorick.right.pan_rad, 7 * M_PI / 180, 1e-12);
}

TEST(PoseTable, BodiesHaveAColumnPerPartOfTheirPose) {
  const auto views = ViewsOf(
      DecodePoseTable("pan_deg,board.x_m,board.y_m,board.z_m,board.roll_deg,my.cup.x_m,my.cup.y_m,"
                      "my.cup.z_m\n0,1,2,3,15,4,5,6\n",
                      "p.csv"),
      ReachOf("koala"));
  EXPECT_EQ(views[0].bodies.at("board"), (BodyPlacement{{1, 2, 3}, 0, 0, 15}));
  EXPECT_EQ(views[0].bodies.at("my.cup"), (BodyPlacement{{4, 5, 6}, 0, 0, 0}));
}

TEST(PoseTable, SaysWhatIsWrongAndWhere) {
  EXPECT_THAT(Complaint(""), HasSubstr("p.csv"));
  EXPECT_THAT(Complaint("pan_deg\n"), HasSubstr("no pose in it"));
  EXPECT_THAT(Complaint("pan_deg\n1\nleft\n"), HasSubstr("p.csv:3: 'left' is no number"));
  EXPECT_THAT(Complaint("pan_deg\nnan\n"), HasSubstr("p.csv:2: 'nan' is not finite"));
  EXPECT_THAT(Complaint("pan_dge\n1\n"), HasSubstr("did you mean 'pan_deg'?"));
  EXPECT_THAT(Complaint("pan_deg,pan_deg\n1,1\n"), HasSubstr("stands twice"));
  EXPECT_THAT(Complaint("pan_deg,left_pan_deg\n1,1\n"), HasSubstr("one or the other"));
  EXPECT_THAT(Complaint("board.x_m,board.z_m\n1,1\n"), HasSubstr("lacks y_m"));
  EXPECT_THAT(Complaint("board.yaw\n1\n"), HasSubstr("did you mean 'yaw_deg'?"));
  EXPECT_THAT(Complaint("pan_deg\n1\n200\n"), testing::StartsWith("p.csv:3: gaze"));
  EXPECT_THAT(Complaint("left_tilt_deg\n60\n"), HasSubstr("must be from -31.0 to 46.6"));
  EXPECT_THAT(Complaint("pan_deg,tilt_deg\n87,29\n", "nao"), HasSubstr("p.csv:2: tilt"));
}

}  // namespace
}  // namespace horopter::scenarios
