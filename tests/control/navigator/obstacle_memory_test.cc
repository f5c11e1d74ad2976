// SPDX-License-Identifier: Apache-2.0
#include "control/navigator/obstacle_memory.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/control/navigator/toy_world.h"

namespace horopter::control {
namespace {

using hardware::Pose2;
using hardware::Time;
using std::chrono::seconds;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

SceneView ViewOf(Time t, int obstacle_px, int floor_px, cv::Vec3f where) {
  SceneView view;
  view.t_capture = t;
  view.obstacles_B = cv::Mat3f(1, 100, cv::Vec3f::all(kNan));
  view.floor_B = view.obstacles_B.clone();
  view.obstacles_B.colRange(0, obstacle_px).setTo(where);
  view.floor_B.colRange(obstacle_px, obstacle_px + floor_px).setTo(where);
  return view;
}

TEST(ObstacleMemory, RemembersWhatWasSeenWhenTheRobotHasTurnedAway) {
  ObstacleMemory memory({});
  const ToyWorld world({{{1, 0}, 0.15}});
  memory.Add(world.View({}, {}, 0), {});
  ASSERT_GT(memory.size(), 3u);
  const Pose2 turned{0.2, 0.1, M_PI / 2};
  memory.Add(world.View(Time(seconds(1)), turned, 0), turned);
  double nearest = 10;
  for (const auto& p : memory.PointsInBase(turned)) {
    nearest = std::min(nearest, p.norm());
    EXPECT_LT(p.y(), 0);  // now on the right
  }
  // The near face stands at x = 0.85, 0.65 m to the right and 0.1 m behind.
  EXPECT_NEAR(nearest, std::hypot(0.65, 0.1), 0.05);
}

TEST(ObstacleMemory, ForgetsAfterItsTime) {
  ObstacleMemoryConfig config;
  config.keep_s = 5;
  ObstacleMemory memory(config);
  memory.Add(ViewOf({}, 10, 0, {1, 0, 0.2f}), {});
  memory.Add(ViewOf(Time(seconds(5)), 0, 0, {}), {});
  EXPECT_EQ(memory.size(), 1u);
  memory.Add(ViewOf(Time(seconds(6)), 0, 0, {}), {});
  EXPECT_EQ(memory.size(), 0u);
}

TEST(ObstacleMemory, FewPixelsAreNotRemembered) {
  ObstacleMemory memory({});
  memory.Add(ViewOf({}, 7, 0, {1, 0, 0.2f}), {});
  EXPECT_EQ(memory.size(), 0u);
}

TEST(ObstacleMemory, FloorSeenInACellClearsIt) {
  ObstacleMemory memory({});
  memory.Add(ViewOf({}, 10, 0, {0.5f, 0, 0.2f}), {});
  ASSERT_EQ(memory.size(), 1u);
  memory.Add(ViewOf(Time(seconds(1)), 0, 7, {0.5f, 0, 0}), {});
  EXPECT_EQ(memory.size(), 1u);
  memory.Add(ViewOf(Time(seconds(1)), 0, 8, {0.5f, 0, 0}), {});
  EXPECT_EQ(memory.size(), 0u);
}

TEST(ObstacleMemory, NoisyFloorIsNotAnObstacle) {
  ObstacleMemory memory({});
  memory.Add(ViewOf({}, 10, 21, {0.5f, 0, 0.04f}), {});
  EXPECT_EQ(memory.size(), 0u);
  memory.Add(ViewOf({}, 10, 20, {0.5f, 0, 0.04f}), {});
  EXPECT_EQ(memory.size(), 1u);
}

TEST(ObstacleMemory, SeeingPastAFarCellClearsItButNotANearOne) {
  for (const bool far : {true, false}) {
    ObstacleMemory memory({});
    memory.Add(ViewOf({}, 10, 0, {far ? 1.2f : 0.6f, 0, 0.2f}), {});
    memory.Add(ViewOf(Time(seconds(1)), 10, 0, {1.8f, 0, 0.2f}), {});
    EXPECT_EQ(memory.size(), far ? 1u : 2u);
  }
}

TEST(ObstacleMemory, FarCellsCountOnceTwoViewsHaveSeenThem) {
  ObstacleMemoryConfig config;
  config.confirm_beyond_m = 0.6;
  ObstacleMemory memory(config);
  memory.Add(ViewOf({}, 10, 0, {0.5f, 0, 0.2f}), {});
  EXPECT_EQ(memory.PointsInBase({}).size(), 1u);  // near: at once
  memory.Add(ViewOf(Time(seconds(1)), 10, 0, {1, 0, 0.2f}), {});
  EXPECT_EQ(memory.PointsInBase({}).size(), 1u);
  EXPECT_EQ(memory.PointsInBase({}, ObstacleMemory::Certainty::kAny).size(), 2u);
  memory.Add(ViewOf(Time(seconds(2)), 10, 0, {1.05f, 0, 0.2f}), {});  // two cells further
  EXPECT_EQ(memory.PointsInBase({}).size(), 2u);
  memory.Add(ViewOf(Time(seconds(3)), 10, 0, {1.4f, 0.5f, 0.2f}), {});  // elsewhere
  EXPECT_EQ(memory.PointsInBase({}).size(), 2u);
}

TEST(ObstacleMemory, ValidateNamesEveryBadField) {
  EXPECT_TRUE(ObstacleMemoryConfig{}.Validate().empty());
  EXPECT_EQ((ObstacleMemoryConfig{0, -1, 0, 0, -1}.Validate().size()), 5u);
  EXPECT_THROW(ObstacleMemory({0, -1, 0, 0, -1}), hardware::ConfigError);
}

}  // namespace
}  // namespace horopter::control
