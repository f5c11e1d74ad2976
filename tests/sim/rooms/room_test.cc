// SPDX-License-Identifier: Apache-2.0
#include "sim/rooms/room.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "sim/oracle/collision_oracle.h"
#include "sim/rooms/free_path.h"
#include "sim/variation/footprint.h"
#include "sim/world/world.h"

namespace horopter::sim {
namespace {

using Eigen::Vector2d;
using testing::HasSubstr;

const std::filesystem::path kScenes = std::filesystem::path(HOROPTER_SOURCE_DIR) / "scenes/koala";

RoomConfig Config() {
  RoomConfig config;
  config.scene = kScenes / "empty_room.xml";
  config.goals_m = {{2.6, 0.2}};
  return config;
}

/// The robot driving along the path and turning at its corners, sampled finely.
std::vector<hardware::Pose> Drive(const std::vector<Vector2d>& path) {
  std::vector<hardware::Pose> poses;
  double heading = 0;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Vector2d way = path[i] - path[i - 1];
    const double next = std::atan2(way.y(), way.x());
    const double turn = hardware::WrapAngle(next - heading);
    for (int k = 0; k <= 10; ++k) {
      poses.push_back(
          hardware::ToPose({path[i - 1].x(), path[i - 1].y(), heading + turn * k / 10}));
    }
    heading = next;
    for (double along = 0; along < way.norm(); along += 0.02) {
      const Vector2d p = path[i - 1] + way.normalized() * along;
      poses.push_back(hardware::ToPose({p.x(), p.y(), heading}));
    }
  }
  return poses;
}

/// What the robot itself, not the circle round it, keeps from everything along the path.
double RobotsClearance(const Room& room) {
  const auto world = World::FromXml(room.mjcf);
  CollisionOracle oracle(world->model());
  oracle.Sync(world->data());
  return oracle.ClearanceAlong(world->Id(mjOBJ_BODY, "base"), Drive(room.path)).nearest.distance_m;
}

TEST(Room, FiftySeedsHaveTheirPathWithItsClearanceAndAFreeStart) {
  const RoomConfig config = Config();
  std::set<std::size_t> counts;
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    const Room room = GenerateRoom(config, seed);
    counts.insert(room.obstacles.size());
    ASSERT_GE(room.path.size(), 2u) << seed;
    EXPECT_EQ(room.path.front(), Vector2d(0, 0)) << seed;
    EXPECT_EQ(room.path.back(), config.goals_m.back()) << seed;
    EXPECT_GE(room.path_clearance_m, config.clearance_m - 1e-3) << seed;
    EXPECT_GE(room.path_length_m, config.goals_m[0].norm()) << seed;
    // Independent of the search: the robot's own shape, driven along the path.
    EXPECT_GE(RobotsClearance(room), config.clearance_m) << seed;
  }
  EXPECT_EQ(*counts.begin(), 4u);
  EXPECT_EQ(*counts.rbegin(), 9u);
}

TEST(Room, ObstaclesStandOnTheFloorAndTouchNothing) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const auto world = World::FromXml(GenerateRoom(Config(), seed).mjcf);
    const mjModel& model = world->model();
    std::vector<Footprint> others;
    CollisionOracle oracle(model);
    oracle.Sync(world->data());
    for (int a = 0; a < model.ngeom; ++a) {
      const std::string body = world->Name(mjOBJ_BODY, model.geom_bodyid[a]);
      if (!body.starts_with("obstacle_")) continue;
      EXPECT_NEAR(FootprintOf(*world, a).center().norm(), 1.6, 4) << "within the room";
      for (int b = 0; b < model.ngeom; ++b) {
        const bool solid = model.geom_contype[b] != 0 || model.geom_conaffinity[b] != 0;
        if (!solid || model.geom_bodyid[a] == model.geom_bodyid[b]) continue;
        if (world->Name(mjOBJ_GEOM, b) == "floor") {
          EXPECT_GT(oracle.Distance(a, b), -1e-9) << body;
        } else {
          EXPECT_GT(oracle.Distance(a, b), 0.07) << seed << " " << body << " " << b;
        }
      }
    }
  }
}

TEST(Room, TheFirstObstacleStandsInTheStraightWay) {
  int in_the_way = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const Room room = GenerateRoom(Config(), seed);
    in_the_way += room.path_length_m > (Config().goals_m[0]).norm() + 0.02;
  }
  EXPECT_GE(in_the_way, 9);
}

TEST(Room, BlockedRoomsHaveNoWayEvenForTheRobotsCore) {
  RoomConfig config = Config();
  config.free_path = false;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const Room room = GenerateRoom(config, seed);
    EXPECT_TRUE(room.path.empty());
    // A free room of the same scene does have one: it is the barrier that blocks.
    EXPECT_TRUE(std::any_of(room.obstacles.begin(), room.obstacles.end(),
                            [](const Obstacle& o) { return o.shape == "screen"; }));
    // Flood by the robot itself, standing upright at every heading of 12, on a grid of 0.1 m.
    const auto world = World::FromXml(room.mjcf);
    CollisionOracle oracle(world->model());
    oracle.Sync(world->data());
    const int base = world->Id(mjOBJ_BODY, "base");
    std::set<std::pair<int, int>> seen{{0, 0}};
    std::vector<std::pair<int, int>> open{{0, 0}};
    const double cell = 0.1;
    while (!open.empty()) {
      const auto [i, k] = open.back();
      open.pop_back();
      EXPECT_GT((Vector2d(i, k) * cell - config.goals_m[0]).norm(), 0.1) << seed;
      for (const auto& [di, dk] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
        const std::pair next{i + di, k + dk};
        const Vector2d p = Vector2d(next.first, next.second) * cell;
        if (std::abs(p.x() - 1.6) > 2.6 || std::abs(p.y()) > 2.6 || !seen.insert(next).second)
          continue;
        bool stands = false;
        for (int h = 0; h < 6 && !stands; ++h) {
          const hardware::Pose X = hardware::ToPose({p.x(), p.y(), h * M_PI / 6});
          ClearanceOptions near;
          near.max_distance_m = 0.2;
          stands = oracle.ClearanceAlong(base, {&X, 1}, near).nearest.distance_m > 0;
        }
        if (stands) open.push_back(next);
      }
    }
    EXPECT_GT(seen.size(), 50u) << "the flood went somewhere";
  }
}

TEST(Room, SameSeedGivesTheSameRoomAndAnotherSeedAnother) {
  const Room a = GenerateRoom(Config(), 3), b = GenerateRoom(Config(), 3);
  EXPECT_EQ(a.mjcf, b.mjcf);
  EXPECT_EQ(a.path, b.path);
  EXPECT_NE(a.mjcf, GenerateRoom(Config(), 4).mjcf);
}

TEST(Room, EachAspectHasAStreamOfItsOwn) {
  const Room plain = GenerateRoom(Config(), 5);
  const auto shapes = [](const Room& room) {
    std::vector<std::string> all;
    for (const Obstacle& o : room.obstacles) all.push_back(o.shape + " " + o.surface);
    return all;
  };
  const auto places = [](const Room& room) {
    std::vector<double> all;
    for (const Obstacle& o : room.obstacles) all.insert(all.end(), {o.X_WO.x_m, o.X_WO.y_m});
    return all;
  };
  RoomConfig lit = Config();
  lit.lighting = "evening";
  const Room evening = GenerateRoom(lit, 5);
  EXPECT_EQ(places(evening), places(plain));
  EXPECT_EQ(shapes(evening), shapes(plain));
  EXPECT_EQ(evening.surfaces, plain.surfaces);

  RoomConfig built = Config();
  built.vary_surfaces = false;
  const Room as_built = GenerateRoom(built, 5);
  EXPECT_TRUE(as_built.surfaces.empty());
  EXPECT_EQ(places(as_built), places(plain));
  EXPECT_EQ(as_built.lighting.name, plain.lighting.name);

  RoomConfig more = Config();
  more.min_obstacles = more.max_obstacles = static_cast<int>(plain.obstacles.size()) + 1;
  const auto longer = shapes(GenerateRoom(more, 5));
  ASSERT_EQ(longer.size(), plain.obstacles.size() + 1);
  EXPECT_TRUE(std::equal(longer.begin(), longer.end() - 1, shapes(plain).begin()));
}

TEST(Room, EveryLightingComesAndChangesEveryLight) {
  std::set<std::string> drawn;
  SceneDocument as_built(Config().scene);
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SceneDocument scene(as_built);
    drawn.insert(ApplyLighting(scene, "varied", seed).name);
    for (const char* name : {"lamp", "window", "bounce"}) {
      EXPECT_STRNE(scene.Find("light", name).attribute("diffuse").value(),
                   as_built.Find("light", name).attribute("diffuse").value());
    }
  }
  EXPECT_THAT(drawn, testing::UnorderedElementsAreArray(LightingNames()));
}

TEST(Room, FloorsShapesAndFurnitureVary) {
  std::set<std::string> floors, shapes;
  std::set<double> cupboards;
  for (std::uint64_t seed = 1; seed <= 15; ++seed) {
    const Room room = GenerateRoom(Config(), seed);
    floors.insert(room.surfaces.at("floor"));
    for (const Obstacle& o : room.obstacles) shapes.insert(o.shape);
    const auto world = World::FromXml(room.mjcf);
    cupboards.insert(world->X_WBody("cupboard").translation().x());
    EXPECT_LE(std::abs(world->X_WBody("cupboard").translation().x() - 3.0), 0.3);
    EXPECT_EQ(world->X_WBody("cupboard").translation().y(), 2.37) << "stays at its wall";
  }
  EXPECT_GT(floors.size(), 5u);
  EXPECT_EQ(shapes.size(), 7u);
  EXPECT_GT(cupboards.size(), 8u);
}

TEST(Room, AsBuiltIsTheSceneWithObstacles) {
  RoomConfig config = Config();
  config.lighting = "as_built";
  config.vary_surfaces = config.vary_furniture = false;
  config.min_obstacles = config.max_obstacles = 0;
  const Room room = GenerateRoom(config, 1);
  const World scene(config.scene);
  const auto world = World::FromXml(room.mjcf);
  ASSERT_EQ(world->model().ngeom, scene.model().ngeom);
  for (int i = 0; i < 3 * scene.model().ngeom; ++i) {
    EXPECT_EQ(world->data().geom_xpos[i], scene.data().geom_xpos[i]);
  }
  EXPECT_EQ(room.path.size(), 2u) << "straight";
}

TEST(Room, GoalsAreInTheStartingFrame) {
  RoomConfig config = Config();
  config.start_turn_rad = 0.1;
  const Room room = GenerateRoom(config, 6);
  const Eigen::Rotation2Dd R(0.1);
  EXPECT_LT((room.path.back() - R * config.goals_m[0]).norm(), 1e-12);
}

TEST(Room, LeadsOverSeveralGoals) {
  RoomConfig config = Config();
  config.goals_m = {{2.2, -0.4}, {1.2, 1.0}, {0, 0}};
  const Room room = GenerateRoom(config, 2);
  for (const Vector2d& goal : config.goals_m) {
    EXPECT_TRUE(std::find(room.path.begin(), room.path.end(), goal) != room.path.end());
  }
  EXPECT_GE(RobotsClearance(room), config.clearance_m);
}

template <typename Error>
std::string ErrorOf(const RoomConfig& config) {
  try {
    GenerateRoom(config, 1);
  } catch (const Error& error) {
    return error.what();
  }
  return "no such error";
}

TEST(Room, RefusesWhatCannotBe) {
  RoomConfig config = Config();
  config.min_obstacles = 5;
  config.max_obstacles = 3;
  config.clearance_m = 0;
  config.lighting = "disco";
  const std::string errors = ErrorOf<hardware::ConfigError>(config);
  EXPECT_THAT(errors, HasSubstr("room.max_obstacles = 3"));
  EXPECT_THAT(errors, HasSubstr("room.clearance_m = 0"));
  EXPECT_THAT(errors, HasSubstr("room.lighting = disco"));

  config = Config();
  config.goals_m = {{4.1, 0}};
  EXPECT_THAT(ErrorOf<hardware::ConfigError>(config), HasSubstr("start or goal at (4.100, 0.000)"));
  config = Config();
  config.min_obstacles = config.max_obstacles = 30;
  config.clearance_m = 0.5;
  EXPECT_THAT(ErrorOf<hardware::ConfigError>(config), HasSubstr("ask for fewer obstacles"));
  config = Config();
  config.scene = kScenes / "room.xml";
  EXPECT_THAT(ErrorOf<SceneError>(config), HasSubstr("without obstacles"));
}

}  // namespace
}  // namespace horopter::sim
