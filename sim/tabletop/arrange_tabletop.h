// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "hardware/types/pose.h"
#include "sim/tabletop/set_light.h"
#include "sim/tabletop/tabletop_config.h"
#include "sim/world/world.h"

namespace horopter::sim {

/// Names of the bodies behind the table begin with it.
inline constexpr std::string_view kBackgroundPrefix = "background_";

/// How a tabletop came out, for the run's record.
struct Tabletop {
  std::map<std::string, hardware::Pose> X_WThing;  ///< of everything on the table, by body
  std::optional<double> target_hidden;  ///< the share of the occluded target that is hidden
  LampState lamp;
  std::string background;
};

/// Names of the scene's objects, of its clutter (both in the model's order), and of its
/// backgrounds ("brick" for the body background_brick).
///
/// Things are the scene's mocap bodies: clutter is named clutter_*, backgrounds background_*, all
/// others are objects. Each has its frame on the ground under its middle and shows what it is best
/// known by towards its x axis.
std::vector<std::string> TabletopObjects(const World& world);
std::vector<std::string> TabletopClutter(const World& world);
std::vector<std::string> Backgrounds(const World& world);

/// Varies a tabletop that has just been loaded: puts the objects on the geom "table_top", then
/// clutter between them, then one object in front of another; sets the lights and the background,
/// paints the textures of what can be seen; then World::Forward().
///
/// Everything stands upright on the table, nothing touches anything else. The same seed gives the
/// same tabletop. Each part draws from streams of its own, so that turning one off changes no
/// other, with one exception that lies in the matter: to hide a target, the object in front of it
/// moves there, and what stands in the way, or hides it too, goes elsewhere; a target without room
/// in front of it is moved first.
/// @throws hardware::ConfigError when fields do not hold, or name what the scene lacks
/// @throws SceneError when the scene is no tabletop, or there is no place for a thing
Tabletop ArrangeTabletop(World& world, const TabletopConfig& config, std::uint64_t seed);

}  // namespace horopter::sim
