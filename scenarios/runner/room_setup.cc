// SPDX-License-Identifier: Apache-2.0
#include "scenarios/runner/room_setup.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "scenarios/format/scenes.h"

namespace horopter::scenarios {
namespace {

using Json = nlohmann::ordered_json;

Json Record(const sim::Obstacle& o) {
  return {{"name", o.name},
          {"shape", o.shape},
          {"x_m", o.X_WO.x_m},
          {"y_m", o.X_WO.y_m},
          {"heading_deg", o.X_WO.heading_rad * 180 / M_PI},
          {"size_m", {o.size_m.x(), o.size_m.y(), o.size_m.z()}},
          {"surface", o.surface},
          {"rgb", {o.rgb.x(), o.rgb.y(), o.rgb.z()}}};
}

}  // namespace

sim::RoomConfig RoomConfigOf(const RoomSpec& spec, const std::string& scene) {
  sim::RoomConfig config;
  config.scene = ScenesDir() / scene;
  config.min_obstacles = spec.min_obstacles;
  config.max_obstacles = spec.max_obstacles;
  config.free_path = spec.path == "free";
  config.clearance_m = spec.clearance_m;
  config.lighting = spec.lighting;
  config.vary_surfaces = spec.surfaces;
  config.vary_furniture = spec.furniture;
  return config;
}

sim::Room MakeRoom(const Scenario& scenario, const sim::VariationConfig& variation) {
  sim::RoomConfig config = RoomConfigOf(scenario.room.value(), scenario.scene);
  config.start_turn_rad = sim::DrawHeading(variation, scenario.seed);
  for (const Step& step : scenario.steps) {
    if (const auto* go = std::get_if<GotoStep>(&step.action)) config.goals_m.push_back(go->goal_m);
  }
  return sim::GenerateRoom(config, scenario.seed);
}

std::string RoomText(const sim::Room& room) {
  Json obstacles = Json::array(), path = Json::array(), furniture = Json::object();
  for (const sim::Obstacle& o : room.obstacles) obstacles.push_back(Record(o));
  for (const Eigen::Vector2d& p : room.path) path.push_back({p.x(), p.y()});
  for (const auto& [name, shift] : room.furniture) furniture[name] = {shift.x(), shift.y()};
  const bool free = room.free_path;
  const Json json = {
      {"frame", "W of the scene: x forward and y left of the robot's start"},
      {"path", free ? "free" : "blocked"},
      {"path_m", std::move(path)},
      {"path_length_m", free ? Json(room.path_length_m) : Json(nullptr)},
      {"clearance_m", free ? Json(room.path_clearance_m) : Json(nullptr)},
      {"obstacles", std::move(obstacles)},
      {"lighting", {{"name", room.lighting.name}, {"brightness", room.lighting.brightness}}},
      {"surfaces", room.surfaces},
      {"furniture_moved_m", std::move(furniture)},
      {"layouts_drawn", room.attempts}};
  return json.dump(2) + "\n";
}

}  // namespace horopter::scenarios
