// SPDX-License-Identifier: Apache-2.0
#include "vision/disparity/search_range.h"

#include <algorithm>
#include <opencv2/core.hpp>

#include "hardware/types/field_checker.h"
#include "vision/disparity/left_right_check.h"

namespace horopter::vision {
namespace {

constexpr int kSteps = 16;       // of a pixel, in OpenCV's disparities, and their count's divisor
constexpr int kFurthest = 2000;  // so that 16 times it, and more, are 16 bits

}  // namespace

SearchRange SearchRange::Covering(int min_px, int end_px) {
  return {min_px, (std::max(end_px - min_px, 1) + kSteps - 1) / kSteps * kSteps};
}

std::vector<hardware::FieldError> SearchRange::Validate() const {
  hardware::FieldChecker check("range.");
  check.Require(min_px >= -kFurthest && min_px <= kFurthest, "min_px", min_px,
                "must be -2000 to 2000");
  check.Require(count_px >= kSteps && count_px <= kFurthest && count_px % kSteps == 0, "count_px",
                count_px, "must be a multiple of 16, 16 to 2000");
  return check.Take();
}

int SearchRange::UnmatchedColumns() const {
  return std::max(min_px + count_px, 0) + std::max(-min_px, 0);
}

DisparityField FieldOfDisparity(const cv::Mat1s& disparity_16, const SearchRange& range,
                                const cv::Mat1b& textured) {
  const cv::Size size = disparity_16.size();
  DisparityField field{cv::Mat1f(size), cv::Mat1f::zeros(size), cv::Mat1f::ones(size),
                       cv::Mat1b(size)};
  disparity_16.convertTo(field.dx, CV_32F, -1.0 / kSteps);
  field.valid = disparity_16 >= kSteps * range.min_px;
  field.valid &= textured;
  InvalidateOutside(field);
  BlankInvalid(field);
  return field;
}

}  // namespace horopter::vision
