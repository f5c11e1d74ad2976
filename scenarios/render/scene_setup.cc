// SPDX-License-Identifier: Apache-2.0
#include "scenarios/render/scene_setup.h"

#include "sim/rooms/room.h"
#include "sim/tabletop/arrange_tabletop.h"
#include "sim/textures/paint_textures.h"
#include "sim/variation/vary.h"

namespace horopter::scenarios {

namespace {

/// Whether there are objects to put on a table.
bool IsTabletop(const sim::World& world) {
  return mj_name2id(&world.model(), mjOBJ_GEOM, "table_top") >= 0 &&
         !sim::TabletopObjects(world).empty();
}

}  // namespace

std::unique_ptr<sim::World> LoadScene(const SceneSetup& setup) {
  const std::uint64_t seed = setup.seed.value_or(0);
  std::unique_ptr<sim::World> world;
  if (setup.room) {
    sim::RoomConfig room = *setup.room;
    room.scene = setup.scene;
    world = sim::World::FromXml(sim::GenerateRoom(room, seed).mjcf);
    sim::PaintTextures(world->mutable_model(), seed);
    world->Forward();
    return world;
  }
  world = std::make_unique<sim::World>(setup.scene);
  if (IsTabletop(*world)) {
    sim::TabletopConfig tabletop = setup.tabletop;
    if (!setup.seed) tabletop.arrangement.shuffle = false;
    sim::ArrangeTabletop(*world, tabletop, seed);
  } else if (setup.seed) {
    sim::Vary(*world, {}, seed);
  } else {
    sim::PaintTextures(world->mutable_model(), seed);
    world->Forward();
  }
  return world;
}

}  // namespace horopter::scenarios
