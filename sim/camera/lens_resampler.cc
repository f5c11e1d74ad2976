// SPDX-License-Identifier: Apache-2.0
#include "sim/camera/lens_resampler.h"

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>

#include "sim/camera/bilinear_row.h"

namespace horopter::sim {
namespace {

using hardware::CameraModel;

constexpr double kInstantSpacing_px = 1.75;
constexpr int kMostInstants = 96;
/// The ends of a comb may miss their places by half of this.
constexpr double kCombTolerance_px = 1.0;
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
  // Between the samples: a pixel, which is more than distorted rows bend or a saccade turns there;
  // another for the ends of a comb.
  const double pixel = (exposure_.time_s() > 0 ? 2 : 1) /
                       std::min(camera().intrinsics().fx, camera().intrinsics().fy);
  bounds.low -= pixel;
  bounds.high += pixel;
  bounds.Include(map_.bounds());
  return bounds;
}

Eigen::Vector2d LensResampler::Way(int row, int column, const Eigen::Matrix3d& K,
                                   const EyeMotion& motion) const {
  const double middle = exposure_.Middle(row), half = exposure_.time_s() / 2;
  const Eigen::Vector3d ray = map_.Ray(row, column).cast<double>();
  return (K * motion.At(middle + half) * ray).hnormalized() -
         (K * motion.At(middle - half) * ray).hnormalized();
}

int LensResampler::Instants(int row, const Eigen::Matrix3d& K, const EyeMotion& motion) const {
  if (exposure_.time_s() == 0) return 1;
  double longest = 0;
  for (const int column : {0, camera().width() / 2, camera().width() - 1}) {
    longest = std::max(longest, Way(row, column, K, motion).norm());
  }
  return std::clamp(static_cast<int>(std::ceil(longest / kInstantSpacing_px)), 1, kMostInstants);
}

LensResampler::RowPlan LensResampler::Plan(int row, const Eigen::Matrix3d& K,
                                           const EyeMotion& motion, const MotionComb& comb) const {
  const int instants = Instants(row, K, motion);
  for (int level = comb.levels() - 1; level > 0; --level) {
    const int taps = MotionComb::Taps(level);
    const int groups = (instants + taps - 1) / taps;
    if (groups < 2) continue;
    double worst = 0;
    for (const int column : {0, camera().width() / 2, camera().width() - 1}) {
      const Eigen::Vector2d wanted =
          Way(row, column, K, motion) * (taps - 1) / static_cast<double>(taps * groups);
      worst = std::max(worst, (wanted - comb.Extent(level)).norm());
    }
    if (worst > kCombTolerance_px) continue;
    // Spread the groups so that blur by them and by the comb is as wide as by all the instants.
    const double way2 = Way(row, camera().width() / 2, K, motion).squaredNorm();
    const double all = way2 / 12, spread = all * (1 - 1.0 / (groups * groups));
    const double share = std::sqrt(std::max(0.0, all - comb.Variance(level)) / spread);
    return {level, groups, std::clamp(share, 0.7, 1.3)};
  }
  return {0, instants, 1};
}

void LensResampler::Resample(const cv::Mat3b& view, const CameraModel& pinhole,
                             const EyeMotion& motion, cv::Mat3b& image) const {
  CV_Assert(view.cols == pinhole.width() && view.rows == pinhole.height());
  CV_Assert(image.cols == camera().width() && image.rows == camera().height());
  const Eigen::Matrix3d K = IntrinsicMatrix(pinhole);
  const int middle_row = image.rows / 2;
  const int instants = Instants(middle_row, K, motion);
  const Eigen::Vector2d step = Way(middle_row, image.cols / 2, K, motion) / instants;
  comb_.Make(view, step, instants < 4 ? 1 : instants < 7 ? 2 : 3);
  cv::parallel_for_(cv::Range(0, image.rows), [&](const cv::Range& rows) {
    thread_local BilinearRow sampler;  // keeps its memory from frame to frame
    for (int row = rows.start; row < rows.end; ++row) {
      const RowPlan plan = Plan(row, K, motion, comb_);
      Eigen::Matrix3d to_level = K;  // the comb's copies go from a place on; we want them around it
      to_level.row(0) -= comb_.Extent(plan.level).x() / 2 * Eigen::RowVector3d::UnitZ();
      to_level.row(1) -= comb_.Extent(plan.level).y() / 2 * Eigen::RowVector3d::UnitZ();
      sampler.Start(image.cols);
      for (int i = 0; i < plan.instants; ++i) {
        const double part = plan.share * ((i + 0.5) / plan.instants - 0.5);
        const double t_s = exposure_.Middle(row) + part * exposure_.time_s();
        const Eigen::Matrix3f H = (to_level * motion.At(t_s)).cast<float>();
        sampler.Add(comb_.image(plan.level), H, map_.x(row), map_.y(row));
      }
      sampler.Store(image.ptr<std::uint8_t>(row));
    }
  });
}

}  // namespace horopter::sim
