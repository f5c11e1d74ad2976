// SPDX-License-Identifier: Apache-2.0
#include "sim/camera/eye_camera.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace horopter::sim {
namespace {

using hardware::CameraModel;

constexpr double kFastestTurn_rad_s = 10;
constexpr double kVisible_px = 0.002;

/// A profile that holds, or ConfigError: the members after it rely on that.
const CameraProfile& Checked(const CameraProfile& profile) {
  hardware::ThrowIfAny(profile.Validate());
  return profile;
}

bool IsPinhole(const CameraModel& model) {
  constexpr double kSquare = 1e-9;
  const hardware::Intrinsics& in = model.intrinsics();
  return !model.distortion().any() && std::abs(in.fx - in.fy) <= kSquare * in.fx;
}

/// As fast as an eye may turn, about one axis, through an exposure window.
EyeMotion FastestTurn(const Eigen::Vector3d& axis, double window_s) {
  EyeMotion motion;
  for (const double t_s : {-window_s / 2, window_s / 2}) {
    motion.Add(t_s, Eigen::AngleAxisd(kFastestTurn_rad_s * t_s, axis).toRotationMatrix());
  }
  return motion;
}

/// No view is larger, whatever the lens: what GL renders at most.
constexpr int kNoLimit = 8192;

}  // namespace

EyeCamera::EyeCamera(const CameraModel& model, const CameraProfile& profile, std::uint64_t seed,
                     std::string_view name)
    : model_(model),
      exposure_(Checked(profile).shutter, profile.exposure, model.height()),
      blur_px_(profile.lens.blur_px),
      sensor_(profile, model, seed, name),
      distorts_(!IsPinhole(model)),
      lens_(model, exposure_) {
  TanBounds widest = lens_.map().bounds();
  still_view_ = distorts_ ? CoveringPinhole(model, lens_.Bounds({}), {kNoLimit, kNoLimit}) : model;
  largest_view_ = {still_view_->width(), still_view_->height()};
  if (exposure_.window_s() == 0) return;
  for (const Eigen::Vector3d& axis : {Eigen::Vector3d(0, 1, 0), Eigen::Vector3d(0, -1, 0),
                                      Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(-1, 0, 0)}) {
    widest.Include(lens_.Bounds(FastestTurn(axis, exposure_.window_s())));
  }
  const CameraModel covering = CoveringPinhole(model, widest, {kNoLimit, kNoLimit});
  largest_view_ = {covering.width(), covering.height()};
}

bool EyeCamera::Still(const EyeMotion& motion) const {
  if (exposure_.window_s() == 0) return true;
  const hardware::Intrinsics& in = model_.intrinsics();
  return motion.LargestAngle() * std::max(in.fx, in.fy) < kVisible_px;
}

CameraModel EyeCamera::View(const EyeMotion& motion) const {
  if (Still(motion)) return *still_view_;
  return CoveringPinhole(model_, lens_.Bounds(motion), largest_view_);
}

cv::Mat3b EyeCamera::Scratch() {
  scratch_.create(model_.height(), model_.width());
  return scratch_;
}

cv::Mat3b EyeCamera::Develop(cv::Mat3b view, const EyeMotion& motion, std::uint64_t frame) {
  const bool still = Still(motion);
  const bool resample = distorts_ || !still;
  cv::Mat3b image = resample || blur_px_ > 0 ? cv::Mat3b(model_.height(), model_.width()) : view;
  cv::Mat3b sharp = view;
  if (resample) {
    sharp = blur_px_ > 0 ? Scratch() : image;
    const CameraModel pinhole = still ? *still_view_ : View(motion);
    lens_.Resample(view, pinhole, still ? EyeMotion() : motion, sharp);
  }
  if (blur_px_ > 0) {
    const int size = 2 * static_cast<int>(std::ceil(3 * blur_px_)) + 1;
    cv::GaussianBlur(sharp, image, {size, size}, blur_px_, blur_px_, cv::BORDER_REPLICATE);
  }
  sensor_.Apply(frame, image);
  return image;
}

}  // namespace horopter::sim
