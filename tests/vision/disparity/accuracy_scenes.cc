// SPDX-License-Identifier: Apache-2.0
#include "accuracy_scenes.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

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
  for (const auto& [name, turn] :
       {std::pair<std::string, EyeTurn>{"Motorcycle verged A (2, .3, .5) deg", {2, 0.3, 0.5}},
        {"Motorcycle verged B (4, -.5, 1.5) deg", {4, -0.5, 1.5}},
        {"Motorcycle verged C (-1, 1, 0) deg", {-1, 1, 0}}}) {
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
