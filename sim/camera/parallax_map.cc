// SPDX-License-Identifier: Apache-2.0
#include "sim/camera/parallax_map.h"

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

namespace horopter::sim {
namespace {

constexpr int kFarthestReach_px = 24;
constexpr double kAgree_px = 0.02;
constexpr int kSteps = 4;

}  // namespace

void ParallaxMap::Make(const cv::Mat1f& depth, double farthest_m, double focal_px) {
  focal_px_ = focal_px;
  inverse_.create(depth.size());
  for (int y = 0; y < depth.rows; ++y) {
    for (int x = 0; x < depth.cols; ++x) inverse_(y, x) = 1 / depth(y, x);  // 1 / inf = 0
  }
  double largest = 0;
  cv::minMaxLoc(inverse_, nullptr, &largest);
  const int reach = static_cast<int>(
      std::min<double>(kFarthestReach_px, std::ceil(farthest_m * focal_px * largest)));
  if (reach == 0) {
    nearest_ = inverse_;
    return;
  }
  nearest_ = cv::Mat1f();  // it may be the other map's memory
  const cv::Size window(2 * reach + 1, 2 * reach + 1);
  cv::dilate(inverse_, nearest_, cv::getStructuringElement(cv::MORPH_RECT, window));
}

float ParallaxMap::At(const cv::Mat1f& map, float u, float v) const {
  const float column = std::clamp(u, 0.0F, static_cast<float>(map.cols - 1));
  const float row = std::clamp(v, 0.0F, static_cast<float>(map.rows - 1));
  return map(static_cast<int>(row + 0.5F), static_cast<int>(column + 0.5F));
}

void ParallaxMap::Solve(const Eigen::Matrix3f& H, const Eigen::Vector3f& e, const float* x,
                        const float* y, int width, float* w) const {
  const float shift_px = e.head<2>().norm() + std::abs(e.z()) * static_cast<float>(focal_px_);
  const float agree = static_cast<float>(kAgree_px) / std::max(1e-9F, shift_px);
  for (int i = 0; i < width; ++i) {
    const Eigen::Vector3f a = H * Eigen::Vector3f(x[i], y[i], 1);
    // What the map shows where the ray is seen if it hits at `inverse`, as inverse depth along it.
    const auto shown = [&](const cv::Mat1f& map, float inverse) {
      const Eigen::Vector3f at = a + inverse * e;
      const float depth = At(map, at.x() / at.z(), at.y() / at.z());
      return depth * a.z() / std::max(1e-6F, 1 - depth * e.z());
    };
    float guess = shown(nearest_, 0), found = shown(inverse_, guess);
    for (int step = 1; step < kSteps && std::abs(found - guess) > agree; ++step) {
      guess = found;
      found = shown(inverse_, guess);
    }
    w[i] = std::abs(found - guess) > agree ? std::max(found, guess) : found;
  }
}

}  // namespace horopter::sim
