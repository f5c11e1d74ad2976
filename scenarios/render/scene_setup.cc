// SPDX-License-Identifier: Apache-2.0
#include "scenarios/render/scene_setup.h"

#include "scenarios/format/scenes.h"
#include "scenarios/runner/room_setup.h"
#include "sim/tabletop/arrange_tabletop.h"
#include "sim/textures/paint_textures.h"
#include "sim/variation/vary.h"

namespace horopter::scenarios {
namespace {

sim::Room RoomOf(const RenderRequest& request) {
  sim::RoomConfig config = RoomConfigOf(request.room->spec, request.scene);
  config.goals_m = {request.room->goal_m};
  return sim::GenerateRoom(config, request.seed.value_or(0));
}

/// Whether there are objects to put on a table.
bool IsTabletop(const sim::World& world) {
  return mj_name2id(&world.model(), mjOBJ_GEOM, "table_top") >= 0 &&
         !sim::TabletopObjects(world).empty();
}

sim::TabletopConfig TabletopOf(const RenderRequest& request) {
  const TableSpec spec = request.table.value_or(TableSpec{});
  sim::TabletopConfig config;
  config.arrangement.shuffle = request.seed.has_value();
  config.clutter.count = spec.clutter;
  if (spec.occluded != TableSpec::kNothingHidden) {
    config.occlusion.emplace().fraction = spec.occluded;
  }
  config.background = spec.background;
  config.light.brightness = spec.brightness;
  config.light.colour_temperature_k = spec.colour_temperature_k;
  return config;
}

std::unique_ptr<sim::World> WorldOf(const RenderRequest& request, const Scenery& scenery) {
  const std::uint64_t seed = request.seed.value_or(0);
  if (scenery.room) {
    auto world = sim::World::FromXml(scenery.room->mjcf);
    sim::PaintTextures(world->mutable_model(), seed);
    return world;
  }
  auto world = std::make_unique<sim::World>(ScenesDir() / request.scene);
  if (IsTabletop(*world)) {
    sim::ArrangeTabletop(*world, TabletopOf(request), seed);
  } else if (request.seed) {
    sim::Vary(*world, {}, seed);
  } else {
    sim::PaintTextures(world->mutable_model(), seed);
  }
  return world;
}

}  // namespace

Scenery LoadScene(const RenderRequest& request) {
  Scenery scenery;
  if (request.room) scenery.room = RoomOf(request);
  scenery.world = WorldOf(request, scenery);
  scenery.world->Forward();
  scenery.X_WO = hardware::ToPose(hardware::ToPose2(scenery.world->X_WBody("base")));
  return scenery;
}

void PlaceBodies(Scenery& scenery, const std::map<std::string, BodyPlacement>& bodies) {
  for (const auto& [name, placement] : bodies) {
    scenery.world->PlaceBody(name, scenery.X_WO * placement.X_OBody());
  }
}

}  // namespace horopter::scenarios
