// SPDX-License-Identifier: Apache-2.0
#include "sim/rooms/robot_envelope.h"

#include <gtest/gtest.h>

#include "sim/oracle/collision_oracle.h"

namespace horopter::sim {
namespace {

const std::string kEmptyRoom = std::string(HOROPTER_SOURCE_DIR) + "/scenes/koala/empty_room.xml";

TEST(RobotEnvelope, KoalaFitsItsOuterCircleAndHoldsItsCore) {
  const World world(kEmptyRoom);
  const RobotEnvelope envelope = EnvelopeOf(world, "base");
  EXPECT_GT(envelope.outer.radius_m, 0.21);
  EXPECT_LT(envelope.outer.radius_m, 0.235) << "robot.yaml's body_radius_m";
  EXPECT_GT(envelope.core.radius_m, 0.11);
  EXPECT_LT(envelope.core.radius_m, 0.15);
  EXPECT_GT(envelope.outer.top_m, 0.3);
  EXPECT_LT(envelope.outer.bottom_m, envelope.core.bottom_m);
}

/// A thin upright plate whose face is this far from the robot's axis, in this direction.
double DistanceOfPlate(double face_m, double direction_rad) {
  constexpr double kHalf_m = 0.01;
  SceneDocument scene(kEmptyRoom);
  pugi::xml_node body = scene.AppendSection("worldbody").append_child("body");
  SetPose(body, {(face_m + kHalf_m) * std::cos(direction_rad),
                 (face_m + kHalf_m) * std::sin(direction_rad), direction_rad});
  pugi::xml_node geom = body.append_child("geom");
  geom.append_attribute("type") = "box";
  geom.append_attribute("size") = MjcfNumbers({kHalf_m, 1.0, 0.5}).c_str();
  geom.append_attribute("pos") = "0 0 0.5";
  const auto world = World::FromXml(scene.Text());
  CollisionOracle oracle(world->model());
  oracle.Sync(world->data());
  return oracle.ClearanceOf(world->Id(mjOBJ_BODY, "base")).distance_m;
}

TEST(RobotEnvelope, HoldsInEveryDirection) {
  const World world(kEmptyRoom);
  const RobotEnvelope envelope = EnvelopeOf(world, "base");
  for (double direction = 0; direction < 2 * M_PI; direction += 0.3) {
    EXPECT_GE(DistanceOfPlate(envelope.outer.radius_m, direction), -1e-9) << direction;
    EXPECT_LT(DistanceOfPlate(envelope.core.radius_m, direction), 0) << direction;
  }
}

TEST(RobotEnvelope, UnknownBodyIsNamed) {
  const World world(kEmptyRoom);
  EXPECT_THROW(EnvelopeOf(world, "torso"), SceneError);
}

}  // namespace
}  // namespace horopter::sim
