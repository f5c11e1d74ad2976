// SPDX-License-Identifier: Apache-2.0
#include "sim/tabletop/arrange_tabletop.h"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>
#include <string_view>

#include "hardware/types/config_error.h"
#include "sim/random/random_stream.h"
#include "sim/tabletop/table_plan.h"
#include "sim/tabletop/thing.h"
#include "sim/textures/paint_textures.h"

namespace horopter::sim {

namespace {

using hardware::Pose;

constexpr std::string_view kClutterPrefix = "clutter_";
constexpr double kUnderTheFloor_m = -8;

/// Names of the mocap bodies that a predicate likes, in the model's order.
template <typename Predicate>
std::vector<std::string> MocapBodies(const World& world, Predicate&& likes) {
  std::vector<std::string> names;
  for (int body = 1; body < world.model().nbody; ++body) {
    if (world.model().body_mocapid[body] < 0) continue;
    const std::string name = world.Name(mjOBJ_BODY, body);
    if (likes(name)) names.push_back(name);
  }
  return names;
}

bool Contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

void CheckNames(const World& world, const TabletopConfig& config) {
  std::vector<hardware::FieldError> errors = config.Validate();
  const auto require = [&](const char* field, const std::string& name,
                           const std::vector<std::string>& known) {
    if (Contains(known, name)) return;
    errors.push_back({std::string("tabletop.") + field, name,
                      fmt::format("the scene has {}", fmt::join(known, ", "))});
  };
  if (config.occlusion) {
    require("occlusion.target", config.occlusion->target, TabletopObjects(world));
    require("occlusion.by", config.occlusion->by, TabletopObjects(world));
  }
  if (!config.background.empty()) {
    require("background", config.background, Backgrounds(world));
  }
  const auto there = static_cast<int>(TabletopClutter(world).size());
  if (config.clutter.count > there) {
    errors.push_back({"tabletop.clutter.count", fmt::format("{}", config.clutter.count),
                      fmt::format("the scene has {} such things", there)});
  }
  hardware::ThrowIfAny(std::move(errors));
}

Eigen::Vector3d Viewpoint(const World& world, const TabletopConfig& config) {
  if (config.viewpoint_W) return *config.viewpoint_W;
  return (world.X_WCamera("left_peripheral").translation() +
          world.X_WCamera("right_peripheral").translation()) /
         2;
}

/// Larger things first, since they find the fewest places.
std::vector<Thing> Things(const World& world, const std::vector<std::string>& names) {
  std::vector<Thing> things;
  for (const std::string& name : names) things.emplace_back(world, name);
  std::stable_sort(things.begin(), things.end(),
                   [](const Thing& a, const Thing& b) { return a.radius_m() > b.radius_m(); });
  return things;
}

/// `count` of the names, drawn.
std::vector<std::string> Choose(std::vector<std::string> names, int count, RandomStream& random) {
  for (int i = 0; i < count; ++i) {
    const auto left = static_cast<double>(names.size() - i);
    std::swap(names[i], names[i + static_cast<std::size_t>(random.Uniform(0, left))]);
  }
  names.resize(count);
  return names;
}

void PlaceObjects(const World& world, const TabletopConfig& config, std::uint64_t seed,
                  TablePlan& plan) {
  for (const Thing& thing : Things(world, TabletopObjects(world))) {
    if (config.arrangement.shuffle) {
      RandomStream random(seed, "tabletop.place." + thing.name());
      plan.Place(thing, true, config.arrangement.max_hidden, random);
    } else {
      plan.Keep(thing);
    }
  }
}

void PlaceClutter(const World& world, const TabletopConfig& config, std::uint64_t seed,
                  TablePlan& plan) {
  RandomStream choice(seed, "tabletop.clutter");
  const auto chosen = Choose(TabletopClutter(world), config.clutter.count, choice);
  for (const Thing& thing : Things(world, chosen)) {
    RandomStream random(seed, "tabletop.clutter." + thing.name());
    plan.Place(thing, false, config.clutter.max_hidden, random);
  }
}

/// Textures of everything that is not under the floor: painting takes most of the time that a
/// tabletop needs.
std::set<int> SeenTextures(const World& world) {
  const mjModel& model = world.model();
  std::set<int> seen;
  for (int geom = 0; geom < model.ngeom; ++geom) {
    const bool hidden = world.data().xpos[3 * model.geom_bodyid[geom] + 2] < kUnderTheFloor_m / 2;
    const int material = model.geom_matid[geom];
    if (!hidden && material >= 0) seen.insert(model.mat_texid[material]);
  }
  return seen;
}

std::string SetBackground(World& world, const TabletopConfig& config, std::uint64_t seed) {
  const std::vector<std::string> all = Backgrounds(world);
  if (all.empty()) return "";
  RandomStream random(seed, "tabletop.background");
  const auto drawn = static_cast<std::size_t>(random.Uniform(0, static_cast<double>(all.size())));
  const std::string chosen = config.background.empty() ? all[drawn] : config.background;
  for (const std::string& name : all) {
    const std::string body = std::string(kBackgroundPrefix) + name;
    Pose X_WB = world.X_WBody(body);
    X_WB.translation().z() = name == chosen ? 0 : kUnderTheFloor_m;
    world.PlaceBody(body, X_WB);
  }
  return chosen;
}

}  // namespace

std::vector<std::string> TabletopObjects(const World& world) {
  return MocapBodies(world, [](const std::string& name) {
    return !name.starts_with(kClutterPrefix) && !name.starts_with(kBackgroundPrefix);
  });
}

std::vector<std::string> TabletopClutter(const World& world) {
  return MocapBodies(world,
                     [](const std::string& name) { return name.starts_with(kClutterPrefix); });
}

std::vector<std::string> Backgrounds(const World& world) {
  auto names = MocapBodies(
      world, [](const std::string& name) { return name.starts_with(kBackgroundPrefix); });
  for (std::string& name : names) name.erase(0, kBackgroundPrefix.size());
  return names;
}

Tabletop ArrangeTabletop(World& world, const TabletopConfig& config, std::uint64_t seed) {
  CheckNames(world, config);
  TablePlan plan(world, config, Viewpoint(world, config));
  PlaceObjects(world, config, seed, plan);
  PlaceClutter(world, config, seed, plan);
  if (config.occlusion) plan.Occlude(*config.occlusion, seed);

  Tabletop tabletop;
  if (config.occlusion) {
    tabletop.target_hidden = plan.Hidden(config.occlusion->target);
  }
  for (const auto& standing : plan.standing()) {
    tabletop.X_WThing[standing.thing.name()] = standing.X_WB;
  }
  for (const auto& [body, X_WB] : tabletop.X_WThing) world.PlaceBody(body, X_WB);
  tabletop.background = SetBackground(world, config, seed);
  tabletop.lamp = DrawLamp(config.light, seed);
  SetLamp(world, tabletop.lamp, plan.centre_W());
  PaintTextures(world.mutable_model(), config.textures ? seed : 0,
                [seen = SeenTextures(world)](int texture) { return seen.contains(texture); });
  world.Forward();
  return tabletop;
}

}  // namespace horopter::sim
