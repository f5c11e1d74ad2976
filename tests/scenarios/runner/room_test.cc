// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "scenarios/format/scenario_format.h"
#include "scenarios/format/scenes.h"
#include "scenarios/runner/run_process.h"
#include "sim/world/world.h"

namespace horopter::scenarios {
namespace {

namespace fs = std::filesystem;

/// The first tenths of a second in a generated room.
constexpr const char* kRoom = R"(
scene: koala/empty_room.xml
time_limit_s: 0.5
seed: 4
room: {min_obstacles: 3, max_obstacles: 5}
camera: {width: 160, height: 120}
vision: {scales: 4, rate_hz: 4, latency_s: 0.2}
steps:
  - goto: {x_m: 2.5, y_m: 0.3, timeout_s: 0.4}
expect:
  - contacts 0
)";

class RoomScenario : public testing::Test {
 protected:
  fs::path Folder(const std::string& name) const {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    return fs::path(testing::TempDir()) / "horopter_room" / info->name() / name;
  }

  RunSummary Play(const Scenario& scenario, const std::string& name) const {
    RunProcess process(scenario, Folder(name), std::nullopt);
    while (process.Poll()) {
    }
    return process.Finish().summary;
  }

  nlohmann::json Record(const std::string& name) const {
    return nlohmann::json::parse(std::ifstream(Folder(name) / "room.json"));
  }

  Scenario room_ = ParseScenarioText(kRoom, "room.yaml", {ScenesDir()});
};

TEST_F(RoomScenario, IsRecordedWithWhatStandsWhere) {
  Play(room_, "run");
  const nlohmann::json record = Record("run");
  EXPECT_GE(record["obstacles"].size(), 3u);
  EXPECT_LE(record["obstacles"].size(), 5u);
  EXPECT_GE(record["clearance_m"], 0.349);
  EXPECT_GE(record["path_length_m"], 2.5);
  const sim::World world(Folder("run") / "room.xml");
  for (const auto& obstacle : record["obstacles"]) {
    const Eigen::Vector3d p = world.X_WBody(obstacle["name"].get<std::string>()).translation();
    EXPECT_NEAR(p.x(), obstacle["x_m"], 1e-12);
    EXPECT_NEAR(p.y(), obstacle["y_m"], 1e-12);
  }
  // The path ends at the goal, which the robot knows from its own, turned start.
  const auto end = record["path_m"].back();
  EXPECT_NEAR(std::hypot(end[0].get<double>(), end[1].get<double>()), std::hypot(2.5, 0.3), 1e-9);
}

TEST_F(RoomScenario, PlaysTheSameAgainFromTheResolvedScenario) {
  const RunSummary first = Play(room_, "first");
  const Scenario resolved = ParseScenario(Folder("first") / "scenario.yaml", {ScenesDir()});
  const RunSummary again = Play(resolved, "again");
  EXPECT_EQ(first.image_hash, again.image_hash);
  EXPECT_EQ(first.decision_hash, again.decision_hash);
  EXPECT_EQ(Record("first"), Record("again"));
}

TEST_F(RoomScenario, AnotherSeedIsAnotherRoom) {
  Play(room_, "four");
  room_.seed = 5;
  Play(room_, "five");
  EXPECT_NE(Record("four")["obstacles"], Record("five")["obstacles"]);
}

TEST_F(RoomScenario, BlockedRoomsSaySo) {
  room_.room->path = "blocked";
  Play(room_, "run");
  EXPECT_EQ(Record("run")["path"], "blocked");
  EXPECT_TRUE(Record("run")["path_length_m"].is_null());
}

TEST_F(RoomScenario, AGoalInTheWallIsBadInput) {
  std::get<GotoStep>(room_.steps[0].action).goal_m.x() = 4.15;
  const RunSummary run = Play(room_, "run");
  EXPECT_EQ(run.outcome, Outcome::kError);
  EXPECT_THAT(run.error, testing::HasSubstr("off the walls and the furniture"));
}

}  // namespace
}  // namespace horopter::scenarios
