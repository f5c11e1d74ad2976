// SPDX-License-Identifier: Apache-2.0
#include "sim/camera/sensor_model.h"

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/core.hpp>
#include <set>

namespace horopter::sim {
namespace {

const hardware::CameraModel kCamera = hardware::CameraModel::FromHorizontalFov(320, 240, 1.05);

cv::Mat Grey(int level) { return cv::Mat(240, 320, CV_8UC3, cv::Scalar::all(level)); }

CameraProfile Noise(double read_noise_dn, double shot_gain_dn) {
  CameraProfile profile;
  profile.noise = {.read_noise_dn = read_noise_dn, .shot_gain_dn = shot_gain_dn};
  return profile;
}

CameraProfile WebcamNoise() {
  CameraProfile profile;
  profile.noise = CameraProfile::Named("webcam_vga").noise;
  return profile;
}

SensorModel Sensor(const CameraProfile& profile, std::uint64_t seed = 1,
                   std::string_view camera = "left") {
  return SensorModel(profile, kCamera, seed, camera);
}

cv::Mat Seen(const SensorModel& model, int level = 128, std::uint64_t frame = 0) {
  cv::Mat image = Grey(level);
  model.Apply(frame, image);
  return image;
}

bool Equal(const cv::Mat& a, const cv::Mat& b) { return cv::norm(a, b, cv::NORM_L1) == 0; }

/// What a sensor adds to a grey level, unrounded numbers in double.
cv::Mat NoiseOf(const SensorModel& model, int level) {
  cv::Mat noise;
  Seen(model, level).reshape(1).convertTo(noise, CV_64F);
  return noise - level;
}

double Correlation(const cv::Mat& a, const cv::Mat& b) {
  return a.dot(b) / std::sqrt(a.dot(a) * b.dot(b));
}

TEST(SensorModel, IdealSensorChangesNothing) {
  const SensorModel model = Sensor(CameraProfile::Named("ideal"));
  EXPECT_TRUE(model.ideal());
  EXPECT_TRUE(Equal(Seen(model), Grey(128)));
}

TEST(SensorModel, NoiseHasTheVarianceTheProfileStates) {
  for (const CameraProfile& profile : {WebcamNoise(), Noise(2.5, 0), Noise(0, 0.1)}) {
    const SensorModel model = Sensor(profile);
    for (const int level : {30, 128, 220}) {
      cv::Scalar mean, deviation;
      cv::meanStdDev(Seen(model, level, 3).reshape(1), mean, deviation);
      const double read = profile.noise.read_noise_dn;
      // Rounding to whole grey levels adds 1/12 to the variance.
      const double expected = std::sqrt(read * read + profile.noise.shot_gain_dn * level + 1. / 12);
      EXPECT_NEAR(mean[0], level, 0.05) << level;
      EXPECT_NEAR(deviation[0], expected, 0.02 * expected) << level;
    }
  }
}

TEST(SensorModel, NoiseFollowsTheNormalLaw) {
  constexpr double kSigma = 20;
  const cv::Mat noise = NoiseOf(Sensor(Noise(kSigma, 0)), 128);
  const auto count = static_cast<double>(noise.total());
  // Whole grey levels: up to half a level more.
  for (const double limit : {10.5, 20.5, 40.5, 60.5}) {
    const double beyond = cv::countNonZero(cv::abs(noise) > limit) / count;
    const double expected = std::erfc(limit / kSigma / M_SQRT2);
    EXPECT_NEAR(beyond, expected, 0.0016 + 4 * std::sqrt(expected / count)) << limit;
    EXPECT_NEAR(beyond, expected, 0.15 * expected) << limit;
  }
  const double kurtosis = cv::mean(noise.mul(noise).mul(noise).mul(noise))[0] / std::pow(kSigma, 4);
  EXPECT_NEAR(kurtosis, 3, 0.05);
}

TEST(SensorModel, LessLightLeavesTheReadNoiseAndLowersTheShotNoise) {
  const SensorModel model = Sensor(Noise(1.5, 0.1));
  cv::Mat image = Grey(200);
  model.Apply(3, image, 0.25);
  cv::Scalar mean, deviation;
  cv::meanStdDev(image.reshape(1), mean, deviation);
  const double expected = std::sqrt(1.5 * 1.5 + 0.1 * 50 + 1. / 12);
  EXPECT_NEAR(mean[0], 50, 0.05);
  EXPECT_NEAR(deviation[0], expected, 0.02 * expected);
}

TEST(SensorModel, FramesCamerasAndSeedsDiffer) {
  const SensorModel left = Sensor(WebcamNoise());
  const cv::Mat reference = Seen(left, 128, 5);
  EXPECT_FALSE(Equal(reference, Seen(left, 128, 6)));
  EXPECT_FALSE(Equal(reference, Seen(Sensor(WebcamNoise(), 1, "right"), 128, 5)));
  EXPECT_FALSE(Equal(reference, Seen(Sensor(WebcamNoise(), 2), 128, 5)));
}

TEST(SensorModel, FrameDoesNotDependOnFramesBeforeOrThreads) {
  const SensorModel a = Sensor(WebcamNoise()), b = Sensor(WebcamNoise());
  for (int i = 0; i < 4; ++i) Seen(a, 128, i);
  const cv::Mat threaded = Seen(a, 128, 9);
  cv::setNumThreads(1);
  const cv::Mat single = Seen(b, 128, 9);
  cv::setNumThreads(-1);
  EXPECT_TRUE(Equal(threaded, single));
}

TEST(SensorModel, NeighbouringPixelsAreUncorrelated) {
  const cv::Mat noise = NoiseOf(Sensor(Noise(4, 0)), 128);
  const auto correlation = [&noise](int dy, int dx) {
    const cv::Rect all(0, 0, noise.cols - dx, noise.rows - dy);
    return noise(all).dot(noise(all + cv::Point(dx, dy))) / (all.area() * 16.0);
  };
  const double five_sigma = 5 / std::sqrt(static_cast<double>(noise.total()));
  EXPECT_NEAR(correlation(0, 1), 0, five_sigma);
  EXPECT_NEAR(correlation(0, 3), 0, five_sigma);
  EXPECT_NEAR(correlation(1, 0), 0, five_sigma);
}

TEST(SensorModel, ReadNoiseStaysWhenShotNoiseIsTurnedOn) {
  const cv::Mat read = NoiseOf(Sensor(Noise(6, 0)), 128),
                shot = NoiseOf(Sensor(Noise(0, 0.3)), 128),
                both = NoiseOf(Sensor(Noise(6, 0.3)), 128);
  EXPECT_LE(cv::norm(both, read + shot, cv::NORM_INF), 1.0) << "roundings apart";
  EXPECT_NEAR(Correlation(read, shot), 0, 5 / std::sqrt(static_cast<double>(read.total())));
}

TEST(SensorModel, NoiseStaysWhenGainAndVignettingAreTurnedOn) {
  CameraProfile bright = Noise(6, 0);
  bright.exposure.gain = 1.5;
  const cv::Mat plain = NoiseOf(Sensor(Noise(6, 0)), 120), brighter = NoiseOf(Sensor(bright), 80);
  EXPECT_EQ(cv::norm(plain, brighter - 40, cv::NORM_INF), 0) << "80 * 1.5 = 120";
}

TEST(SensorModel, ExposureMultipliesAndClips) {
  CameraProfile profile;
  profile.exposure.gain = 2;
  EXPECT_TRUE(Equal(Seen(Sensor(profile), 100), Grey(200)));
  EXPECT_TRUE(Equal(Seen(Sensor(profile), 130), Grey(255)));
}

TEST(SensorModel, VignettingDarkensWithTheSquareOfTheDistanceFromThePrincipalPoint) {
  CameraProfile profile;
  profile.lens.vignetting = 0.4;
  const hardware::CameraModel camera({320, 240, 300, 300, 100, 119.5});
  cv::Mat image = Grey(200);
  SensorModel(profile, camera, 1, "left").Apply(0, image);
  const auto at = [&image](int y, int x) { return 1.0 * image.at<cv::Vec3b>(y, x)[1]; };
  const double corner2 = 219 * 219 + 119.5 * 119.5;
  EXPECT_NEAR(at(239, 319), 200 * 0.6, 0.51);
  EXPECT_NEAR(at(119, 100), 200, 0.51);
  for (const int x : {0, 50, 200, 300}) {
    const double r2 = (x - 100.0) * (x - 100.0) + 0.25;
    EXPECT_NEAR(at(119, x), 200 * (1 - 0.4 * r2 / corner2), 0.51) << x;
  }
}

TEST(SensorModel, ConverterHasAsManyLevelsAsItsBitsSay) {
  CameraProfile profile = Noise(20, 0);
  for (const int bits : {1, 4, 7}) {
    profile.noise.bits = bits;
    const cv::Mat image = Seen(Sensor(profile));
    const std::set<std::uint8_t> levels(image.data, image.data + image.total() * 3);
    EXPECT_LE(levels.size(), std::size_t{1} << bits);
    EXPECT_GE(levels.size(), std::size_t{2}) << bits;
    for (const std::uint8_t level : levels) {
      const double number = level * ((1 << bits) - 1) / 255.0;
      EXPECT_NEAR(number, std::round(number), 0.25) << bits;
    }
  }
}

}  // namespace
}  // namespace horopter::sim
