// SPDX-License-Identifier: Apache-2.0
#include "sim/truth/world_state.h"

#include <gtest/gtest.h>

#include "tests/sim/truth/truth_scene.h"

namespace horopter::sim {
namespace {

TEST(WorldState, HoldsPosesJointsAndContactsOfNow) {
  TruthScene scene(R"(
      <mujoco>
        <worldbody>
          <geom name="floor" type="plane" size="5 5 .1"/>
          <body name="crate" pos="2 0 .0999"><freejoint/>
            <geom name="crate_box" type="box" size=".1 1 .1"/></body>
          <body name="arm" pos="0 0 1"><joint name="pan" axis="0 0 1"/>
            <geom type="sphere" size=".1"/>
            <body name="slider" pos=".5 0 0"><joint name="lift" type="slide" axis="0 0 1"/>
              <geom type="sphere" size=".1"/></body></body>
        </worldbody>
      </mujoco>)");
  World& world = scene.world();
  world.mutable_data().qpos[7] = M_PI / 2;
  world.mutable_data().qpos[8] = 0.2;
  world.mutable_data().qvel[6] = -3;
  world.Forward();

  const WorldState state = ReadWorldState(world);
  EXPECT_EQ(state.t, world.now());
  ASSERT_EQ(state.bodies.size(), 3u);
  EXPECT_EQ(state.bodies[2].body, "slider");
  EXPECT_LT(
      (state.bodies[2].X_WB * Eigen::Vector3d(0.1, 0, 0) - Eigen::Vector3d(0, 0.6, 1.2)).norm(),
      1e-12);
  ASSERT_EQ(state.joints.size(), 2u) << "the free joint is told by its body's pose";
  EXPECT_EQ(state.joints[0].joint, "pan");
  EXPECT_EQ(state.joints[0].kind, JointKind::kHinge);
  EXPECT_EQ(state.joints[0].position, M_PI / 2);
  EXPECT_EQ(state.joints[0].velocity, -3);
  EXPECT_EQ(state.joints[1].kind, JointKind::kSlide);
  EXPECT_EQ(state.joints[1].position, 0.2);
  ASSERT_EQ(state.contacts.size(), 4u);
  const Contact& contact = state.contacts[0];
  EXPECT_EQ(contact.body2, "crate");
  EXPECT_NEAR(contact.distance_m, -1e-4, 1e-9);
  EXPECT_NEAR(std::abs(contact.p_W.y()), 1, 1e-3);
  EXPECT_NEAR(contact.p_W.z(), 0, 1e-3);
  EXPECT_NEAR(contact.normal_W.z(), 1, 1e-9) << "from the floor to the crate";
}

}  // namespace
}  // namespace horopter::sim
