// SPDX-License-Identifier: Apache-2.0
#include "accuracy_pictures.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace horopter::vision::testing {
namespace {

constexpr double kWorstPx = 2;

/// Values from low to high in colours; unknown ones black.
cv::Mat3b Coloured(const cv::Mat1f& values, double low, double high, int colours) {
  // cv's != finds no NaN.
  const cv::Mat1b is_known = values == values;
  const cv::Mat1b unknown = ~is_known;
  cv::Mat1f known = values.clone();
  known.setTo(low, unknown);
  const double scale = 255 / std::max(high - low, 1e-6);
  cv::Mat1b levels;
  known.convertTo(levels, CV_8U, scale, -low * scale);
  cv::Mat3b out;
  cv::applyColorMap(levels, out, colours);
  out.setTo(cv::Scalar::all(0), unknown);
  return out;
}

cv::Mat1f ErrorOf(const DisparityField& field, const PairWithTruth& pair) {
  cv::Mat1f error(pair.dx.size());
  for (int y = 0; y < error.rows; ++y) {
    for (int x = 0; x < error.cols; ++x) {
      error(y, x) = std::hypot(field.dx(y, x) - pair.dx(y, x), field.dy(y, x) - pair.dy(y, x));
    }
  }
  return error;
}

std::pair<double, double> RangeOf(const cv::Mat1f& values) {
  std::vector<float> known;
  std::copy_if(values.begin(), values.end(), std::back_inserter(known),
               [](float v) { return std::isfinite(v); });
  if (known.empty()) return {0, 1};
  const auto quantile = [&known](double share) {
    const auto at =
        known.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(known.size() - 1));
    std::nth_element(known.begin(), at, known.end());
    return static_cast<double>(*at);
  };
  return {quantile(0.01), quantile(0.99)};
}

/// One row: two pictures of half the width, named.
cv::Mat3b Row(const cv::Mat& first, const cv::Mat& second, const std::string& name, int width) {
  const cv::Size half(width / 2, width / 2 * first.rows / first.cols);
  cv::Mat a, b, row;
  cv::resize(first, a, half, 0, 0, cv::INTER_AREA);
  cv::resize(second, b, half, 0, 0, cv::INTER_AREA);
  cv::hconcat(a, b, row);
  const cv::Point at(6, half.height - 8);
  cv::putText(row, name, at, cv::FONT_HERSHEY_SIMPLEX, 0.5, cv::Scalar::all(0), 3, cv::LINE_AA);
  cv::putText(row, name, at, cv::FONT_HERSHEY_SIMPLEX, 0.5, cv::Scalar::all(255), 1, cv::LINE_AA);
  return row;
}

}  // namespace

cv::Mat3b ComparePictures(const PairWithTruth& pair,
                          const std::vector<std::pair<std::string, DisparityField>>& fields,
                          int width) {
  const auto [low, high] = RangeOf(pair.dx);
  cv::Mat left = pair.left;
  if (left.channels() == 1) cv::cvtColor(left, left, cv::COLOR_GRAY2BGR);
  std::vector<cv::Mat> rows = {
      Row(left, Coloured(pair.dx, low, high, cv::COLORMAP_TURBO), "left image, true dx", width)};
  for (const auto& [name, field] : fields) {
    rows.push_back(Row(Coloured(field.dx, low, high, cv::COLORMAP_TURBO),
                       Coloured(ErrorOf(field, pair), 0, kWorstPx, cv::COLORMAP_HOT), name, width));
  }
  cv::Mat out;
  cv::vconcat(rows, out);
  return out;
}

}  // namespace horopter::vision::testing
