// SPDX-License-Identifier: Apache-2.0
#include "sim/truth/ground_truth.h"

#include <gtest/gtest.h>

namespace horopter::sim {
namespace {

using hardware::CameraModel;
using hardware::Pose;

TEST(GroundTruth, ShowsTheWorldOfNow) {
  const auto world = World::FromXml(R"(
      <mujoco>
        <worldbody>
          <geom name="floor" type="plane" size="5 5 .1"/>
          <body name="crate" pos="2 0 .0999"><freejoint/>
            <geom name="crate_box" type="box" size=".1 1 .1"/></body>
        </worldbody>
      </mujoco>)");
  for (int i = 0; i < 20; ++i) world->Step();
  Renderer renderer(*world, {.width = 64, .height = 48});
  Pose X_WCl = Pose::Identity();
  X_WCl.translation() << 0, 0.03, 0.1;
  X_WCl.linear() = hardware::OpticalToBody();
  Pose X_WCr = X_WCl;
  X_WCr.translation() << 0.5, -0.03, 0.1;
  Pose X_WBase = Pose::Identity();
  X_WBase.translation().x() = 0.25;

  hardware::HeadAngles head;
  head.neck.tilt_rad = 0.2;

  const GroundTruth truth =
      CaptureGroundTruth(*world, renderer, {X_WCl, CameraModel::FromHorizontalFov(64, 48, 1.0)},
                         {X_WCr, CameraModel::FromHorizontalFov(33, 21, 0.4)}, X_WBase, head);

  EXPECT_EQ(truth.t, world->now());
  EXPECT_EQ(truth.left.depth.size(), cv::Size(64, 48));
  EXPECT_EQ(truth.right.depth.size(), cv::Size(33, 21));
  EXPECT_NEAR(truth.left.depth(24, 32), 1.9, 1e-3);
  EXPECT_NEAR(truth.right.depth(10, 16), 1.4, 1e-3);
  EXPECT_EQ(truth[hardware::Eye::kRight].ids(10, 16), world->Id(mjOBJ_GEOM, "crate_box"));
  EXPECT_EQ(truth.left.ids(47, 32), world->Id(mjOBJ_GEOM, "floor"));
  EXPECT_TRUE(truth.right.view.X_WC.isApprox(X_WCr));
  EXPECT_TRUE(truth.X_WBase.isApprox(X_WBase));
  EXPECT_EQ(truth.head.neck.tilt_rad, 0.2);
  ASSERT_EQ(truth.contacts.size(), 4u);
  EXPECT_EQ(truth.contacts[0].body2, "crate");
}

}  // namespace
}  // namespace horopter::sim
