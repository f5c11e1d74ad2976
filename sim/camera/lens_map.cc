// SPDX-License-Identifier: Apache-2.0
#include "sim/camera/lens_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <opencv2/core.hpp>

#include "sim/camera/bilinear_row.h"

namespace horopter::sim {
namespace {

using hardware::CameraModel;
using hardware::ConfigError;
using hardware::Intrinsics;

constexpr double kWidestTangent = 11.43;  // 85 deg
/// Around what is needed: one pixel to the left and above; to the right two, since the resampler
/// reads in whole words.
constexpr int kMarginBefore = 1;
constexpr int kMarginAfter = 2;

[[noreturn]] void Refuse(const CameraModel& camera, int x, int y, const char* why) {
  const hardware::Distortion& d = camera.distortion();
  throw ConfigError({{"camera.distortion",
                      fmt::format("({:g}, {:g}, {:g}, {:g}, {:g})", d.k1, d.k2, d.p1, d.p2, d.k3),
                      fmt::format("{} at pixel ({}, {}): give less distortion or a narrower field "
                                  "of view",
                                  why, x, y)}});
}

/// How far an interval of tangents reaches in pixels: the first and the last that are needed.
struct Reach {
  Reach(double low, double high, double focal, double centre)
      : first(static_cast<int>(std::floor(focal * low + centre + kSlack)) - kMarginBefore),
        last(static_cast<int>(std::ceil(focal * high + centre - kSlack)) + kMarginAfter) {}
  int size() const { return last - first + 1; }

  static constexpr double kSlack = 1e-6;  // float rounding shall not cost a row
  int first;
  int last;
};

}  // namespace

LensMap::LensMap(const CameraModel& camera)
    : camera_(camera),
      x_(camera.height(), static_cast<int>(BilinearRow::RoundedUp(camera.width()))),
      y_(x_.size()) {
  const Intrinsics& in = camera.intrinsics();
  std::atomic<int> bad_pixel{-1};
  cv::parallel_for_(cv::Range(0, in.height), [&](const cv::Range& rows) {
    for (int y = rows.start; y < rows.end; ++y) {
      for (int x = 0; x < in.width; ++x) {
        const auto ray = camera.Unproject({x, y});
        if (!ray || ray->head<2>().cwiseAbs().maxCoeff() > kWidestTangent) {
          bad_pixel = y * in.width + x;
          return;
        }
        x_(y, x) = static_cast<float>(ray->x());
        y_(y, x) = static_cast<float>(ray->y());
      }
      for (int x = in.width; x < x_.cols; ++x) {
        x_(y, x) = x_(y, in.width - 1);
        y_(y, x) = y_(y, in.width - 1);
      }
    }
  });
  if (bad_pixel >= 0) {
    const int x = bad_pixel % in.width, y = bad_pixel / in.width;
    Refuse(camera, x, y,
           camera.Unproject({x, y}) ? "the view is wider than 85 deg off the axis"
                                    : "no ray reaches the image");
  }
  double low = 0, high = 0;
  cv::minMaxLoc(x_, &low, &high);
  bounds_.low.x() = low, bounds_.high.x() = high;
  cv::minMaxLoc(y_, &low, &high);
  bounds_.low.y() = low, bounds_.high.y() = high;
}

double LensMap::PixelsPerPixel() const {
  const Intrinsics& in = camera_.intrinsics();
  const double f = std::max(in.fx, in.fy);
  double area = 0;  // of the quadrangles between pixels, on the plane z = 1
  for (int y = 0; y + 1 < in.height; ++y) {
    for (int x = 0; x + 1 < in.width; ++x) {
      const Eigen::Vector2d along = (Ray(y + 1, x + 1) - Ray(y, x)).head<2>().cast<double>();
      const Eigen::Vector2d across = (Ray(y + 1, x) - Ray(y, x + 1)).head<2>().cast<double>();
      area += std::abs(along.x() * across.y() - along.y() * across.x()) / 2;
    }
  }
  return f * f * area / std::max(1, (in.width - 1) * (in.height - 1));
}

CameraModel CoveringPinhole(const CameraModel& camera, const TanBounds& bounds, cv::Size largest,
                            double scale) {
  const Intrinsics& in = camera.intrinsics();
  const double f = scale * std::max(in.fx, in.fy);
  const Reach across(bounds.low.x(), bounds.high.x(), f, in.cx);
  const Reach down(bounds.low.y(), bounds.high.y(), f, in.cy);
  if (across.size() <= largest.width && down.size() <= largest.height) {
    return CameraModel(
        {across.size(), down.size(), f, f, in.cx - across.first, in.cy - down.first});
  }
  constexpr int kMargins = kMarginBefore + kMarginAfter + 1;
  const Eigen::Array2d extent = bounds.high - bounds.low;
  const double shorter = std::min(
      {f, (largest.width - kMargins) / extent.x(), (largest.height - kMargins) / extent.y()});
  return CameraModel({largest.width, largest.height, shorter, shorter,
                      kMarginBefore - shorter * bounds.low.x(),
                      kMarginBefore - shorter * bounds.low.y()});
}

}  // namespace horopter::sim
