// SPDX-License-Identifier: Apache-2.0
#include "sim/camera/eye_camera.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <utility>

namespace horopter::sim {
namespace {

using hardware::CameraModel;

constexpr double kFastestTurn_rad_s = 10;
constexpr double kFastestMove_m_s = 1;
constexpr double kVisible_px = 0.002;
/// A shift of what is this near says how many views a moving eye needs.
constexpr double kNear_m = 0.5;
/// Less parallax than this is left out.
constexpr double kVisibleParallax_px = 0.02;
constexpr int kMostBands = 16;

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
    motion.Add(t_s, Eigen::AngleAxisd(kFastestTurn_rad_s * t_s, axis).toRotationMatrix(),
               kFastestMove_m_s * t_s * axis.cross(Eigen::Vector3d::UnitZ()));
  }
  return motion;
}

/// The view's pixels in one of the image, along a side. A lens that is coarser off its axis than on
/// it would need most of them where it shows least: they may be as many as the image's, as long as
/// its blur leaves no more than kHiddenContrast of what is too fine for the view.
double ViewScale(const LensMap& map, double blur_px) {
  constexpr double kHiddenContrast = 0.3;
  if (blur_px == 0) return 1;
  // A Gaussian of sigma s leaves exp(-2 (pi s f)^2) at f = scale / 2 cycles per pixel.
  const double blurred = std::sqrt(-2 * std::log(kHiddenContrast)) / (M_PI * blur_px);
  return std::min(1.0, std::max(blurred, 1 / std::sqrt(map.PixelsPerPixel())));
}

/// An image to be written: in the memory of a view that has been read, where nobody else needs it.
/// New memory costs as much as resampling: the system clears it page by page.
cv::Mat3b InPlaceOf(const cv::Mat3b& view, cv::Size size) {
  const bool is_free = view.u != nullptr && view.u->refcount == 1 && view.isContinuous() &&
                       view.total() >= static_cast<std::size_t>(size.area());
  if (!is_free) return cv::Mat3b(size);
  return view.reshape(0, 1).colRange(0, size.area()).reshape(0, size.height);
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
      lens_(model, exposure_),
      view_scale_(distorts_ ? ViewScale(lens_.map(), blur_px_) : 1) {
  TanBounds widest = lens_.map().bounds();
  still_view_ =
      distorts_ ? CoveringPinhole(model, widest, {kNoLimit, kNoLimit}, view_scale_) : model;
  largest_view_ = {still_view_->width(), still_view_->height()};
  if (exposure_.window_s() == 0) return;
  for (const Eigen::Vector3d& axis : {Eigen::Vector3d(0, 1, 0), Eigen::Vector3d(0, -1, 0),
                                      Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(-1, 0, 0)}) {
    widest.Include(lens_.Bounds(lens_.AllRows(), FastestTurn(axis, exposure_.window_s())));
  }
  const CameraModel covering = CoveringPinhole(model, widest, {kNoLimit, kNoLimit}, view_scale_);
  largest_view_ = {covering.width(), covering.height()};
}

bool EyeCamera::Still(const EyeMotion& motion) const {
  if (exposure_.window_s() == 0) return true;
  const double focal = std::max(model_.intrinsics().fx, model_.intrinsics().fy);
  return motion.LargestAngle() * focal < kVisible_px &&
         motion.LargestShift() * focal / kNear_m < kVisibleParallax_px;
}

std::vector<EyeCamera::Band> EyeCamera::Bands(double parallax_px) const {
  if (parallax_px < kVisibleParallax_px) return {{lens_.AllRows(), 0}};
  const int rows = model_.height();
  if (exposure_.kind() == Shutter::kInterlaced) {
    std::vector<Band> fields{{{0, rows, 2}, exposure_.Middle(0)}};
    if (rows > 1) fields.push_back({{1, rows, 2}, exposure_.Middle(1)});
    return fields;
  }
  const int count =
      std::clamp(static_cast<int>(std::ceil(parallax_px)), 1, std::min(kMostBands, rows));
  std::vector<Band> bands;
  for (int i = 0; i < count; ++i) {
    const int first = rows * i / count, end = rows * (i + 1) / count;
    bands.push_back({{first, end}, (exposure_.Middle(first) + exposure_.Middle(end - 1)) / 2});
  }
  return bands;
}

std::vector<ViewPlan> EyeCamera::Views(const EyeMotion& motion) const {
  if (Still(motion)) return {{lens_.AllRows(), 0, *still_view_, false}};
  const double focal = std::max(model_.intrinsics().fx, model_.intrinsics().fy);
  const double rows_apart_px = lens_.FarthestCentre(lens_.AllRows(), motion) * focal / kNear_m;
  const bool moves = motion.LargestShift() * focal / kNear_m >= kVisibleParallax_px;
  std::vector<ViewPlan> plans;
  for (const Band& band : Bands(rows_apart_px)) {
    const EyeMotion seen = motion.SeenFrom(motion.PoseAt(band.t_s));
    plans.push_back(
        {band.rows, band.t_s,
         CoveringPinhole(model_, lens_.Bounds(band.rows, seen), largest_view_, view_scale_),
         moves});
  }
  return plans;
}

CameraModel EyeCamera::View(const EyeMotion& motion) const { return Views(motion).front().camera; }

cv::Mat3b EyeCamera::Develop(cv::Mat3b view, const EyeMotion& motion, std::uint64_t frame) {
  const std::vector<ViewPlan> plans = Views(motion);
  CV_Assert(plans.size() == 1 && !plans.front().needs_depth);
  std::vector<LensView> views(1);
  views.front().bgr = std::move(view);
  return Develop(plans, std::move(views), motion, frame);
}

void EyeCamera::Blur(const cv::Mat3b& sharp, cv::Mat3b& image) const {
  const int size = 2 * static_cast<int>(std::ceil(3 * blur_px_)) + 1;
  cv::GaussianBlur(sharp, image, {size, size}, blur_px_, blur_px_, cv::BORDER_REPLICATE);
}

cv::Mat3b EyeCamera::Focus(const std::vector<ViewPlan>& plans, const std::vector<LensView>& views,
                           const EyeMotion& motion) {
  const bool still = Still(motion);
  const cv::Size size(model_.width(), model_.height());
  const cv::Mat3b& first = views.front().bgr;
  if (!distorts_ && still && blur_px_ == 0) return first;
  // Each step writes into scratch_, and what it has read becomes the next step's.
  scratch_.create(size);
  if (!distorts_ && still) {
    Blur(first, scratch_);
    return std::exchange(scratch_, InPlaceOf(first, size));
  }
  for (std::size_t i = 0; i < plans.size(); ++i) {
    lens_.Resample(plans[i], views[i], still ? EyeMotion() : motion, scratch_);
  }
  cv::Mat3b image = std::exchange(scratch_, InPlaceOf(first, size));
  if (blur_px_ == 0) return image;
  Blur(image, scratch_);
  return std::exchange(scratch_, std::move(image));
}

cv::Mat3b EyeCamera::Develop(const std::vector<ViewPlan>& plans, std::vector<LensView> views,
                             const EyeMotion& motion, std::uint64_t frame, double light) {
  CV_Assert(plans.size() == views.size() && !plans.empty());
  cv::Mat3b image = Focus(plans, views, motion);
  sensor_.Apply(frame, image, light);
  return image;
}

}  // namespace horopter::sim
