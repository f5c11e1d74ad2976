// SPDX-License-Identifier: Apache-2.0
#include "sim/world/world.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <limits>

namespace horopter::sim {
namespace {

using hardware::Pose;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr const char* kSwing = R"(
<mujoco>
  <option timestep="0.002" gravity="0 0 0"/>
  <worldbody>
    <geom name="floor" type="plane" size="5 5 .1"/>
    <body name="pillar" pos="1 0 0.5"><geom name="pillar_box" type="box" size=".1 .1 .5"/></body>
    <body name="marker" mocap="true" pos="0 2 1"/>
    <body name="head" pos="0 0 1">
      <joint name="pan" axis="0 0 1"/>
      <geom type="sphere" size=".05" mass="1" contype="0" conaffinity="0"/>
      <camera name="left_camera" pos="0 0.1 0" xyaxes="0 -1 0 0 0 1"/>
      <body name="eye" pos="0.1 0 0"><geom size=".01" mass=".1" contype="0" conaffinity="0"/></body>
    </body>
  </worldbody>
</mujoco>)";

std::string MessageOf(const std::function<void()>& work) {
  try {
    work();
  } catch (const SceneError& e) {
    return std::string("SceneError: ") + e.what();
  } catch (const PhysicsError& e) {
    return std::string("PhysicsError: ") + e.what();
  }
  return "nothing thrown";
}

TEST(World, CameraPoseHasOpticalAxes) {
  const auto world = World::FromXml(kSwing);
  const Pose X_WC = world->X_WCamera("left_camera");
  EXPECT_TRUE(X_WC.translation().isApprox(Eigen::Vector3d(0, 0.1, 1)));
  // The camera looks along the head's x axis: its optical frame is body axes turned by the one
  // rotation that all layers share.
  EXPECT_TRUE(X_WC.linear().isApprox(hardware::OpticalToBody(), 1e-12)) << X_WC.linear();
}

TEST(World, PosesBelongToNowAfterStep) {
  const auto world = World::FromXml(kSwing);
  world->mutable_data().qvel[0] = 7.0;
  world->Forward();
  for (int i = 0; i < 10; ++i) {
    world->Step();
    const double pan = world->data().qpos[0];
    ASSERT_GT(pan, 0);
    const Eigen::Vector3d forward = world->X_WCamera("left_camera").linear().col(2);
    EXPECT_NEAR(std::atan2(forward.y(), forward.x()), pan, 1e-12);
    const Eigen::Vector3d eye = world->X_WBody("eye").translation();
    EXPECT_NEAR(std::atan2(eye.y(), eye.x()), pan, 1e-12);
  }
}

constexpr const char* kTumbling = R"(<mujoco><worldbody><geom type="plane" size="5 5 .1"/>
    <body name="crate" pos="0 0 .1"><freejoint/>
      <geom type="box" size=".1 .05 .02" euler="20 30 0"/></body></worldbody></mujoco>)";

TEST(World, StepEqualsMujocoStep) {
  const auto ours = World::FromXml(kTumbling);
  const auto theirs = World::FromXml(kTumbling);
  mj_resetData(&theirs->model(), &theirs->mutable_data());
  bool touched = false;
  for (int i = 0; i < 500; ++i) {
    ours->Step();
    mj_step(&theirs->model(), &theirs->mutable_data());
    touched = touched || !ours->Contacts().empty();
    for (int k = 0; k < ours->model().nv; ++k) {
      ASSERT_EQ(ours->data().qvel[k], theirs->data().qvel[k]) << "step " << i << ", qvel " << k;
    }
    for (int k = 0; k < ours->model().nq; ++k) {  // ours have been normalised already
      ASSERT_NEAR(ours->data().qpos[k], theirs->data().qpos[k], 1e-15) << "step " << i;
    }
  }
  EXPECT_TRUE(touched);
}

TEST(World, ForwardDoesNotChangeTheState) {
  const auto world = World::FromXml(kTumbling);
  for (int i = 0; i < 300; ++i) {
    world->Step();
    const std::vector<double> qpos(world->data().qpos, world->data().qpos + world->model().nq);
    const std::vector<double> qvel(world->data().qvel, world->data().qvel + world->model().nv);
    const auto contacts = world->Contacts();
    world->Forward();
    EXPECT_EQ(world->Contacts().size(), contacts.size());
    for (int k = 0; k < world->model().nv; ++k) ASSERT_EQ(world->data().qvel[k], qvel[k]);
    for (int k = 0; k < world->model().nq; ++k) ASSERT_NEAR(world->data().qpos[k], qpos[k], 1e-15);
  }
}

TEST(World, TimeIsAWholeNumberOfSteps) {
  const auto world = World::FromXml(R"(<mujoco><option timestep="0.0033333333333"/></mujoco>)");
  EXPECT_EQ(world->step(), hardware::Duration(3'333'333));
  EXPECT_EQ(world->model().opt.timestep, 0.003333333);
  for (int i = 0; i < 3000; ++i) world->Step();
  EXPECT_EQ(world->now().time_since_epoch(), 3000 * world->step());
  world->Reset();
  EXPECT_EQ(world->now(), hardware::Time{});
}

TEST(World, ResetReproducesTheRun) {
  const auto world = World::FromXml(R"(<mujoco><worldbody><geom type="plane" size="5 5 .1"/>
      <body pos="0 0 .1"><freejoint/><geom type="capsule" size=".05 .1" euler="50 0 0"/></body>
      </worldbody></mujoco>)");
  const auto run = [&world] {
    for (int i = 0; i < 200; ++i) world->Step();
    return std::vector<double>(world->data().qpos, world->data().qpos + world->model().nq);
  };
  const auto first = run();
  world->Reset();
  EXPECT_EQ(first, run());
}

TEST(World, NanBecomesPhysicsErrorUntilReset) {
  const auto world = World::FromXml(kSwing);
  world->Step();
  world->mutable_data().qvel[0] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(MessageOf([&] { world->Step(); }), HasSubstr("PhysicsError"));
  EXPECT_THAT(MessageOf([&] { world->Step(); }), HasSubstr("PhysicsError"));
  world->Reset();
  EXPECT_NO_THROW(world->Step());
}

TEST(World, HugeForceBecomesPhysicsErrorInTheSameStep) {
  const auto world = World::FromXml(kSwing);
  world->mutable_data().qfrc_applied[0] = 1e300;
  EXPECT_THAT(MessageOf([&] { world->Step(); }),
              AllOf(HasSubstr("PhysicsError"), HasSubstr("0.002 s"), Not(HasSubstr("\n"))));
}

TEST(World, MujocoErrorsAreExceptionsNotPrompts) {
  World::FromXml(kSwing);
  EXPECT_THROW(mju_error("the buffer is full"), PhysicsError);
}

TEST(World, WarningsWriteNoLogFile) {
  const auto here = std::filesystem::current_path();
  const auto folder = std::filesystem::path(testing::TempDir()) / "horopter_world_warning";
  std::filesystem::create_directories(folder);
  std::filesystem::current_path(folder);
  World::FromXml(kSwing);
  mju_warning("a test of the warning handler");
  EXPECT_TRUE(std::filesystem::is_empty(folder));
  std::filesystem::current_path(here);
  std::filesystem::remove_all(folder);
}

TEST(World, UnknownNameSuggestsTheNearest) {
  const auto world = World::FromXml(kSwing);
  EXPECT_THAT(MessageOf([&] { world->X_WCamera("left_camara"); }),
              AllOf(HasSubstr("SceneError"), HasSubstr("camera named 'left_camara'"),
                    HasSubstr("did you mean 'left_camera'?")));
  EXPECT_THAT(MessageOf([&] { world->Id(mjOBJ_SENSOR, "ir0"); }),
              HasSubstr("it has no named sensor"));
}

TEST(World, BadScenesNameFileAndReason) {
  EXPECT_THAT(MessageOf([] { World("/nowhere/room.xml"); }),
              AllOf(HasSubstr("SceneError"), HasSubstr("/nowhere/room.xml")));
  const auto file = std::filesystem::path(testing::TempDir()) / "horopter_world_broken.xml";
  std::ofstream(file) << "<mujoco><worldbody><geom size='-'/></worldbody></mujoco>";
  EXPECT_THAT(MessageOf([&] { World{file}; }),
              AllOf(HasSubstr("SceneError"), HasSubstr(file.string()), Not(HasSubstr("\n"))));
  std::filesystem::remove(file);
  EXPECT_THAT(MessageOf([] { World::FromXml(""); }), HasSubstr("SceneError"));
  EXPECT_THAT(MessageOf([] { World::FromXml("<mujoco><worldbdy/></mujoco>"); }),
              AllOf(HasSubstr("SceneError"), HasSubstr("worldbdy")));
}

TEST(World, LoadsAFile) {
  const auto file = std::filesystem::path(testing::TempDir()) / "horopter_world_swing.xml";
  std::ofstream(file) << kSwing;
  const World world(file);
  EXPECT_EQ(world.path(), file);
  EXPECT_EQ(world.Name(mjOBJ_BODY, world.Id(mjOBJ_BODY, "eye")), "eye");
  std::filesystem::remove(file);
}

TEST(World, PlacesStaticAndMocapBodiesThroughReset) {
  const auto world = World::FromXml(kSwing);
  Pose X_WT = Pose::Identity();
  X_WT.translation() << -1, 0.5, 0.7;
  X_WT.linear() = (Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitZ()) *
                   Eigen::AngleAxisd(-0.3, Eigen::Vector3d::UnitX()))
                      .toRotationMatrix();
  for (const char* body : {"pillar", "marker"}) {
    world->PlaceBody(body, X_WT);
    EXPECT_TRUE(world->X_WBody(body).isApprox(X_WT, 1e-12)) << body;
    world->Step();
    EXPECT_TRUE(world->X_WBody(body).isApprox(X_WT, 1e-12)) << body;
    world->Reset();
    EXPECT_TRUE(world->X_WBody(body).isApprox(X_WT, 1e-12)) << body;
  }
  EXPECT_THROW(world->PlaceBody("head", X_WT), SceneError);
  EXPECT_THROW(world->PlaceBody("eye", X_WT), SceneError);
  EXPECT_THROW(world->PlaceBody("world", X_WT), SceneError);
}

TEST(World, ContactsNameBothSides) {
  const auto world = World::FromXml(R"(<mujoco><worldbody>
      <geom name="floor" type="plane" size="5 5 .1"/>
      <body name="crate" pos="0 0 .099"><freejoint/>
        <geom name="crate_box" type="box" size=".1 .1 .1"/></body>
      <body name="kite" pos="0 0 2"><geom name="kite_box" type="box" size=".1 .1 .1"/></body>
      </worldbody></mujoco>)");
  const auto contacts = world->Contacts();
  ASSERT_EQ(contacts.size(), 4u);
  for (const Contact& c : contacts) {
    EXPECT_EQ(c.geom1, "floor");
    EXPECT_EQ(c.body1, "world");
    EXPECT_EQ(c.geom2, "crate_box");
    EXPECT_EQ(c.body2, "crate");
    EXPECT_NEAR(c.distance_m, -0.001, 1e-9);
  }
}

}  // namespace
}  // namespace horopter::sim
