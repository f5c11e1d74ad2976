// SPDX-License-Identifier: Apache-2.0
#include "sim/camera/bilinear_row.h"

#include <algorithm>
#include <opencv2/core.hpp>

namespace horopter::sim {
namespace {

/// Eight bytes are read where six are meant: no pixel beyond the third-last begins a pair.
constexpr float kAlmostOne = (kPlaceSteps - 1.0F) / kPlaceSteps;

}  // namespace

void BilinearRow::Add(const cv::Mat3b& image, const Eigen::Matrix3f& H, const Eigen::Vector3f& e) {
  CV_Assert(image.cols >= 4 && image.rows >= 2 && image.rows <= kLargestSide &&
            image.step <= static_cast<std::size_t>(3 * kLargestSide));
  SampleSource& from = from_.emplace_back();
  from.pixels = image.ptr();
  from.stride = static_cast<int>(image.step);
  from.last_x = static_cast<float>(image.cols - 3) + kAlmostOne;
  from.last_y = static_cast<float>(image.rows - 2) + kAlmostOne;
  std::copy_n(H.data(), 9, from.h);
  std::copy_n(e.data(), 3, from.e);
}

}  // namespace horopter::sim
