// SPDX-License-Identifier: Apache-2.0
#include "sim/camera/sensor_model.h"

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/core.hpp>

namespace horopter::sim {
namespace {

using hardware::Eye;

cv::Mat Grey(int level) { return cv::Mat(240, 320, CV_8UC3, cv::Scalar::all(level)); }

cv::Mat Noisy(const SensorModel& model, std::uint64_t frame, int level = 128) {
  cv::Mat image = Grey(level);
  model.Apply(frame, image);
  return image;
}

bool Equal(const cv::Mat& a, const cv::Mat& b) { return cv::norm(a, b, cv::NORM_L1) == 0; }

TEST(SensorModel, IdealSensorChangesNothing) {
  const SensorModel model(SensorProfile::Named("ideal"), 1, Eye::kLeft);
  EXPECT_TRUE(Equal(Noisy(model, 0), Grey(128)));
}

TEST(SensorModel, NoiseHasTheVarianceTheProfileStates) {
  const SensorProfile profile = SensorProfile::Named("webcam_vga");
  const SensorModel model(profile, 1, Eye::kLeft);
  for (const int level : {30, 128, 220}) {
    cv::Scalar mean, deviation;
    cv::meanStdDev(Noisy(model, 3, level).reshape(1), mean, deviation);
    // Rounding to whole grey levels adds 1/12 to the variance.
    const double expected = std::sqrt(profile.read_noise_dn * profile.read_noise_dn +
                                      profile.shot_gain_dn * level + 1.0 / 12);
    EXPECT_NEAR(mean[0], level, 0.05) << level;
    EXPECT_NEAR(deviation[0], expected, 0.02 * expected) << level;
  }
}

TEST(SensorModel, FramesEyesAndSeedsDiffer) {
  const SensorProfile profile = SensorProfile::Named("webcam_vga");
  const SensorModel left(profile, 1, Eye::kLeft), right(profile, 1, Eye::kRight),
      other(profile, 2, Eye::kLeft);
  const cv::Mat reference = Noisy(left, 5);
  EXPECT_FALSE(Equal(reference, Noisy(left, 6)));
  EXPECT_FALSE(Equal(reference, Noisy(right, 5)));
  EXPECT_FALSE(Equal(reference, Noisy(other, 5)));
}

TEST(SensorModel, FrameDoesNotDependOnFramesBeforeOrThreads) {
  const SensorModel a(SensorProfile::Named("webcam_vga"), 1, Eye::kLeft);
  const SensorModel b(SensorProfile::Named("webcam_vga"), 1, Eye::kLeft);
  for (int i = 0; i < 4; ++i) Noisy(a, i);
  const cv::Mat threaded = Noisy(a, 9);
  cv::setNumThreads(1);
  const cv::Mat single = Noisy(b, 9);
  cv::setNumThreads(-1);
  EXPECT_TRUE(Equal(threaded, single));
}

TEST(SensorModel, NeighbouringPixelsAreUncorrelated) {
  const SensorModel model({"test", 4, 0}, 1, Eye::kLeft);
  cv::Mat noise;
  Noisy(model, 0).reshape(1).convertTo(noise, CV_64F);
  noise -= 128;
  const auto correlation = [&noise](int dy, int dx) {
    const cv::Rect all(0, 0, noise.cols - dx, noise.rows - dy);
    return noise(all).dot(noise(all + cv::Point(dx, dy))) / (all.area() * 16.0);
  };
  const double five_sigma = 5 / std::sqrt(static_cast<double>(noise.total()));
  EXPECT_NEAR(correlation(0, 1), 0, five_sigma);
  EXPECT_NEAR(correlation(0, 3), 0, five_sigma);
  EXPECT_NEAR(correlation(1, 0), 0, five_sigma);
}

TEST(SensorModel, UnknownProfileNamesTheKnownOnes) {
  try {
    SensorProfile::Named("webcam");
    FAIL();
  } catch (const hardware::ConfigError& e) {
    EXPECT_NE(std::string(e.what()).find("webcam_vga"), std::string::npos);
  }
}

}  // namespace
}  // namespace horopter::sim
