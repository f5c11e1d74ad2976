// SPDX-License-Identifier: Apache-2.0
#include "sim/camera/lens_resampler.h"

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>

#include "sim/camera/bilinear_row.h"

namespace horopter::sim {
namespace {

using hardware::CameraModel;

constexpr double kInstantSpacing_px = 1.5;
constexpr int kMostInstants = 96;
/// A direction this far off the axis or beyond is taken to lie there, lest a bound be infinite.
constexpr double kLeastCosine = 0.05;

Eigen::Matrix3d IntrinsicMatrix(const CameraModel& camera) {
  const hardware::Intrinsics& in = camera.intrinsics();
  Eigen::Matrix3d K;
  K << in.fx, 0, in.cx, 0, in.fy, in.cy, 0, 0, 1;
  return K;
}

}  // namespace

LensResampler::LensResampler(const CameraModel& camera, const RowExposure& exposure)
    : map_(camera), exposure_(exposure) {}

TanBounds LensResampler::Bounds(const EyeMotion& motion) const {
  constexpr int kRowStep = 4, kColumns = 9;
  TanBounds bounds;
  const int width = camera().width(), height = camera().height();
  const auto include_row = [&](int row) {
    for (const double end : {-0.5, 0.5}) {
      const Eigen::Matrix3d R_MC = motion.At(exposure_.Middle(row) + end * exposure_.time_s());
      for (int k = 0; k < kColumns; ++k) {
        const Eigen::Vector3d ray =
            R_MC * map_.Ray(row, k * (width - 1) / (kColumns - 1)).cast<double>();
        bounds.Include(ray.head<2>().array() / std::max(ray.z(), kLeastCosine));
      }
    }
  };
  for (int row = 0; row < height; row += kRowStep) include_row(row);
  for (int row = std::max(0, height - 2); row < height; ++row) include_row(row);
  // Between the samples: a pixel, which is more than distorted rows bend or a saccade turns there.
  const double pixel = 1 / std::min(camera().intrinsics().fx, camera().intrinsics().fy);
  bounds.low -= pixel;
  bounds.high += pixel;
  bounds.Include(map_.bounds());
  return bounds;
}

int LensResampler::Instants(int row, const Eigen::Matrix3d& K, const EyeMotion& motion) const {
  if (exposure_.time_s() == 0) return 1;
  const double middle = exposure_.Middle(row), half = exposure_.time_s() / 2;
  const Eigen::Matrix3d first = K * motion.At(middle - half), last = K * motion.At(middle + half);
  double longest = 0;
  for (const int column : {0, camera().width() / 2, camera().width() - 1}) {
    const Eigen::Vector3d ray = map_.Ray(row, column).cast<double>();
    const Eigen::Vector2d path = (last * ray).hnormalized() - (first * ray).hnormalized();
    longest = std::max(longest, path.norm());
  }
  return std::clamp(static_cast<int>(std::ceil(longest / kInstantSpacing_px)), 1, kMostInstants);
}

void LensResampler::Resample(const cv::Mat3b& view, const CameraModel& pinhole,
                             const EyeMotion& motion, cv::Mat3b& image) const {
  CV_Assert(view.cols == pinhole.width() && view.rows == pinhole.height());
  CV_Assert(image.cols == camera().width() && image.rows == camera().height());
  const Eigen::Matrix3d K = IntrinsicMatrix(pinhole);
  cv::parallel_for_(cv::Range(0, image.rows), [&](const cv::Range& rows) {
    thread_local BilinearRow sampler;  // keeps its memory from frame to frame
    for (int row = rows.start; row < rows.end; ++row) {
      const int instants = Instants(row, K, motion);
      sampler.Start(image.cols);
      for (int i = 0; i < instants; ++i) {
        const double share = (i + 0.5) / instants - 0.5;
        const double t_s = exposure_.Middle(row) + share * exposure_.time_s();
        const Eigen::Matrix3f H = (K * motion.At(t_s)).cast<float>();
        sampler.Add(view, H, map_.x(row), map_.y(row));
      }
      sampler.Store(image.ptr<std::uint8_t>(row));
    }
  });
}

}  // namespace horopter::sim
