// SPDX-License-Identifier: Apache-2.0
#include "scenarios/dataset/stereo_images.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <opencv2/imgproc.hpp>
#include <utility>

#include "scenarios/dataset/format_error.h"
#include "scenarios/dataset/image_file.h"

namespace horopter::scenarios {
namespace {

void RequireOneSize(const NamedImage& left, const NamedImage& right) {
  if (left.pixels.size() == right.pixels.size()) return;
  throw FormatError(fmt::format("{} is {}x{}, {} is {}x{}: both eyes must have one size", left.name,
                                left.pixels.cols, left.pixels.rows, right.name, right.pixels.cols,
                                right.pixels.rows));
}

void RequireNumbers(const NamedImage& image) {
  if (image.pixels.depth() != CV_32F && image.pixels.depth() != CV_64F) return;
  cv::Point at;
  if (cv::checkRange(image.pixels, true, &at)) return;
  throw FormatError(fmt::format("{}: NaN or infinite at ({}, {}): every pixel must be a number",
                                image.name, at.x, at.y));
}

cv::Mat WithoutAlpha(const cv::Mat& pixels) {
  if (pixels.channels() != 4 && pixels.channels() != 2) return pixels;
  cv::Mat out;
  if (pixels.channels() == 2) {
    cv::extractChannel(pixels, out, 0);
  } else if (pixels.depth() == CV_64F) {  // which cv::cvtColor does not take
    pixels.convertTo(out, CV_32F);
    cv::cvtColor(out, out, cv::COLOR_BGRA2BGR);
  } else {
    cv::cvtColor(pixels, out, cv::COLOR_BGRA2BGR);
  }
  return out;
}

cv::Mat Grey(const cv::Mat& pixels) {
  if (pixels.channels() == 1) return pixels;
  cv::Mat grey;
  cv::cvtColor(pixels, grey, cv::COLOR_BGR2GRAY);
  return grey;
}

/// As floats unless they are 8 bits already.
cv::Mat AsFloats(const cv::Mat& pixels) {
  if (pixels.depth() == CV_8U) return pixels;
  cv::Mat floats;
  pixels.convertTo(floats, CV_32F);
  return floats;
}

/// The value that becomes 255 (ConvertStereoImages says which).
double FullScale(const std::vector<cv::Mat>& images) {
  constexpr std::size_t kSamples = 1 << 20;
  std::vector<float> sample;
  for (const cv::Mat& image : images) {
    const cv::Mat values = image.reshape(1);
    const std::size_t step = std::max<std::size_t>(1, values.total() / kSamples);
    for (std::size_t i = 0; i < values.total(); i += step) {
      const auto columns = static_cast<std::size_t>(values.cols);
      sample.push_back(
          values.at<float>(static_cast<int>(i / columns), static_cast<int>(i % columns)));
    }
  }
  const auto nearly_largest =
      sample.begin() + static_cast<std::ptrdiff_t>(0.999 * static_cast<double>(sample.size() - 1));
  std::nth_element(sample.begin(), nearly_largest, sample.end());
  constexpr int kFewestBits = 8, kMostBits = 16;
  int bits = kFewestBits;
  while (bits<kMostBits&& * nearly_largest> static_cast<float>((1 << bits) - 1)) ++bits;
  return std::max<double>((1 << bits) - 1, *nearly_largest);
}

bool IsUnitRange(const std::vector<cv::Mat>& images) {
  return std::all_of(images.begin(), images.end(), [](const cv::Mat& image) {
    return cv::countNonZero(image.reshape(1) > 1) == 0;
  });
}

cv::Mat To8Bits(const cv::Mat& pixels, double full_scale) {
  if (pixels.depth() == CV_8U) return pixels;
  cv::Mat out;
  pixels.convertTo(out, CV_8U, 255 / full_scale);
  return out;
}

}  // namespace

StereoImages ConvertStereoImages(const NamedImage& left, const NamedImage& right) {
  RequireOneSize(left, right);
  RequireNumbers(left);
  RequireNumbers(right);
  StereoImages pair{WithoutAlpha(left.pixels), WithoutAlpha(right.pixels), {}};
  if (pair.left.channels() != pair.right.channels()) {
    const bool left_is_grey = pair.left.channels() == 1;
    pair.notes.push_back(fmt::format("{} is grey: {} is taken in grey, too",
                                     left_is_grey ? left.name : right.name,
                                     left_is_grey ? right.name : left.name));
  }
  const bool floats = left.pixels.depth() >= CV_32F && right.pixels.depth() >= CV_32F;
  const bool grey = !pair.notes.empty();
  std::vector<cv::Mat> deep;  // of more than 8 bits
  for (cv::Mat* image : {&pair.left, &pair.right}) {
    *image = AsFloats(*image);
    if (grey) *image = Grey(*image);
    if (image->depth() != CV_8U) deep.push_back(*image);
  }
  if (deep.empty()) return pair;
  if (deep.size() == 1) {
    const bool left_is_8 = pair.left.depth() == CV_8U;
    pair.notes.push_back(fmt::format("{} has 8 bits and {} more: it is scaled by itself",
                                     left_is_8 ? left.name : right.name,
                                     left_is_8 ? right.name : left.name));
  }
  const double full_scale = floats && IsUnitRange(deep) ? 1 : FullScale(deep);
  pair.left = To8Bits(pair.left, full_scale);
  pair.right = To8Bits(pair.right, full_scale);
  return pair;
}

StereoImages ReadStereoImages(const std::filesystem::path& left,
                              const std::filesystem::path& right) {
  return ConvertStereoImages({left.string(), ReadImage(left)}, {right.string(), ReadImage(right)});
}

}  // namespace horopter::scenarios
