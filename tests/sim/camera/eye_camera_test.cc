// SPDX-License-Identifier: Apache-2.0
#include "sim/camera/eye_camera.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "tests/sim/camera/spots.h"

namespace horopter::sim {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using hardware::CameraModel;
using hardware::Distortion;

struct Lens {
  const char* name;
  hardware::Intrinsics intrinsics;
  Distortion distortion;
};

void PrintTo(const Lens& lens, std::ostream* out) { *out << lens.name; }

const hardware::Intrinsics kVga{640, 480, 560, 560, 319.5, 239.5};

/// Turns an eye at a constant speed, sampled like physics steps of 2 ms.
EyeMotion Turning(const Vector3d& speed_rad_s, double half_window_s) {
  EyeMotion motion;
  const int steps = static_cast<int>(std::ceil(half_window_s / 0.002));
  for (int i = -steps; i <= steps; ++i) {
    const double t_s = i * 0.002;
    const double angle = speed_rad_s.norm() * t_s;
    motion.Add(t_s, Eigen::AngleAxisd(angle, speed_rad_s.normalized()).toRotationMatrix());
  }
  return motion;
}

/// An even view with a black border: what would be all that is known of beyond.
cv::Mat3b EvenView(const CameraModel& pinhole) {
  cv::Mat3b view(pinhole.height(), pinhole.width(), cv::Vec3b(0, 0, 0));
  view(cv::Rect(1, 1, view.cols - 2, view.rows - 2)).setTo(cv::Scalar::all(90));
  return view;
}

/// Black to the left of what lies straight ahead, which must be between two pixels; bright from
/// there on.
cv::Mat3b EdgeAhead(const CameraModel& pinhole) {
  cv::Mat3b view(pinhole.height(), pinhole.width(), cv::Vec3b(0, 0, 0));
  const double edge = pinhole.Project({0, 0, 1})->x();
  EXPECT_NEAR(edge - std::floor(edge), 0.5, 1e-6);
  view.colRange(static_cast<int>(std::ceil(edge)), view.cols).setTo(cv::Scalar::all(200));
  return view;
}

/// Mean and standard deviation of where an edge's rise lies in a row.
struct Rise {
  Rise(const cv::Mat3b& image, int row) {
    double mass = 0, square = 0;
    for (int x = 1; x < image.cols; ++x) {
      const double slope = image(row, x)[0] - image(row, x - 1)[0];
      mass += slope, mean += slope * (x - 0.5), square += slope * (x - 0.5) * (x - 0.5);
    }
    mean /= mass;
    deviation = std::sqrt(square / mass - mean * mean);
  }
  double mean = 0;
  double deviation = 0;
};

class LensTest : public testing::TestWithParam<Lens> {};

TEST_P(LensTest, PointsAreSeenWhereTheCameraModelProjectsThem) {
  const CameraModel camera(GetParam().intrinsics, GetParam().distortion);
  EyeCamera eye(camera, {}, 1, "left");
  const auto rays = SpotDirections(camera);
  ASSERT_GE(rays.size(), 50u);
  const cv::Mat3b image = eye.Develop(SpotsSeenBy(eye.View({}), rays), {}, 0);
  double worst = 0;
  for (const Vector3d& ray : rays) {
    const Vector2d expected = camera.Project(ray).value();
    const Vector2d error = CentroidAround(image, expected) - expected;
    EXPECT_LT(error.norm(), 0.05) << expected.transpose();
    worst = std::max(worst, error.norm());
  }
  RecordProperty("worst_error_px", std::to_string(worst));
}

TEST_P(LensTest, NoPixelIsEmpty) {
  const CameraModel camera(GetParam().intrinsics, GetParam().distortion);
  EyeCamera eye(camera, {}, 1, "left");
  const cv::Mat3b view = EvenView(eye.View({}));
  const cv::Mat3b image = eye.Develop(view, {}, 0);
  if (!camera.distortion().any() && camera.intrinsics().fx == camera.intrinsics().fy) {
    EXPECT_EQ(image.data, view.data) << "a pinhole's view is its image";
    return;
  }
  EXPECT_EQ(cv::norm(image, cv::Mat3b(480, 640, cv::Vec3b(90, 90, 90)), cv::NORM_INF), 0);
}

INSTANTIATE_TEST_SUITE_P(
    Lenses, LensTest,
    testing::Values(Lens{"principal_point", {640, 480, 560, 560, 301.2, 257.8}, {}},
                    Lens{"tall_pixels", {640, 480, 560, 610, 319.5, 239.5}, {}},
                    Lens{"wide_pixels", {640, 480, 560, 520, 319.5, 239.5}, {}},
                    Lens{"barrel", kVga, {.k1 = -0.28, .k2 = 0.09}},
                    Lens{"pincushion", kVga, {.k1 = 0.22, .k2 = 0.03}},
                    Lens{"tangential", kVga, {.p1 = 0.012, .p2 = -0.009}},
                    Lens{"moustache", kVga, {.k1 = -0.25, .k2 = 0.45, .k3 = -0.1}},
                    Lens{"everything",
                         {640, 480, 560, 590, 335.7, 221.3},
                         {.k1 = -0.21, .k2 = 0.09, .p1 = 0.004, .p2 = -0.003, .k3 = -0.02}}),
    [](const auto& lens) { return std::string(lens.param.name); });

TEST(EyeCamera, IdealCameraGivesTheViewItselfWhateverTheEyeDoes) {
  EyeCamera eye(CameraModel(kVga), {}, 1, "left");
  const EyeMotion motion = Turning({0, 5, 0}, 0.02);
  EXPECT_EQ(eye.View(motion).width(), 640);
  const cv::Mat3b view(480, 640, cv::Vec3b(1, 2, 3));
  EXPECT_EQ(eye.Develop(view, motion, 0).data, view.data);
}

/// Where spots are seen by an eye that turns while a shutter runs, and what it should be.
struct Seen {
  Vector2d at;
  Vector2d at_rest;
  Vector2d moving_px_s;  ///< of the pixel, in the instant the image is of
};

std::vector<Seen> SeenInMotion(const CameraProfile& profile, const Vector3d& speed_rad_s) {
  const CameraModel camera(kVga, {.k1 = -0.15});
  EyeCamera eye(camera, profile, 1, "left");
  const EyeMotion motion = Turning(speed_rad_s, eye.exposure().window_s() / 2);
  const auto rays = SpotDirections(camera);
  const cv::Mat3b image = eye.Develop(SpotsSeenBy(eye.View(motion), rays), motion, 0);
  std::vector<Seen> seen;
  for (const Vector3d& ray : rays) {
    const Vector2d at_rest = camera.Project(ray).value();
    // The eye turns by +speed, so a point at rest turns by -speed in the eye's frame.
    constexpr double kStep_s = 1e-5;
    const Vector3d moved = ray - kStep_s * speed_rad_s.cross(ray);
    const Vector2d speed = (camera.Project(moved).value() - at_rest) / kStep_s;
    const int row = static_cast<int>(std::lround(at_rest.y()));
    const Vector2d guess = at_rest + eye.exposure().Middle(row) * speed;
    if (guess.x() < 12 || guess.x() > 627 || guess.y() < 12 || guess.y() > 467) continue;
    seen.push_back({CentroidAround(image, guess, 9), at_rest, speed});
  }
  return seen;
}

TEST(EyeCamera, RollingShutterShowsEachPointWhereItIsWhenItsRowIsExposed) {
  CameraProfile profile;
  profile.shutter = {Shutter::kRolling, 0.030};
  for (const Vector3d& speed :
       {Vector3d(0, 0.8, 0), Vector3d(0.5, 0, 0), Vector3d(-0.3, -0.6, 0.4)}) {
    const auto seen = SeenInMotion(profile, speed);
    ASSERT_GT(seen.size(), 40u);
    for (const Seen& s : seen) {
      // Seen in the row y at the time t(y): x(t) = x0 + t v, solved for where the two agree.
      const double per_row_s = 0.030 / 479;
      const double t_s = per_row_s * (s.at_rest.y() - 239.5) / (1 - per_row_s * s.moving_px_s.y());
      const Vector2d expected = s.at_rest + t_s * s.moving_px_s;
      // The speed changes along the way by up to 1.5 % of it: the points lie off the linear path.
      EXPECT_LT((s.at - expected).norm(), 0.05 + 0.02 * (expected - s.at_rest).norm())
          << s.at_rest.transpose();
    }
  }
}

TEST(EyeCamera, RollingShutterLeansAVerticalEdgeByTheSpeedTimesTheReadout) {
  CameraProfile profile;
  profile.shutter = {Shutter::kRolling, 0.030};
  EyeCamera eye(CameraModel(kVga), profile, 1, "left");
  constexpr double kSpeed_rad_s = 2;  // about y: to the right
  const EyeMotion motion = Turning({0, kSpeed_rad_s, 0}, 0.015);
  const cv::Mat3b image = eye.Develop(EdgeAhead(eye.View(motion)), motion, 0);
  for (const int row : {0, 120, 240, 360, 479}) {
    const double angle = -kSpeed_rad_s * 0.030 * (row / 479.0 - 0.5);
    EXPECT_NEAR(Rise(image, row).mean, kVga.cx + kVga.fx * std::tan(angle), 0.05) << row;
  }
}

TEST(EyeCamera, InterlacedFieldsShowTheEdgeTwice) {
  CameraProfile profile;
  profile.shutter = {Shutter::kInterlaced, 0.020};
  EyeCamera eye(CameraModel(kVga), profile, 1, "left");
  const EyeMotion motion = Turning({0, 1, 0}, 0.010);
  const cv::Mat3b image = eye.Develop(EdgeAhead(eye.View(motion)), motion, 0);
  const double comb = kVga.fx * std::tan(0.010);
  for (int row = 100; row < 140; ++row) {
    const double expected = kVga.cx + (row % 2 == 0 ? comb : -comb);  // even rows came first
    EXPECT_NEAR(Rise(image, row).mean, expected, 0.05) << row;
  }
}

TEST(EyeCamera, MotionBlurIsAsLongAsTheWayDuringTheExposure) {
  CameraProfile profile;
  profile.exposure.time_s = 0.020;
  EyeCamera eye(CameraModel(kVga), profile, 1, "left");
  for (const double speed_rad_s : {0.5, 1.0, 4.0}) {
    const EyeMotion motion = Turning({0, speed_rad_s, 0}, 0.010);
    const Rise rise(eye.Develop(EdgeAhead(eye.View(motion)), motion, 0), 240);
    // A blurred edge is a ramp, whose slope is uniform along its length; a pixel adds its own
    // width.
    const double length = 2 * kVga.fx * std::tan(speed_rad_s * 0.010);
    EXPECT_NEAR(rise.mean, kVga.cx, 0.05) << speed_rad_s;
    EXPECT_NEAR(rise.deviation, std::sqrt((length * length + 1) / 12), 0.01 * length)
        << speed_rad_s;
  }
}

TEST(EyeCamera, MotionBlurLeavesNoGhostsOfAFinePattern) {
  CameraProfile profile;
  profile.exposure.time_s = 0.020;
  EyeCamera eye(CameraModel(kVga), profile, 1, "left");
  const EyeMotion motion = Turning({0, 3, 0}, 0.010);  // 34 pixels
  const CameraModel pinhole = eye.View(motion);
  cv::Mat3b stripes(pinhole.height(), pinhole.width());
  for (int x = 0; x < stripes.cols; ++x) stripes.col(x).setTo(cv::Scalar::all(x % 2 ? 220 : 20));
  const cv::Mat3b image = eye.Develop(stripes, motion, 0);
  cv::Scalar mean, deviation;
  cv::meanStdDev(image, mean, deviation);
  EXPECT_NEAR(mean[0], 120, 2);
  EXPECT_LT(deviation[0], 4) << "of stripes whose deviation is 100";
}

TEST(EyeCamera, NoPixelIsEmptyInAFastSaccade) {
  for (const char* name : {"webcam_vga", "lifecam_vx6000", "sony_xc999"}) {
    CameraProfile profile = CameraProfile::Named(name);
    profile.noise = {};
    profile.lens.vignetting = 0;
    const CameraModel camera = profile.lens.Model(320, 240, 1.05);
    EyeCamera eye(camera, profile, 1, "left");
    for (const Vector3d& speed : {Vector3d(0, 8, 0), Vector3d(-7, 0, 2), Vector3d(0, -20, 0)}) {
      const EyeMotion motion = Turning(speed, eye.exposure().window_s() / 2);
      const CameraModel pinhole = eye.View(motion);
      EXPECT_LE(pinhole.width(), eye.largest_view().width);
      EXPECT_LE(pinhole.height(), eye.largest_view().height);
      const cv::Mat3b image = eye.Develop(EvenView(pinhole), motion, 0);
      EXPECT_EQ(cv::norm(image, cv::Mat3b(240, 320, cv::Vec3b(90, 90, 90)), cv::NORM_INF), 0)
          << name << " " << speed.transpose();
    }
  }
}

TEST(EyeCamera, LensBlurSpreadsAPointByItsSigma) {
  CameraProfile profile;
  profile.lens.blur_px = 1.3;
  EyeCamera eye(CameraModel(kVga), profile, 1, "left");
  const Rise rise(eye.Develop(EdgeAhead(CameraModel(kVga)), {}, 0), 240);
  EXPECT_NEAR(rise.mean, kVga.cx, 0.05);
  EXPECT_NEAR(rise.deviation, 1.3, 0.05);
}

/// A pattern along x that is as fine as a view can show without aliasing, seen by an eye.
double ContrastOfStripes(EyeCamera& eye, double cycles_per_px) {
  const CameraModel view = eye.View({});
  cv::Mat3b stripes(view.height(), view.width());
  const double per_view_px = cycles_per_px * eye.model().intrinsics().fx / view.intrinsics().fx;
  for (int x = 0; x < stripes.cols; ++x) {
    const double phase = 2 * M_PI * per_view_px * (x - view.intrinsics().cx);
    stripes.col(x).setTo(cv::Scalar::all(std::lround(127 + 120 * std::cos(phase))));
  }
  const cv::Mat3b image = eye.Develop(stripes, {}, 0);
  cv::Scalar mean, deviation;  // around the middle, where the lens distorts nothing
  cv::meanStdDev(image(cv::Rect(300, 220, 40, 40)), mean, deviation);
  return deviation[0] * M_SQRT2 / 120;
}

TEST(EyeCamera, ABlurredBarrelLensNeedsNoMorePixelsThanItsImageButForMargins) {
  CameraProfile blurred;
  blurred.lens.blur_px = 0.6;
  const CameraModel camera(kVga, {.k1 = -0.25, .k2 = 0.09});
  EyeCamera eye(camera, blurred, 1, "left"), sharp(camera, {}, 1, "left");
  EXPECT_EQ(sharp.View({}).intrinsics().fx, 560) << "nothing hides what a coarser view loses";
  const CameraModel view = eye.View({});
  EXPECT_LT(view.width() * view.height(), 1.12 * 640 * 480);
  EXPECT_GT(sharp.View({}).width() * sharp.View({}).height(), 1.25 * 640 * 480);
  CameraProfile clear = blurred;
  clear.lens.blur_px = 0.52;  // hides less
  EXPECT_GT(EyeCamera(camera, clear, 1, "left").View({}).intrinsics().fx, view.intrinsics().fx);
}

TEST(EyeCamera, ACoarserViewTakesLittleOfTheContrast) {
  CameraProfile blurred;
  blurred.lens.blur_px = 0.6;
  EyeCamera ideal(CameraModel(kVga), blurred, 1, "left");
  EyeCamera barrel(CameraModel(kVga, {.k1 = -0.25, .k2 = 0.09}), blurred, 1, "left");
  const double expected = std::exp(-2 * std::pow(M_PI * 0.6 * 0.2, 2));
  EXPECT_NEAR(ContrastOfStripes(ideal, 0.2), expected, 0.02);
  // Sampling between pixels takes 12 % of this pattern anyway, and 15 % of it here.
  EXPECT_GT(ContrastOfStripes(barrel, 0.2), 0.85 * expected);
}

TEST(EyeCamera, SameMotionSameBitsOnAnyNumberOfThreads) {
  const CameraProfile profile = CameraProfile::Named("lifecam_vx6000");
  const CameraModel camera = profile.lens.Model(320, 240, 1.05);
  EyeCamera eye(camera, profile, 1, "left");
  const EyeMotion motion = Turning({0.4, 1, -0.2}, eye.exposure().window_s() / 2);
  const cv::Mat3b view = SpotsSeenBy(eye.View(motion), SpotDirections(camera));
  const cv::Mat3b many = eye.Develop(view.clone(), motion, 3);
  cv::setNumThreads(1);
  const cv::Mat3b one = eye.Develop(view.clone(), motion, 3);
  cv::setNumThreads(-1);
  EXPECT_EQ(cv::norm(many, one, cv::NORM_INF), 0);
}

}  // namespace
}  // namespace horopter::sim
