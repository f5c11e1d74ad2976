// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>
#include <vector>

#include "hardware/types/camera_model.h"

namespace horopter::sim {

/// Smooth bright spots on black: their centroids say where a direction is seen, to about 0.01 px.
inline constexpr double kSpotSigma_px = 2.5;

/// Directions whose pixels, as `camera` sees them, form a grid that keeps clear of the border and
/// of one another.
inline std::vector<Eigen::Vector3d> SpotDirections(const hardware::CameraModel& camera) {
  constexpr int kColumns = 9, kRows = 7, kBorder = 16;
  std::vector<Eigen::Vector3d> rays;
  for (int row = 0; row < kRows; ++row) {
    for (int column = 0; column < kColumns; ++column) {
      const double x = kBorder + 0.37 + (camera.width() - 2.0 * kBorder) * column / (kColumns - 1);
      const double y = kBorder + 0.21 + (camera.height() - 2.0 * kBorder) * row / (kRows - 1);
      if (const auto ray = camera.Unproject({x, y})) rays.push_back(*ray);
    }
  }
  return rays;
}

/// What a pinhole camera sees of spots in these directions.
inline cv::Mat3b SpotsSeenBy(const hardware::CameraModel& pinhole,
                             const std::vector<Eigen::Vector3d>& rays) {
  constexpr int kReach = 12;
  cv::Mat1f light = cv::Mat1f::zeros(pinhole.height(), pinhole.width());
  for (const Eigen::Vector3d& ray : rays) {
    const auto centre = pinhole.Project(ray);
    if (!centre) continue;
    for (int dy = -kReach; dy <= kReach; ++dy) {
      for (int dx = -kReach; dx <= kReach; ++dx) {
        const int x = static_cast<int>(std::lround(centre->x())) + dx;
        const int y = static_cast<int>(std::lround(centre->y())) + dy;
        if (x < 0 || y < 0 || x >= light.cols || y >= light.rows) continue;
        const double r2 = (Eigen::Vector2d(x, y) - *centre).squaredNorm();
        light(y, x) +=
            static_cast<float>(250 * std::exp(-r2 / (2 * kSpotSigma_px * kSpotSigma_px)));
      }
    }
  }
  cv::Mat1b grey;
  light.convertTo(grey, CV_8U);
  cv::Mat3b bgr;
  cv::merge(std::vector<cv::Mat>{grey, grey, grey}, bgr);
  return bgr;
}

/// Centre of gravity of the light around a pixel.
inline Eigen::Vector2d CentroidAround(const cv::Mat3b& image, const Eigen::Vector2d& guess,
                                      int reach = 8) {
  Eigen::Vector2d moment = Eigen::Vector2d::Zero();
  double mass = 0;
  const int x0 = static_cast<int>(std::lround(guess.x()));
  const int y0 = static_cast<int>(std::lround(guess.y()));
  for (int y = std::max(0, y0 - reach); y <= std::min(image.rows - 1, y0 + reach); ++y) {
    for (int x = std::max(0, x0 - reach); x <= std::min(image.cols - 1, x0 + reach); ++x) {
      const double light = image(y, x)[1];
      moment += light * Eigen::Vector2d(x, y);
      mass += light;
    }
  }
  return moment / mass;
}

}  // namespace horopter::sim
