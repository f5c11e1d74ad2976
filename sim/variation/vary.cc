// SPDX-License-Identifier: Apache-2.0
#include "sim/variation/vary.h"

#include <fmt/core.h>

#include <cmath>
#include <optional>
#include <string_view>

#include "hardware/types/config_error.h"
#include "sim/random/random_stream.h"
#include "sim/textures/paint_textures.h"
#include "sim/variation/footprint.h"

namespace horopter::sim {

namespace {

constexpr std::string_view kObstaclePrefix = "obstacle_";
constexpr double kGapToThings_m = 0.05;
constexpr double kGapToRobot_m = 0.15;
constexpr int kMostDraws = 1000;

void Validate(const VariationConfig& config) {
  std::vector<hardware::FieldError> errors;
  const auto require = [&errors](const char* field, double value) {
    if (std::isfinite(value) && value >= 0) return;
    errors.push_back({field, fmt::format("{}", value), "must be finite and not negative"});
  };
  require("variation.obstacle_shift_m", config.obstacle_shift_m);
  require("variation.heading_rad", config.heading_rad);
  hardware::ThrowIfAny(std::move(errors));
}

/// The body "base" if it moves freely.
std::optional<int> FreeBase(const World& world) {
  const int base = mj_name2id(&world.model(), mjOBJ_BODY, "base");
  if (base < 0) return std::nullopt;
  const int joint = world.model().body_jntadr[base];
  if (joint < 0 || world.model().jnt_type[joint] != mjJNT_FREE) return std::nullopt;
  return base;
}

/// Metres between two footprints along the axis that separates them most; negative: overlap.
double Gap(const Footprint& a, const Footprint& b) {
  const Eigen::Vector2d gaps = (b.min() - a.max()).cwiseMax(a.min() - b.max());
  return gaps.maxCoeff();
}

/// Distance of a footprint's nearest corner from a wall, negative behind it; large for a floor.
double GapToPlane(const World& world, int plane, const Footprint& footprint) {
  const mjtNum* p = world.data().geom_xpos + 3 * plane;
  const mjtNum* axes = world.data().geom_xmat + 9 * plane;
  const Eigen::Vector2d normal(axes[2], axes[5]);
  constexpr double kHorizontal = 1e-3;
  if (normal.norm() < kHorizontal) return INFINITY;
  double least = INFINITY;
  for (const auto corner :
       {Footprint::BottomLeft, Footprint::BottomRight, Footprint::TopLeft, Footprint::TopRight}) {
    least = std::min(least, normal.dot(footprint.corner(corner) - Eigen::Vector2d(p[0], p[1])));
  }
  return least;
}

/// How much room a footprint of `body` has beyond the gaps that it must keep.
double Spare(const World& world, int body, const Footprint& footprint) {
  const mjModel& model = world.model();
  const std::optional<int> base = FreeBase(world);
  double least = INFINITY;
  for (int geom = 0; geom < model.ngeom; ++geom) {
    const bool solid = model.geom_contype[geom] != 0 || model.geom_conaffinity[geom] != 0;
    if (!solid || RidesOn(world, geom, body)) continue;
    if (model.geom_type[geom] == mjGEOM_PLANE) {
      least = std::min(least, GapToPlane(world, geom, footprint) - kGapToThings_m);
    } else {
      const bool robot = base && RidesOn(world, geom, *base);
      const double wanted_m = robot ? kGapToRobot_m : kGapToThings_m;
      least = std::min(least, Gap(footprint, FootprintOf(world, geom)) - wanted_m);
    }
  }
  return least;
}

Eigen::Vector2d DrawInDisc(RandomStream& random, double radius_m) {
  const double r = radius_m * std::sqrt(random.Uniform(0, 1));
  const double angle = random.Uniform(-M_PI, M_PI);
  return {r * std::cos(angle), r * std::sin(angle)};
}

Eigen::Vector2d ShiftObstacle(World& world, int body, double radius_m, std::uint64_t seed) {
  const std::string name = world.Name(mjOBJ_BODY, body);
  RandomStream random(seed, "variation." + name);
  const Footprint start = FootprintOfTree(world, body);
  if (start.isEmpty()) throw SceneError(fmt::format("body '{}' has nothing to collide with", name));
  const double needed = std::min(0.0, Spare(world, body, start));
  for (int draw = 0; draw < kMostDraws; ++draw) {
    const Eigen::Vector2d shift = DrawInDisc(random, radius_m);
    const Footprint there(start.min() + shift, start.max() + shift);
    if (Spare(world, body, there) < needed) continue;
    hardware::Pose X_WO = world.X_WBody(name);
    X_WO.translation().head<2>() += shift;
    world.PlaceBody(name, X_WO);
    return shift;
  }
  throw SceneError(
      fmt::format("body '{}': no free place within {} m; move it or lower "
                  "obstacle_shift_m",
                  name, radius_m));
}

/// Turns the base about the vertical through its own origin.
void TurnBase(World& world, int base, double turn) {
  const int joint = world.model().body_jntadr[base];
  mjtNum* quaternion = world.mutable_data().qpos + world.model().jnt_qposadr[joint] + 3;
  const mjtNum about_z[4] = {std::cos(turn / 2), 0, 0, std::sin(turn / 2)};
  mjtNum turned[4];
  mju_mulQuat(turned, about_z, quaternion);
  mju_copy4(quaternion, turned);
}

}  // namespace

double DrawHeading(const VariationConfig& config, std::uint64_t seed) {
  RandomStream random(seed, "variation.heading");
  return random.Uniform(-1, 1) * config.heading_rad;
}

Variation Vary(World& world, const VariationConfig& config, std::uint64_t seed) {
  Validate(config);
  Variation variation;
  const std::optional<int> base = FreeBase(world);
  for (int body = 0; config.obstacle_shift_m > 0 && body < world.model().nbody; ++body) {
    const std::string name = world.Name(mjOBJ_BODY, body);
    if (!name.starts_with(kObstaclePrefix)) continue;
    variation.obstacles.push_back(
        {name, ShiftObstacle(world, body, config.obstacle_shift_m, seed)});
  }
  if (base && config.heading_rad > 0) {
    variation.heading_rad = DrawHeading(config, seed);
    TurnBase(world, *base, variation.heading_rad);
  }
  PaintTextures(world.mutable_model(), config.textures ? seed : 0);
  world.Forward();
  return variation;
}

}  // namespace horopter::sim
