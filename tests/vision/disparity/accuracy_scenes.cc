// SPDX-License-Identifier: Apache-2.0
#include "accuracy_scenes.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <numbers>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/video/tracking.hpp>
#include <stdexcept>

namespace horopter::vision::testing {
namespace {

constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();

cv::Mat Moved(const cv::Mat& image, int dx, int dy) {
  const cv::Matx23d move(1, 0, dx, 0, 1, dy);
  cv::Mat out;
  cv::warpAffine(image, out, move, image.size(), cv::INTER_NEAREST, cv::BORDER_REPLICATE);
  return out;
}

cv::Mat Noisy(const cv::Mat& image, double sigma, std::uint64_t seed) {
  cv::RNG random(seed);
  cv::Mat noise(image.size(), CV_16SC(image.channels()));
  random.fill(noise, cv::RNG::NORMAL, 0, sigma);
  cv::Mat out;
  cv::add(image, noise, out, cv::noArray(), CV_8U);
  return out;
}

cv::Mat Dimmed(const cv::Mat& image, double factor) {
  cv::Mat out;  // of its own: images share their pixels when they are copied
  image.convertTo(out, -1, factor);
  return out;
}

}  // namespace

std::vector<AccuracyScene> RealScenes(const std::string& data_folder, const std::string& part) {
  std::vector<AccuracyScene> scenes;
  const auto wanted = [&part](const std::string& name) {
    return name.find(part) != std::string::npos;
  };
  for (std::size_t i = 0; i < kTurns.size(); ++i) {
    const EyeTurn& turn = kTurns[i];
    const std::string name = fmt::format("Motorcycle verged {:c} ({}, {}, {}) deg", 'A' + i,
                                         turn.pan_deg, turn.tilt_deg, turn.roll_deg);
    if (wanted(name)) scenes.push_back({name, VergedMotorcycle(data_folder, turn), std::nullopt});
  }
  struct Published {
    const char* name;
    const char* folder;
    int end_px;  ///< of the range that is searched
  };
  for (const auto& [name, folder, end_px] :
       {Published{"Motorcycle rectified", "motorcycle", 64}, Published{"Teddy", "teddy", 64},
        Published{"Reindeer", "reindeer", 112}}) {
    if (!wanted(name)) continue;
    scenes.push_back({name, RectifiedPair(data_folder, folder), SearchRange::Covering(0, end_px)});
  }
  if (wanted("Aloe")) {
    if (const auto aloe = AloePair()) scenes.push_back({"Aloe", *aloe, SearchRange{0, 224}});
  }
  return scenes;
}

StereoCameras MotorcycleCameras() {
  constexpr double kFocalPx = 994.978, kRow = 254.877;
  return {hardware::CameraModel({741, 500, kFocalPx, kFocalPx, 311.193, kRow}),
          hardware::CameraModel({741, 500, kFocalPx, kFocalPx, 342.279, kRow})};
}

hardware::Pose MotorcyclePose(const EyeTurn& turn) {
  constexpr double kBaselineM = 0.193001, kDeg = std::numbers::pi / 180;
  using Eigen::AngleAxisd, Eigen::Vector3d;
  hardware::Pose X_ClCr = hardware::Pose::Identity();
  X_ClCr.linear() = (AngleAxisd(turn.roll_deg * kDeg, Vector3d::UnitZ()) *
                     AngleAxisd(turn.tilt_deg * kDeg, Vector3d::UnitX()) *
                     AngleAxisd(turn.pan_deg * kDeg, Vector3d::UnitY()))
                        .toRotationMatrix()
                        .transpose();
  X_ClCr.translation().x() = kBaselineM;
  return X_ClCr;
}

AccuracyScene RenderedScene(const std::string& folder) {
  const std::filesystem::path frame = std::filesystem::path(folder) / "000000";
  const auto read = [&frame](const char* name) {
    cv::Mat image = cv::imread((frame / name).string());
    if (image.empty()) throw std::runtime_error("cannot read " + (frame / name).string());
    return image;
  };
  const cv::Mat2f flow = cv::readOpticalFlow((frame / "left_disparity.flo").string());
  if (flow.empty()) throw std::runtime_error("cannot read its left_disparity.flo: " + folder);
  constexpr float kFloUnknown = 1e9F;  // as the format's authors have it
  PairWithTruth pair{read("left.png"), read("right.png"), cv::Mat1f(flow.size()),
                     cv::Mat1f(flow.size())};
  for (int y = 0; y < flow.rows; ++y) {
    for (int x = 0; x < flow.cols; ++x) {
      const bool known =
          std::abs(flow(y, x)[0]) < kFloUnknown && std::abs(flow(y, x)[1]) < kFloUnknown;
      pair.dx(y, x) = known ? flow(y, x)[0] : kUnknown;
      pair.dy(y, x) = known ? flow(y, x)[1] : kUnknown;
    }
  }
  return {std::filesystem::path(folder).filename().string(), pair, std::nullopt};
}

PairWithTruth WithNoise(const PairWithTruth& pair, double sigma_grey) {
  PairWithTruth noisy = pair;
  if (sigma_grey <= 0) return noisy;
  noisy.left = Noisy(pair.left, sigma_grey, 1);
  noisy.right = Noisy(pair.right, sigma_grey, 2);
  return noisy;
}

PairWithTruth WithGain(const PairWithTruth& pair, double gain) {
  return {Dimmed(pair.left, std::min(1.0, 1 / gain)), Dimmed(pair.right, std::min(1.0, gain)),
          pair.dx, pair.dy};
}

PairWithTruth WithVerticalOffset(const PairWithTruth& pair, int dy) {
  PairWithTruth out{pair.left, Moved(pair.right, 0, dy), pair.dx.clone(), pair.dy + dy};
  for (int y = 0; y < out.dy.rows; ++y) {
    for (int x = 0; x < out.dy.cols; ++x) {
      const float match_y = static_cast<float>(y) + out.dy(y, x);
      if (match_y >= 0 && match_y <= static_cast<float>(out.dy.rows - 1)) continue;
      out.dx(y, x) = out.dy(y, x) = kUnknown;
    }
  }
  return out;
}

PairWithTruth Shifted(const PairWithTruth& pair, int dx, int dy) {
  constexpr int kSide = 200, kTop = 30;
  const auto on_canvas = [](const cv::Mat& image, int x, int y, const cv::Scalar& ground) {
    cv::Mat out;
    cv::copyMakeBorder(image, out, kTop + y, kTop - y, kSide + x, kSide - x, cv::BORDER_CONSTANT,
                       ground);
    return out;
  };
  return {on_canvas(pair.left, 0, 0, {}), on_canvas(pair.right, dx, dy, {}),
          on_canvas(pair.dx + dx, 0, 0, cv::Scalar::all(kUnknown)),
          on_canvas(pair.dy + dy, 0, 0, cv::Scalar::all(kUnknown))};
}

}  // namespace horopter::vision::testing
