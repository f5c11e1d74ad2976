// SPDX-License-Identifier: Apache-2.0
#include "sim/camera/lens_resampler.h"

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>
#include <vector>

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
/// Of what a view must show though the eye is elsewhere [1/m].
constexpr double kLargestInverseDepth = 1 / 0.2;

Eigen::Matrix3d IntrinsicMatrix(const CameraModel& camera) {
  const hardware::Intrinsics& in = camera.intrinsics();
  Eigen::Matrix3d K;
  K << in.fx, 0, in.cx, 0, in.fy, in.cy, 0, 0, 1;
  return K;
}

}  // namespace

LensResampler::LensResampler(const CameraModel& camera, const RowExposure& exposure)
    : map_(camera), exposure_(exposure) {}

TanBounds LensResampler::Bounds(const RowBand& rows, const EyeMotion& motion) const {
  constexpr int kRowStep = 4, kColumns = 9;
  TanBounds bounds;
  const int width = camera().width();
  const auto include = [&](const Eigen::Vector3d& ray) {
    bounds.Include(ray.head<2>().array() / std::max(ray.z(), kLeastCosine));
  };
  const auto include_row = [&](int row) {
    for (const double end : {-0.5, 0.5}) {
      const EyePlace at = motion.At(exposure_.Middle(row) + end * exposure_.time_s());
      for (int k = 0; k < kColumns; ++k) {
        const Eigen::Vector3d ray =
            at.R_MC * map_.Ray(row, k * (width - 1) / (kColumns - 1)).cast<double>();
        include(ray);
        include(ray + kLargestInverseDepth * at.p_MC);
      }
    }
  };
  for (int i = 0; i < rows.count(); i += kRowStep) include_row(rows.row(i));
  for (int i = std::max(0, rows.count() - 2); i < rows.count(); ++i) include_row(rows.row(i));
  // Between the samples: a pixel, which is more than distorted rows bend or a saccade turns there;
  // another for the ends of a comb.
  const double pixel = (exposure_.time_s() > 0 ? 2 : 1) /
                       std::min(camera().intrinsics().fx, camera().intrinsics().fy);
  bounds.low -= pixel;
  bounds.high += pixel;
  if (rows.count() == camera().height()) bounds.Include(map_.bounds());
  return bounds;
}

LensResampler::Ways LensResampler::WaysOf(const Row& row, const Eigen::Matrix3d& K,
                                          const EyeMotion& motion) const {
  Ways ways;
  ways.fill(Eigen::Vector2d::Zero());
  if (exposure_.time_s() == 0) return ways;
  const double middle = exposure_.Middle(row.y), half = exposure_.time_s() / 2;
  const EyePlace begin = motion.At(middle - half), end = motion.At(middle + half);
  const int columns[] = {0, camera().width() / 2, camera().width() - 1};
  for (std::size_t i = 0; i < ways.size(); ++i) {
    const Eigen::Vector3d ray = map_.Ray(row.y, columns[i]).cast<double>();
    const double w = row.w == nullptr ? 0 : row.w[columns[i]];
    const auto pixel = [&](const EyePlace& at) -> Eigen::Vector2d {
      return (K * (at.R_MC * ray + w * at.p_MC)).hnormalized();
    };
    ways[i] = pixel(end) - pixel(begin);
  }
  return ways;
}

int LensResampler::Instants(const Ways& ways) {
  double longest = 0;
  for (const Eigen::Vector2d& way : ways) longest = std::max(longest, way.norm());
  return std::clamp(static_cast<int>(std::ceil(longest / kInstantSpacing_px)), 1, kMostInstants);
}

LensResampler::RowPlan LensResampler::Plan(const Ways& ways) const {
  const int instants = Instants(ways);
  for (int level = comb_.levels() - 1; level > 0; --level) {
    const int taps = MotionComb::Taps(level);
    const int groups = (instants + taps - 1) / taps;
    if (groups < 2) continue;
    double worst = 0;
    for (const Eigen::Vector2d& way : ways) {
      const Eigen::Vector2d wanted = way * (taps - 1) / static_cast<double>(taps * groups);
      worst = std::max(worst, (wanted - comb_.Extent(level)).norm());
    }
    if (worst > kCombTolerance_px) continue;
    // Spread the groups so that blur by them and by the comb is as wide as by all the instants.
    const double way2 = ways[kMiddle].squaredNorm();
    const double all = way2 / 12, spread = all * (1 - 1.0 / (groups * groups));
    const double share = std::sqrt(std::max(0.0, all - comb_.Variance(level)) / spread);
    return {level, groups, std::clamp(share, 0.7, 1.3)};
  }
  return {0, instants, 1};
}

void LensResampler::SolveParallax(int y, const Eigen::Matrix3d& K, const EyeMotion& motion,
                                  float* w) const {
  const EyePlace at = motion.At(exposure_.Middle(y));
  parallax_.Solve((K * at.R_MC).cast<float>(), (K * at.p_MC).cast<float>(), map_.x(y), map_.y(y),
                  static_cast<int>(BilinearRow::RoundedUp(camera().width())), w);
}

double LensResampler::FarthestCentre(const RowBand& rows, const EyeMotion& motion) const {
  double farthest_m = 0;
  for (int i = 0; i < rows.count(); ++i) {
    farthest_m = std::max(farthest_m, motion.At(exposure_.Middle(rows.row(i))).p_MC.norm());
  }
  return farthest_m;
}

void LensResampler::MakeComb(const ViewPlan& plan, const LensView& view, const Eigen::Matrix3d& K,
                             const EyeMotion& motion) const {
  std::vector<float> w(BilinearRow::RoundedUp(camera().width()));
  const int middle_row = plan.rows.row(plan.rows.count() / 2);
  if (plan.needs_depth) SolveParallax(middle_row, K, motion, w.data());
  const Row row{middle_row, plan.needs_depth ? w.data() : nullptr};
  const Ways ways = WaysOf(row, K, motion);
  const int instants = Instants(ways);
  const Eigen::Vector2d step = ways[kMiddle] / instants;
  comb_.Make(view.bgr, step, instants < 4 ? 1 : instants < 7 ? 2 : 3);
}

void LensResampler::Resample(const ViewPlan& plan, const LensView& view, const EyeMotion& motion,
                             cv::Mat3b& image) const {
  CV_Assert(view.bgr.cols == plan.camera.width() && view.bgr.rows == plan.camera.height());
  CV_Assert(image.cols == camera().width() && image.rows == camera().height());
  const EyeMotion seen = motion.SeenFrom(motion.PoseAt(plan.t_s));
  const Eigen::Matrix3d K = IntrinsicMatrix(plan.camera);
  if (plan.needs_depth) {
    CV_Assert(view.depth.size() == view.bgr.size());
    parallax_.Make(view.depth, FarthestCentre(plan.rows, seen), plan.camera.intrinsics().fx);
  }
  MakeComb(plan, view, K, seen);
  cv::parallel_for_(cv::Range(0, plan.rows.count()), [&](const cv::Range& part) {
    thread_local BilinearRow sampler;  // these keep their memory from frame to frame
    thread_local std::vector<float> w;
    w.resize(BilinearRow::RoundedUp(image.cols));
    for (int k = part.start; k < part.end; ++k) {
      const int y = plan.rows.row(k);
      if (plan.needs_depth) SolveParallax(y, K, seen, w.data());
      const Row row{y, plan.needs_depth ? w.data() : nullptr};
      const RowPlan sums = Plan(WaysOf(row, K, seen));
      Eigen::Matrix3d to_level = K;  // the comb's copies go from a place on; we want them around it
      to_level.row(0) -= comb_.Extent(sums.level).x() / 2 * Eigen::RowVector3d::UnitZ();
      to_level.row(1) -= comb_.Extent(sums.level).y() / 2 * Eigen::RowVector3d::UnitZ();
      sampler.Start();
      for (int i = 0; i < sums.instants; ++i) {
        const double part_of = sums.share * ((i + 0.5) / sums.instants - 0.5);
        const EyePlace at = seen.At(exposure_.Middle(y) + part_of * exposure_.time_s());
        sampler.Add(comb_.image(sums.level), (to_level * at.R_MC).cast<float>(),
                    (to_level * at.p_MC).cast<float>());
      }
      sampler.Store({map_.x(y), map_.y(y), row.w, image.cols}, image.ptr<std::uint8_t>(y));
    }
  });
  comb_.ForgetView();
}

}  // namespace horopter::sim
