// SPDX-License-Identifier: Apache-2.0
#include "sim/rooms/room.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>

#include "sim/oracle/collision_oracle.h"
#include "sim/random/random_stream.h"
#include "sim/rooms/floor_plan.h"
#include "sim/rooms/free_path.h"
#include "sim/rooms/furniture.h"
#include "sim/rooms/robot_envelope.h"
#include "sim/rooms/surfaces.h"
#include "sim/world/world.h"

namespace horopter::sim {
namespace {

using Eigen::Vector2d;

constexpr const char* kBase = "base";
constexpr const char* kOuterProbe = "room_probe_outer";
constexpr const char* kCoreProbe = "room_probe_core";
constexpr double kCell_m = 0.05;
constexpr int kMostAttempts = 100;

void RequireEmpty(SceneDocument& scene, const RoomConfig& config) {
  for (const pugi::xml_node body : scene.Elements("body")) {
    const std::string_view name = body.attribute("name").value();
    if (!name.starts_with("obstacle_")) continue;
    throw SceneError(fmt::format(
        "scene '{}' has a body '{}': a procedural room starts from a scene without obstacles, "
        "e.g. koala/empty_room.xml",
        config.scene.string(), name));
  }
}

/// The scene with obstacles that can be moved about, and the question whether there is a way.
class Searcher {
 public:
  Searcher(SceneDocument scene, const FloorPlan& plan, const RobotEnvelope& robot,
           const std::vector<Obstacle>& obstacles)
      : world_(World::FromXml(WithEverything(scene, robot, obstacles))),
        oracle_(world_->model()),
        outer_(oracle_, world_->Id(mjOBJ_BODY, kOuterProbe), plan.floor, kCell_m),
        core_(oracle_, world_->Id(mjOBJ_BODY, kCoreProbe), plan.floor, kCell_m) {}

  void Arrange(const std::vector<Obstacle>& obstacles) {
    for (const Obstacle& o : obstacles) world_->PlaceBody(o.name, hardware::ToPose(o.X_WO));
    oracle_.Sync(world_->data());
  }

  /// Over all the places of the way, or nothing.
  std::optional<std::vector<Vector2d>> FreePath(const std::vector<Vector2d>& way,
                                                double clearance_m) const {
    std::vector<Vector2d> whole{way.front()};
    for (std::size_t leg = 0; leg + 1 < way.size(); ++leg) {
      const auto path = outer_.Find(way[leg], way[leg + 1], clearance_m);
      if (!path) return std::nullopt;
      whole.insert(whole.end(), path->begin() + 1, path->end());
    }
    return whole;
  }

  bool Blocked(const std::vector<Vector2d>& way) const { return core_.Blocked(way[0], way[1]); }
  double ClearanceAlong(const std::vector<Vector2d>& path) const {
    return outer_.ClearanceAlong(path);
  }

 private:
  static std::string WithEverything(SceneDocument& scene, const RobotEnvelope& robot,
                                    const std::vector<Obstacle>& obstacles) {
    for (std::size_t i = 0; i < obstacles.size(); ++i) {
      Obstacle apart = obstacles[i];  // before it has a place, it must touch nothing
      apart.X_WO = {-20, -2.0 * static_cast<double>(i), 0};
      AddObstacle(scene, apart);
    }
    AddProbe(scene, kOuterProbe, robot.outer);
    AddProbe(scene, kCoreProbe, robot.core);
    return scene.Text();
  }

  std::unique_ptr<World> world_;
  CollisionOracle oracle_;
  PathSearch outer_;
  PathSearch core_;
};

void RequirePlacesInside(const FloorPlan& plan, const Scatter& scatter, double radius_m,
                         double clearance_m) {
  std::vector<hardware::FieldError> errors;
  for (const Vector2d& p : scatter.way) {
    if (plan.Fits({p, radius_m}, clearance_m)) continue;
    errors.push_back(
        {"room", fmt::format("start or goal at ({:.3f}, {:.3f}) m in W", p.x(), p.y()),
         fmt::format("must be {:.3f} m off the walls and the furniture", radius_m + clearance_m)});
  }
  hardware::ThrowIfAny(std::move(errors));
}

/// Start and goals in W.
std::vector<Vector2d> WayOf(const RoomConfig& config, const World& shell) {
  hardware::Pose2 start = hardware::ToPose2(shell.X_WBody(kBase));
  start.heading_rad += config.start_turn_rad;
  const hardware::Pose X_WO = hardware::ToPose(start);
  std::vector<Vector2d> way{X_WO.translation().head<2>()};
  for (const Vector2d& goal : config.goals_m) {
    way.emplace_back((X_WO * Eigen::Vector3d(goal.x(), goal.y(), 0)).head<2>());
  }
  return way;
}

std::vector<Obstacle> DrawObstacles(const RoomConfig& config, std::uint64_t seed) {
  RandomStream random(seed, "room.count");
  const auto count =
      static_cast<int>(random.Uniform(config.min_obstacles, config.max_obstacles + 1.0));
  std::vector<Obstacle> obstacles;
  for (int i = 1; i <= count; ++i) obstacles.push_back(DrawObstacle(i, seed));
  return obstacles;
}

[[noreturn]] void ThrowNoLayout(const RoomConfig& config, std::size_t obstacles) {
  throw hardware::ConfigError(
      {{"room", fmt::format("{} obstacles, clearance_m = {:g}", obstacles, config.clearance_m),
        fmt::format("must leave room for such a layout, and {} drawn at random had none; ask for "
                    "fewer obstacles, less clearance or another goal",
                    kMostAttempts)}});
}

/// Draws places until a path over all goals has its clearance.
void LeaveAWay(const RoomConfig& config, std::uint64_t seed, const FloorPlan& plan,
               const Scatter& scatter, Searcher searcher, Room& room) {
  for (room.attempts = 1; room.attempts <= kMostAttempts; ++room.attempts) {
    if (!Place(room.obstacles, plan, scatter, seed, room.attempts)) continue;
    searcher.Arrange(room.obstacles);
    const auto path = searcher.FreePath(scatter.way, config.clearance_m);
    if (!path) continue;
    room.path = *path;
    room.path_length_m = LengthOf(room.path);
    room.path_clearance_m = searcher.ClearanceAlong(room.path);
    return;
  }
  ThrowNoLayout(config, room.obstacles.size());
}

/// Draws barriers until there is no way through one, then places for all else on both sides of it.
void BlockTheWay(const RoomConfig& config, std::uint64_t seed, FloorPlan plan,
                 const Scatter& scatter, const SceneDocument& scene, const RobotEnvelope& robot,
                 Room& room) {
  const int first = static_cast<int>(room.obstacles.size()) + 1;
  for (room.attempts = 1; room.attempts <= kMostAttempts; ++room.attempts) {
    const auto barrier = DrawBarrier(plan, scatter, robot.core.top_m, first, seed, room.attempts);
    if (barrier.empty()) continue;
    Searcher searcher(scene, plan, robot, barrier);
    searcher.Arrange(barrier);
    if (!searcher.Blocked(scatter.way)) continue;
    for (const Obstacle& screen : barrier) {
      plan.furniture.push_back({FootprintOf(screen), 0, screen.size_m.z()});
    }
    int draw = 1;
    while (!Place(room.obstacles, plan, scatter, seed, draw)) {
      if (++draw > kMostAttempts) ThrowNoLayout(config, room.obstacles.size());
    }
    room.obstacles.insert(room.obstacles.end(), barrier.begin(), barrier.end());
    return;
  }
  ThrowNoLayout(config, room.obstacles.size());
}

}  // namespace

Room GenerateRoom(const RoomConfig& config, std::uint64_t seed) {
  hardware::ThrowIfAny(config.Validate());
  SceneDocument scene(config.scene);
  RequireEmpty(scene, config);
  Room room;
  room.lighting = ApplyLighting(scene, config.lighting, seed);
  if (config.vary_surfaces) room.surfaces = VarySurfaces(scene, seed);
  const auto shell = World::FromXml(scene.Text());
  if (config.vary_furniture) room.furniture = SlideFurniture(scene, *shell, seed);

  const RobotEnvelope robot = EnvelopeOf(*shell, kBase);
  const FloorPlan plan = PlanOf(*shell, shell->Id(mjOBJ_BODY, kBase));
  const double margin_m = config.clearance_m + kCell_m;
  const Scatter scatter{WayOf(config, *shell), robot.outer.radius_m + margin_m, config.free_path};
  RequirePlacesInside(plan, scatter, robot.outer.radius_m, margin_m);

  room.free_path = config.free_path;
  room.obstacles = DrawObstacles(config, seed);
  if (config.free_path) {
    LeaveAWay(config, seed, plan, scatter, {scene, plan, robot, room.obstacles}, room);
  } else {
    BlockTheWay(config, seed, plan, scatter, scene, robot, room);
  }
  for (const Obstacle& o : room.obstacles) AddObstacle(scene, o);
  room.mjcf = scene.Text();
  return room;
}

}  // namespace horopter::sim
