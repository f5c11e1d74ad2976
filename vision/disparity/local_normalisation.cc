// SPDX-License-Identifier: Apache-2.0
#include "vision/disparity/local_normalisation.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace horopter::vision {

cv::Mat1f NormaliseLocally(const cv::Mat1f& grey, int window_px, double floor_grey) {
  // In double: the variance is a small difference of large squares.
  cv::Mat1d exact, mean, mean_square;
  grey.convertTo(exact, CV_64F);
  const cv::Size window(window_px, window_px);
  cv::boxFilter(exact, mean, CV_64F, window, cv::Point(-1, -1), true, cv::BORDER_REPLICATE);
  cv::boxFilter(exact.mul(exact), mean_square, CV_64F, window, cv::Point(-1, -1), true,
                cv::BORDER_REPLICATE);
  cv::Mat1f out(grey.size());
  for (int y = 0; y < grey.rows; ++y) {
    for (int x = 0; x < grey.cols; ++x) {
      const double m = mean(y, x);
      const double variance = std::max(mean_square(y, x) - m * m, 0.0);
      out(y, x) =
          static_cast<float>((exact(y, x) - m) / std::sqrt(variance + floor_grey * floor_grey));
    }
  }
  return out;
}

}  // namespace horopter::vision
