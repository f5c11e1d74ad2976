// SPDX-License-Identifier: Apache-2.0
#include "sim/tabletop/thing.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/sim/tabletop/tabletop_scene.h"

namespace horopter::sim {
namespace {

constexpr const char* kShapes = R"(<mujoco>
  <asset><mesh name="wedge" vertex="0 -1 0  0 1 0  2 -1 0  2 1 0  0 -1 1  0 1 1"/></asset>
  <worldbody>
    <body name="block" mocap="true" pos="3 0 0" euler="0 0 90">
      <geom type="box" size="0.1 0.2 0.3" pos="0 0 0.3"/>
      <geom type="sphere" size="0.05" pos="0 0 0.65"/>
    </body>
    <body name="egg" mocap="true"><geom type="ellipsoid" size="0.3 0.1 0.1" euler="0 0 45"/></body>
    <body name="wedge" mocap="true" pos="0 0 9"><geom type="mesh" mesh="wedge"/></body>
  </worldbody>
</mujoco>)";

TEST(Thing, BoxIsInItsOwnFrameAndHoldsAllItsGeoms) {
  const auto world = World::FromXml(kShapes);
  const Thing block(*world, "block");
  EXPECT_LT((block.box().min() - Eigen::Vector3d(-0.1, -0.2, 0)).norm(), 1e-9);
  EXPECT_LT((block.box().max() - Eigen::Vector3d(0.1, 0.2, 0.7)).norm(), 1e-9);
  const Thing egg(*world, "egg");
  const double half = std::sqrt((0.3 * 0.3 + 0.1 * 0.1) / 2);
  EXPECT_LT((egg.box().max() - Eigen::Vector3d(half, half, 0.1)).norm(), 1e-9);
  const Thing wedge(*world, "wedge");
  EXPECT_LT((wedge.box().min() - Eigen::Vector3d(0, -1, 0)).norm(), 1e-6);
  EXPECT_LT((wedge.box().max() - Eigen::Vector3d(2, 1, 1)).norm(), 1e-6);
  EXPECT_THROW(Thing(*world, "bloc"), SceneError);
}

TEST(Thing, RaysHitItWhereItWouldStand) {
  const auto world = World::FromXml(kShapes);
  const Thing block(*world, "block"), wedge(*world, "wedge");
  hardware::Pose X_WB = hardware::ToPose({1, 0, 0}, 0.5);
  const Eigen::Vector3d ahead = Eigen::Vector3d::UnitX();
  EXPECT_NEAR(block.Ray(X_WB, {0, 0, 0.8}, ahead).value(), 0.9, 1e-12);
  EXPECT_FALSE(block.Ray(X_WB, {0, 0.21, 0.8}, ahead).has_value());
  EXPECT_NEAR(block.Ray(X_WB, {0, 0, 1.15}, ahead).value(), 0.95, 1e-12);
  EXPECT_FALSE(block.Ray(X_WB, {2, 0, 0.8}, ahead).has_value()) << "behind the ray";
  EXPECT_NEAR(wedge.Ray(X_WB, {0, 0.3, 1.0}, ahead).value(), 1.0, 1e-6);
}

TEST(GroundPlan, ApartMeasuresTheGapBetweenTurnedRectangles) {
  const GroundPlan a{{0, 0}, {0.1, 0.2}, 0};
  EXPECT_TRUE(Apart(a, {{0.25, 0}, {0.1, 0.2}, 0}, 0.049));
  EXPECT_FALSE(Apart(a, {{0.25, 0}, {0.1, 0.2}, 0}, 0.051));
  // Turned by 45 deg, a square's corner reaches out to sqrt(2) of its half edge.
  const double corner = 0.1 * std::sqrt(2);
  EXPECT_TRUE(Apart(a, {{0.1 + corner + 0.02, 0}, {0.1, 0.1}, M_PI / 4}, 0.019));
  EXPECT_FALSE(Apart(a, {{0.1 + corner - 0.01, 0}, {0.1, 0.1}, M_PI / 4}, 0.0));
  EXPECT_FALSE(Apart(a, {{0, 0}, {0.01, 0.01}, 0.3}, 0.0)) << "one within the other";
}

}  // namespace
}  // namespace horopter::sim
