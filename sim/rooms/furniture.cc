// SPDX-License-Identifier: Apache-2.0
#include "sim/rooms/furniture.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "sim/random/random_stream.h"
#include "sim/variation/footprint.h"

namespace horopter::sim {
namespace {

constexpr double kFarthest_m = 0.3;
constexpr double kGap_m = 0.05;
constexpr int kMostDraws = 20;

/// Footprints of the standing geoms that do not belong to `body`.
std::vector<Footprint> Others(const World& world, int body) {
  const mjModel& model = world.model();
  std::vector<Footprint> others;
  for (int geom = 0; geom < model.ngeom; ++geom) {
    const bool solid = model.geom_contype[geom] != 0 || model.geom_conaffinity[geom] != 0;
    if (!solid || model.geom_type[geom] == mjGEOM_PLANE || RidesOn(world, geom, body)) continue;
    others.push_back(FootprintOf(world, geom));
  }
  return others;
}

Footprint Grown(const Footprint& footprint, double by_m) {
  const Eigen::Vector2d margin = Eigen::Vector2d::Constant(by_m);
  return Footprint(footprint.min() - margin, footprint.max() + margin);
}

/// Unit vector along the wall that is nearest to the footprint.
Eigen::Vector2d AlongNearestWall(const Footprint& room, const Footprint& thing) {
  const Eigen::Vector2d to_wall = (thing.min() - room.min()).cwiseMin(room.max() - thing.max());
  return to_wall.x() < to_wall.y() ? Eigen::Vector2d::UnitY() : Eigen::Vector2d::UnitX();
}

/// The piece of the way drawn that it can go.
Eigen::Vector2d DrawSlide(const World& world, int body, const Footprint& room,
                          RandomStream& random) {
  const Footprint here = FootprintOfTree(world, body);
  if (here.isEmpty()) return Eigen::Vector2d::Zero();
  const Eigen::Vector2d along = AlongNearestWall(room, here);
  const std::vector<Footprint> others = Others(world, body);
  for (int draw = 0; draw < kMostDraws; ++draw) {
    const Eigen::Vector2d shift = random.Uniform(-kFarthest_m, kFarthest_m) * along;
    const Footprint there(here.min() + shift, here.max() + shift);
    // Along its wall only what is beside it counts, not the wall itself.
    const bool inside = room.min().dot(along) + kGap_m <= there.min().dot(along) &&
                        there.max().dot(along) <= room.max().dot(along) - kGap_m;
    const bool free = std::none_of(others.begin(), others.end(), [&](const Footprint& other) {
      return Grown(there, kGap_m).intersects(other);
    });
    if (inside && free) return shift;
  }
  return Eigen::Vector2d::Zero();
}

void Shift(pugi::xml_node body, const Eigen::Vector2d& shift) {
  Eigen::Vector3d p = Eigen::Vector3d::Zero();
  std::istringstream text(body.attribute("pos").value());
  text.imbue(std::locale::classic());
  for (int i = 0; i < 3; ++i) text >> p[i];
  p.head<2>() += shift;
  if (!body.attribute("pos")) body.append_attribute("pos");
  body.attribute("pos").set_value(MjcfNumbers({p.x(), p.y(), p.z()}).c_str());
}

}  // namespace

std::map<std::string, Eigen::Vector2d> SlideFurniture(SceneDocument& scene, World& world,
                                                      std::uint64_t seed) {
  const mjModel& model = world.model();
  const int floor = world.Id(mjOBJ_GEOM, "floor");
  const Eigen::Vector2d middle(world.data().geom_xpos[3 * floor],
                               world.data().geom_xpos[3 * floor + 1]);
  const Eigen::Vector2d half(model.geom_size[3 * floor], model.geom_size[3 * floor + 1]);
  const Footprint room(middle - half, middle + half);
  std::map<std::string, Eigen::Vector2d> shifts;
  for (int body = 1; body < model.nbody; ++body) {
    const std::string name = world.Name(mjOBJ_BODY, body);
    pugi::xml_node node = scene.Find("body", name);
    if (model.body_weldid[body] != 0 || model.body_parentid[body] != 0 || !node) continue;
    RandomStream random(seed, "room.furniture." + name);
    const Eigen::Vector2d shift = DrawSlide(world, body, room, random);
    if (shift.isZero()) continue;
    hardware::Pose X_WB = world.X_WBody(name);
    X_WB.translation().head<2>() += shift;
    world.PlaceBody(name, X_WB);
    Shift(node, shift);
    shifts[name] = shift;
  }
  return shifts;
}

}  // namespace horopter::sim
