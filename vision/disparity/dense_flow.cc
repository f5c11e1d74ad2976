// SPDX-License-Identifier: Apache-2.0
#include "vision/disparity/dense_flow.h"

#include <algorithm>
#include <opencv2/core.hpp>

#include "vision/disparity/image_pair.h"
#include "vision/disparity/left_right_check.h"

namespace horopter::vision {
namespace {

constexpr int kSmallestSide = 16;  // below, cv::DISOpticalFlow throws or has no octave to start at

/// cv::DISOpticalFlow does not take a part of a larger image.
cv::Mat1b Continuous(const cv::Mat1b& grey) { return grey.isContinuous() ? grey : grey.clone(); }

DisparityField OneWay(const cv::Mat1b& from, const cv::Mat1b& to, const DenseFlow& flow,
                      const TextureCheck& texture) {
  const cv::Size size = from.size();
  DisparityField field{cv::Mat1f::zeros(size), cv::Mat1f::zeros(size), cv::Mat1f::ones(size),
                       cv::Mat1b::zeros(size)};
  if (std::min(size.width, size.height) < kSmallestSide) return field;
  const cv::Mat2f vectors = flow(from, to);
  cv::extractChannel(vectors, field.dx, 0);
  cv::extractChannel(vectors, field.dy, 1);
  field.valid = texture.Apply(from);
  InvalidateOutside(field);
  return field;
}

}  // namespace

DisparityField DisparityByFlow(const cv::Mat& left, const cv::Mat& right, const DenseFlow& flow,
                               const TextureCheck& texture, double left_right_px,
                               hardware::StageTimes* times) {
  CheckPair(left, right);
  const cv::Mat1b left_grey = Continuous(ToGrey(left));
  const cv::Mat1b right_grey = Continuous(ToGrey(right));
  DisparityField field, back;
  hardware::MeasureIf(times, "flow", [&] {
    field = OneWay(left_grey, right_grey, flow, texture);
    if (left_right_px > 0) back = OneWay(right_grey, left_grey, flow, texture);
  });
  hardware::MeasureIf(times, "checks", [&] {
    if (left_right_px > 0) CheckLeftRight(back, left_right_px, field);
    BlankInvalid(field);
  });
  return field;
}

}  // namespace horopter::vision
