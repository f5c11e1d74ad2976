// SPDX-License-Identifier: Apache-2.0
#include "scenarios/results/disparity_picture.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>
#include <string>
#include <vector>

#include "scenarios/results/colourise.h"
#include "scenarios/results/statistics.h"

namespace horopter::scenarios {
namespace {

constexpr int kMargin = 8;
constexpr int kTitleHeight = 22;
constexpr int kLeastWidth = 160;  // of a legend
const cv::Scalar kPaper(255, 255, 255);
const cv::Scalar kInk(32, 32, 32);

struct Scale {
  ColourMap map;
  double low;
  double high;
};

Scale ScaleOf(const cv::Mat1f& values, const cv::Mat1b& valid) {
  std::vector<double> sample;
  for (int y = 0; y < values.rows; ++y) {
    for (int x = 0; x < values.cols; ++x) {
      if (valid(y, x) != 0) sample.push_back(values(y, x));
    }
  }
  constexpr double kLeastSpan = 0.1;  // [px]: below, a scale would show rounding
  const double low = Quantile(sample, 0.02).value_or(0), high = Quantile(sample, 0.98).value_or(0);
  if (low * high > 0 && high - low >= kLeastSpan) return {ColourMap::kRange, low, high};
  const double limit = std::max({std::abs(low), std::abs(high), kLeastSpan});
  return {ColourMap::kDisparity, -limit, limit};
}

/// Title above, the map, its legend below; on white, with a margin around.
cv::Mat3b Panel(const std::string& title, const cv::Mat1f& values, const cv::Mat1b& valid) {
  const Scale scale = ScaleOf(values, valid);
  cv::Mat1f shown(values.size(), std::numeric_limits<float>::quiet_NaN());
  values.copyTo(shown, valid);
  const int width = std::max(values.cols, kLeastWidth);
  const cv::Mat3b legend = LegendStrip(scale.map, scale.low, scale.high, "px", width);
  cv::Mat3b panel(kTitleHeight + values.rows + kMargin + legend.rows + kMargin, width + 2 * kMargin,
                  cv::Vec3b(255, 255, 255));
  cv::putText(panel, title, {kMargin, kTitleHeight - 7}, cv::FONT_HERSHEY_SIMPLEX, 0.45, kInk, 1,
              cv::LINE_AA);
  ColouriseValues(shown, scale.map, scale.low, scale.high)
      .copyTo(panel(cv::Rect({kMargin, kTitleHeight}, values.size())));
  const cv::Point below(kMargin, kTitleHeight + values.rows + kMargin);
  legend.copyTo(panel(cv::Rect(below, legend.size())));
  return panel;
}

}  // namespace

cv::Mat3b DisparityPicture(const vision::DisparityField& field) {
  cv::Mat3b picture = Panel("dx = x_right - x_left", field.dx, field.valid);
  const bool has_vertical = cv::countNonZero((field.dy != 0) & field.valid) > 0;
  if (!has_vertical) return picture;
  cv::hconcat(picture, Panel("dy = y_right - y_left", field.dy, field.valid), picture);
  return picture;
}

}  // namespace horopter::scenarios
