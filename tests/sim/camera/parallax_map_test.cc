// SPDX-License-Identifier: Apache-2.0
#include "sim/camera/parallax_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace horopter::sim {
namespace {

constexpr int kWidth = 120, kHeight = 20;
constexpr float kFocal_px = 100;
constexpr double kAside_m = 0.05;  // to the right of the view's centre
constexpr float kPast = 1e-3F;

/// A view down a scene, and what rays of its middle row hit when they start beside its centre.
class BesideTheView {
 public:
  explicit BesideTheView(const cv::Mat1f& depth) {
    map_.Make(depth, kAside_m, kFocal_px);
    K_ << kFocal_px, 0, (kWidth - 1) / 2.0F, 0, kFocal_px, (kHeight - 1) / 2.0F, 0, 0, 1;
  }

  /// @param column where the ray points
  float Depth(float column) const { return 1 / Solve(column); }
  /// The pixel of the view that shows what the ray hits.
  float Pixel(float column) const {
    return column + static_cast<float>(kAside_m) * kFocal_px * Solve(column);
  }

 private:
  float Solve(float column) const {
    const float x = (column - (kWidth - 1) / 2.0F) / kFocal_px, y = 0;
    float w = 0;
    const Eigen::Vector3f e = K_ * Eigen::Vector3f(static_cast<float>(kAside_m), 0, 0);
    map_.Solve(K_, e, &x, &y, 1, &w);
    return w;
  }

  ParallaxMap map_;
  Eigen::Matrix3f K_;
};

/// Something near in columns 50 to 69 before something far.
cv::Mat1f NearBeforeFar(float near_m, float far_m) {
  cv::Mat1f depth(kHeight, kWidth, far_m);
  depth.colRange(50, 70).setTo(near_m);
  return depth;
}

TEST(ParallaxMap, ASlantedPlaneIsHitWhereItIs) {
  // z = 2 + x, which the view sees at the pixel u as 1 / z = (1 - x/z) / 2.
  cv::Mat1f depth(kHeight, kWidth);
  for (int u = 0; u < kWidth; ++u) {
    const float tangent = (static_cast<float>(u) - (kWidth - 1) / 2.0F) / kFocal_px;
    depth.col(u).setTo(2 / (1 - tangent));
  }
  const BesideTheView view(depth);
  for (const float column : {10.0F, 40.0F, 59.5F, 90.0F}) {
    const float tangent = (column - (kWidth - 1) / 2.0F) / kFocal_px;
    const float expected = (2 + static_cast<float>(kAside_m)) / (1 - tangent);
    EXPECT_NEAR(view.Depth(column), expected, 0.01 * expected) << column;
  }
}

TEST(ParallaxMap, TheNearestIsHitAndItsGapIsFilledFromBehind) {
  const BesideTheView view(NearBeforeFar(0.5F, 5));  // parallax of 10 px and 1 px
  // Seen from the right, the near thing lies in columns 40 to 59; what the view could not see
  // behind it lies in 60 to 68.
  for (const float column : {41.0F, 50.0F, 58.0F}) EXPECT_NEAR(view.Depth(column), 0.5, kPast);
  for (const float column : {5.0F, 38.0F, 70.0F, 100.0F}) EXPECT_NEAR(view.Depth(column), 5, kPast);
  for (const float column : {61.0F, 64.0F, 67.0F}) {
    EXPECT_GE(view.Pixel(column), 70) << "beside the edge, where the background is seen";
    EXPECT_LE(view.Pixel(column), 78);
  }
}

TEST(ParallaxMap, NothingIsInfinitelyFar) {
  const BesideTheView view(NearBeforeFar(0.5F, std::numeric_limits<float>::infinity()));
  EXPECT_EQ(view.Pixel(20), 20);
  EXPECT_NEAR(view.Depth(50), 0.5, kPast);
}

}  // namespace
}  // namespace horopter::sim
