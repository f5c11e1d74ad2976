// SPDX-License-Identifier: Apache-2.0
#include "sim/camera/bilinear_row.h"

#include <opencv2/core.hpp>

namespace horopter::sim {
namespace {

/// Eight bytes are read where six are meant: no pixel beyond the third-last begins a pair.
constexpr float kAlmostOne = (kPlaceSteps - 1.0F) / kPlaceSteps;

SampleSource SourceOf(const cv::Mat3b& image, const BilinearRow::Places& places) {
  CV_Assert(image.cols >= 4 && image.rows >= 2 && image.rows <= BilinearRow::kLargestSide &&
            image.step <= static_cast<std::size_t>(3 * BilinearRow::kLargestSide));
  return {image.ptr(),
          static_cast<int>(image.step),
          static_cast<float>(image.cols - 3) + kAlmostOne,
          static_cast<float>(image.rows - 2) + kAlmostOne,
          places.H.data(),
          places.e.data()};
}

}  // namespace

void BilinearRow::Start(int width) {
  width_ = width;
  count_ = 0;
  sum_.assign(4 * RoundedUp(width), 0);
}

void BilinearRow::Add(const cv::Mat3b& image, const Places& places) {
  kernels_->add_samples(SourceOf(image, places), {places.x, places.y, places.w, width_},
                        sum_.data());
  ++count_;
}

void BilinearRow::Store(std::uint8_t* row) const {
  kernels_->store_means(sum_.data(), width_, count_, row);
}

void BilinearRow::Sample(const cv::Mat3b& image, const Places& places, int width,
                         std::uint8_t* row) const {
  kernels_->sample(SourceOf(image, places), {places.x, places.y, places.w, width}, row);
}

}  // namespace horopter::sim
