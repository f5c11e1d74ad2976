// SPDX-License-Identifier: Apache-2.0
#include "sim/tabletop/silhouette.h"

#include <gtest/gtest.h>

namespace horopter::sim {
namespace {

/// Two flat squares that face a viewpoint on the x axis.
constexpr const char* kSquares = R"(<mujoco><worldbody>
  <body name="far" mocap="true"><geom type="box" size="0.001 0.2 0.2"/></body>
  <body name="near" mocap="true"><geom type="box" size="0.001 0.1 0.1"/></body>
</worldbody></mujoco>)";

class SilhouetteTest : public testing::Test {
 protected:
  static hardware::Pose At(double x, double y) { return hardware::ToPose({x, y, 0}); }

  const std::unique_ptr<World> world_ = World::FromXml(kSquares);
  const Thing far_{*world_, "far"}, near_{*world_, "near"};
  const Eigen::Vector3d eye_ = Eigen::Vector3d::Zero();
};

TEST_F(SilhouetteTest, ASquareHalfAsFarAndHalfAsLargeHidesAllOfTheOther) {
  const Silhouette far(far_, At(2, 0), eye_, 60);
  EXPECT_EQ(far.hidden(), 0);
  EXPECT_GT(far.HiddenWith(near_, At(1 - 0.002, 0)), 0.999);
  EXPECT_EQ(far.hidden(), 0) << "asking changes nothing";
}

TEST_F(SilhouetteTest, MovedAsideItHidesWhatGeometrySays) {
  for (const double aside_m : {0.02, 0.05, 0.1, 0.15}) {
    // Its shadow on the far square's plane moves twice as far and is as wide as the square.
    const double expected = 1 - 2 * aside_m / 0.4;
    const Silhouette far(far_, At(2, 0), eye_, 100);
    EXPECT_NEAR(far.HiddenWith(near_, At(1, aside_m)), expected, 0.02) << aside_m;
    EXPECT_NEAR(far.HiddenWith(near_, At(1, -aside_m)), expected, 0.02) << aside_m;
  }
  EXPECT_EQ(Silhouette(far_, At(2, 0), eye_, 60).HiddenWith(near_, At(1, 0.21)), 0);
}

TEST_F(SilhouetteTest, WhatStandsBehindHidesNothing) {
  EXPECT_EQ(Silhouette(far_, At(2, 0), eye_, 60).HiddenWith(near_, At(2.5, 0)), 0);
}

TEST_F(SilhouetteTest, SeveralThingsHideTheirUnion) {
  Silhouette far(far_, At(2, 0), eye_, 100);
  far.Hide(near_, At(1, 0.1));
  EXPECT_NEAR(far.hidden(), 0.5, 0.02);
  EXPECT_NEAR(far.HiddenWith(near_, At(1, 0.15)), 0.5, 0.02) << "already hidden there";
  far.Hide(near_, At(1, -0.15));
  EXPECT_NEAR(far.hidden(), 0.75, 0.02);
}

}  // namespace
}  // namespace horopter::sim
