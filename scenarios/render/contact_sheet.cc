// SPDX-License-Identifier: Apache-2.0
#include "scenarios/render/contact_sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "scenarios/results/colourise.h"

namespace horopter::scenarios {
namespace {

constexpr int kHeight = 216;
constexpr int kGap = 4;

cv::Mat3b Shrunk(const cv::Mat3b& image) {
  cv::Mat3b small;
  const int width = std::max(1, image.cols * kHeight / image.rows);
  cv::resize(image, small, {width, kHeight}, 0, 0, cv::INTER_AREA);
  return small;
}

/// The finite values' lowest and highest hundredth, so that single pixels do not set the scale.
std::pair<double, double> Extent(const cv::Mat1f& map) {
  std::vector<float> values;
  for (const float v : map) {
    if (std::isfinite(v)) values.push_back(v);
  }
  if (values.empty()) return {0, 0};
  const auto at = [&values](double part) {
    const auto nth =
        values.begin() + static_cast<std::ptrdiff_t>(part * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), nth, values.end());
    return static_cast<double>(*nth);
  };
  return {at(0.01), at(0.99)};
}

cv::Mat3b DepthPicture(const cv::Mat1f& depth_m) {
  const auto [near_m, far_m] = Extent(depth_m);
  return far_m > near_m ? ColouriseDepth(depth_m, near_m, far_m)
                        : cv::Mat3b(depth_m.size(), cv::Vec3b::all(64));
}

cv::Mat3b DisparityPicture(const sim::CorrespondenceField& field) {
  const auto [low, high] = Extent(field.dx);
  const double limit = std::max({std::abs(low), std::abs(high), 1.0});
  cv::Mat1b seen = field.Mask(sim::Visibility::kVisible);
  return ColouriseDisparity({field.dx, field.dy, cv::Mat1f(field.dx.size(), 1.0F), seen}, limit);
}

/// One row: pictures side by side, with where the head looks above them.
cv::Mat3b Row(const DatasetPair& pair, const std::string& caption) {
  std::vector<cv::Mat3b> pictures = {Shrunk(pair.left.bgr), Shrunk(pair.right.bgr)};
  if (pair.left.truth) pictures.push_back(Shrunk(DepthPicture(pair.left.truth->depth)));
  if (pair.left.to_other_eye) pictures.push_back(Shrunk(DisparityPicture(*pair.left.to_other_eye)));
  int width = kGap;
  for (const cv::Mat3b& p : pictures) width += p.cols + kGap;
  constexpr int kCaption = 20;
  cv::Mat3b row(kCaption + kHeight + kGap, width, cv::Vec3b::all(255));
  int x = kGap;
  for (const cv::Mat3b& p : pictures) {
    p.copyTo(row(cv::Rect(x, kCaption, p.cols, kHeight)));
    x += p.cols + kGap;
  }
  cv::putText(row, caption, {kGap, 15}, cv::FONT_HERSHEY_SIMPLEX, 0.45, {40, 40, 40}, 1,
              cv::LINE_AA);
  return row;
}

std::string Caption(const DatasetFrame& frame, const DatasetPair& pair) {
  constexpr double kDegrees = 180 / M_PI;
  const auto& h = frame.head;
  return fmt::format(
      "{}{}left eye {:.1f} {:.1f}, right eye {:.1f} {:.1f}, neck {:.1f} {:.1f} deg "
      "(pan, tilt)",
      pair.name, pair.name.empty() ? "" : ": ", h.left.pan_rad * kDegrees,
      h.left.tilt_rad * kDegrees, h.right.pan_rad * kDegrees, h.right.tilt_rad * kDegrees,
      h.neck.pan_rad * kDegrees, h.neck.tilt_rad * kDegrees);
}

}  // namespace

void ContactSheet::AddSpread(const DatasetFrame& frame, int index, int all) {
  const int pairs = std::max(1, static_cast<int>(frame.pairs.size()));
  const int shown = std::min(all, std::max(1, most_rows_ / pairs));
  for (int k = 0; k < shown; ++k) {
    if (index != (shown > 1 ? k * (all - 1) / (shown - 1) : 0)) continue;
    Add(frame);
    return;
  }
}

void ContactSheet::Add(const DatasetFrame& frame) {
  for (const DatasetPair& pair : frame.pairs) {
    if (rows_ == most_rows_) return;
    const cv::Mat3b row = Row(pair, Caption(frame, pair));
    const int width = std::max(picture_.cols, row.cols);
    cv::Mat3b grown(picture_.rows + row.rows, width, cv::Vec3b::all(255));
    if (!picture_.empty()) {
      picture_.copyTo(grown(cv::Rect(0, 0, picture_.cols, picture_.rows)));
    }
    row.copyTo(grown(cv::Rect(0, picture_.rows, row.cols, row.rows)));
    picture_ = grown;
    ++rows_;
  }
}

}  // namespace horopter::scenarios
