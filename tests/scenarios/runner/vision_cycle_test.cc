// SPDX-License-Identifier: Apache-2.0
#include "scenarios/runner/vision_cycle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/imgproc.hpp>
#include <random>

#include "scenarios/format/robot_description.h"
#include "scenarios/format/scenes.h"

namespace horopter::scenarios {
namespace {

constexpr int kWidth = 160;
constexpr int kHeight = 120;

/// Random texture on a wall that both eyes, looking straight ahead, see `disparity_px` apart.
hardware::StereoFrame Wall(int disparity_px) {
  std::mt19937 random(7);
  cv::Mat1b texture(kHeight, kWidth + disparity_px);
  for (auto& grey : texture) grey = static_cast<std::uint8_t>(100 + random() % 40);
  cv::GaussianBlur(texture, texture, {}, 1.2);
  texture = (texture - 120) * 3 + 120;
  hardware::StereoFrame frame;
  const auto view = [&texture](int from) {
    cv::Mat bgr;
    cv::cvtColor(texture(cv::Rect(from, 0, kWidth, kHeight)), bgr, cv::COLOR_GRAY2BGR);
    return bgr;
  };
  frame.left.bgr = view(0);
  frame.right.bgr = view(disparity_px);  // a point at u on the left is at u - d on the right
  return frame;
}

TEST(VisionCycle, RegionsHaveTheDepthOfTheDepthMap) {
  const RobotDescription robot = LoadRobotDescription(RobotFile(ScenesDir(), "koala"));
  const auto camera = hardware::CameraModel::FromHorizontalFov(kWidth, kHeight, M_PI / 3);
  VisionSpec spec;
  spec.scales = 3;
  const VisionCycle vision(spec, {camera, camera}, robot);
  constexpr int kDisparity_px = 3;
  const double wall_m = camera.intrinsics().fx * robot.head_geometry.baseline_m / kDisparity_px;
  ASSERT_GT(wall_m, 3.5) << "beyond what counts as an obstacle, and higher than the robot too";
  hardware::StageTimes times;
  const VisionResult result = vision.Run(Wall(kDisparity_px), {}, times);

  int judged = 0;
  for (const vision::Region& region : result.regions.regions) {
    double sum = 0, least = INFINITY;
    int count = 0;
    for (int v = 0; v < kHeight; ++v) {
      for (int u = 0; u < kWidth; ++u) {
        const double depth = result.depth_m(v, u);
        if (result.regions.labels(v, u) != region.label || !std::isfinite(depth)) continue;
        ++count;
        sum += depth;
        least = std::min(least, depth);
      }
    }
    ASSERT_EQ(region.depth.count, count);
    if (count < 200) continue;
    ++judged;
    EXPECT_NEAR(region.depth.mean_m, sum / count, 1e-9);
    EXPECT_EQ(region.depth.min_m, least);
    EXPECT_NEAR(region.depth.mean_m, wall_m, 0.1 * wall_m);
  }
  EXPECT_GT(judged, 0);
}

}  // namespace
}  // namespace horopter::scenarios
