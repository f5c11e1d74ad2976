// SPDX-License-Identifier: Apache-2.0
#include "real_pair.h"

#include <bit>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "vision/disparity/field_score.h"

namespace horopter::vision::testing {
namespace {

/// Right camera of Middlebury's Motorcycle at the size that scikit-image ships.
const cv::Matx33d kRightCamera(994.978, 0, 311.193 + 31.086, 0, 994.978, 254.877, 0, 0, 1);

cv::Matx33d TurnHomography(const EyeTurn& turn) {
  const double pan = turn.pan_deg * CV_PI / 180;
  const double tilt = turn.tilt_deg * CV_PI / 180;
  const double roll = turn.roll_deg * CV_PI / 180;
  const cv::Matx33d about_y(std::cos(pan), 0, std::sin(pan), 0, 1, 0, -std::sin(pan), 0,
                            std::cos(pan));
  const cv::Matx33d about_x(1, 0, 0, 0, std::cos(tilt), -std::sin(tilt), 0, std::sin(tilt),
                            std::cos(tilt));
  const cv::Matx33d about_z(std::cos(roll), -std::sin(roll), 0, std::sin(roll), std::cos(roll), 0,
                            0, 0, 1);
  return kRightCamera * about_z * about_x * about_y * kRightCamera.inv();
}

cv::Mat ReadImage(const std::string& path) {
  cv::Mat image = cv::imread(path, cv::IMREAD_COLOR);
  if (image.empty()) throw std::runtime_error(path + ": cannot be read as an image");
  return image;
}

/// @param disparity x_left - x_right; not finite = unknown
/// @param H carries the right image's pixels to where a turned right eye sees them
PairWithTruth WithTruth(const cv::Mat& left, const cv::Mat& right, const cv::Mat1f& disparity,
                        const cv::Matx33d& H) {
  PairWithTruth pair{left, right, {}, {}};
  if (H != cv::Matx33d::eye()) {
    cv::warpPerspective(right, pair.right, H, left.size(), cv::INTER_CUBIC);
  }
  const float unknown = std::numeric_limits<float>::quiet_NaN();
  pair.dx = cv::Mat1f(disparity.size(), unknown);
  pair.dy = cv::Mat1f(disparity.size(), unknown);
  for (int y = 0; y < disparity.rows; ++y) {
    for (int x = 0; x < disparity.cols; ++x) {
      if (!std::isfinite(disparity(y, x))) continue;
      const cv::Vec3d match = H * cv::Vec3d(x - disparity(y, x), y, 1);
      const cv::Point2d p(match[0] / match[2], match[1] / match[2]);
      if (p.x < 0 || p.y < 0 || p.x > disparity.cols - 1 || p.y > disparity.rows - 1) continue;
      pair.dx(y, x) = static_cast<float>(p.x - x);
      pair.dy(y, x) = static_cast<float>(p.y - y);
    }
  }
  return pair;
}

PairWithTruth PublishedPair(const std::string& folder, const cv::Matx33d& H) {
  return WithTruth(ReadImage(folder + "left.png"), ReadImage(folder + "right.png"),
                   ReadPfm(folder + "disparity.pfm"), H);
}

}  // namespace

std::optional<std::string> DataFolder() {
  const char* named = std::getenv("HOROPTER_DATA_DIR");
  const std::string folder =
      named != nullptr ? named : std::string(HOROPTER_SOURCE_DIR) + "/../shared/data";
  if (!std::filesystem::exists(folder + "/motorcycle/disparity.pfm")) return std::nullopt;
  return folder;
}

cv::Mat1f ReadPfm(const std::string& path) {
  static_assert(std::endian::native == std::endian::little);
  std::ifstream file(path, std::ios::binary);
  std::string magic;
  int width = 0;
  int height = 0;
  double scale = 0;
  file >> magic >> width >> height >> scale;
  file.get();
  if (!file || magic != "Pf" || width < 1 || height < 1 || scale >= 0) {
    throw std::runtime_error(path + ": not a little-endian one-channel PFM");
  }
  cv::Mat1f bottom_up(height, width);
  file.read(reinterpret_cast<char*>(bottom_up.data),
            static_cast<std::streamsize>(bottom_up.total() * sizeof(float)));
  if (!file) throw std::runtime_error(path + ": ends early");
  cv::Mat1f map;
  cv::flip(bottom_up, map, 0);
  return map;
}

PairWithTruth VergedMotorcycle(const std::string& data_folder, const EyeTurn& turn) {
  return PublishedPair(data_folder + "/motorcycle/", TurnHomography(turn));
}

PairWithTruth RectifiedPair(const std::string& data_folder, const std::string& name) {
  return PublishedPair(data_folder + "/" + name + "/", cv::Matx33d::eye());
}

std::optional<PairWithTruth> AloePair() {
  const std::string folder = kAloeFolder;
  if (!std::filesystem::exists(folder + "aloeL.jpg")) return std::nullopt;
  const cv::Mat1b levels = cv::imread(folder + "aloeGT.png", cv::IMREAD_GRAYSCALE);
  cv::Mat1f disparity;
  levels.convertTo(disparity, CV_32F);
  disparity.setTo(std::numeric_limits<float>::infinity(), levels == 0);
  return WithTruth(ReadImage(folder + "aloeL.jpg"), ReadImage(folder + "aloeR.jpg"), disparity,
                   cv::Matx33d::eye());
}

FieldScore Score(const DisparityField& field, const cv::Mat1f& true_dx, const cv::Mat1f& true_dy) {
  constexpr std::size_t kTwoPixels = 2;
  static_assert(kBadLimitsPx[kTwoPixels] == 2);
  const ErrorScore score = *ScoreDisparity({field.dx, field.dy}, {true_dx, true_dy}).vector;
  return {score.density, score.median_px, score.bad_estimated[kTwoPixels]};
}

}  // namespace horopter::vision::testing
