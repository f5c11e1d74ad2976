// SPDX-License-Identifier: Apache-2.0
// Smoothing of a field, of every instruction set, against plain loops.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>
#include <vector>

#include "kernel_test.h"
#include "vision/disparity/closed_form_kernels.h"

namespace horopter::vision {
namespace {

using Field = std::vector<float>;

class SmoothKernels : public testing::KernelTest {
 protected:
  static constexpr float kUntouched = 12345;
  static constexpr float kStep = 1;

  /// Surfaces of a disparity each, 7 px apart, with noise that lies within a step or not.
  void MakeField(cv::Size size) {
    size_ = size;
    const std::size_t pixels = static_cast<std::size_t>(size.area());
    cv::RNG random(13);
    for (Field* field : {&dx_, &dy_}) {
      field->assign(pixels + 16, 1000);
      for (std::size_t i = 0; i < pixels; ++i) {
        (*field)[i] = static_cast<float>(7 * random.uniform(0, 2) + random.gaussian(0.5));
      }
    }
    out_dx_.assign(pixels + 16, kUntouched);
    out_dy_.assign(pixels + 16, kUntouched);
  }
  SmoothTask Task(int radius) {
    return {dx_.data(),  dy_.data(),   out_dx_.data(), out_dy_.data(),
            size_.width, size_.height, radius,         kStep};
  }
  std::size_t At(int x, int y) const { return static_cast<std::size_t>(y) * size_.width + x; }

  /// The mean over those of the neighbours, `radius` to either side along a step, that are near.
  cv::Vec2d MeanOfTheNear(int x, int y, int radius, cv::Point step) const {
    cv::Vec2d sum(0, 0);
    int count = 0;
    for (int i = -radius; i <= radius; ++i) {
      const cv::Point p = cv::Point(x, y) + i * step;
      if (!cv::Rect({}, size_).contains(p)) continue;
      const float x_apart = dx_[At(p.x, p.y)] - dx_[At(x, y)];
      const float y_apart = dy_[At(p.x, p.y)] - dy_[At(x, y)];
      if (std::abs(x_apart) > kStep || std::abs(y_apart) > kStep) continue;
      sum += cv::Vec2d(dx_[At(p.x, p.y)], dy_[At(p.x, p.y)]);
      ++count;
    }
    return sum / count;
  }
  /// Sums of at most 33 floats of about 10 are good to 1e-5.
  void ExpectMeans(int radius, cv::Point step) const {
    for (int y = 0; y < size_.height; ++y) {
      for (int x = 0; x < size_.width; ++x) {
        const cv::Vec2d expected = MeanOfTheNear(x, y, radius, step);
        ASSERT_NEAR(out_dx_[At(x, y)], expected[0], 1e-5) << size_ << " " << x << " " << y;
        ASSERT_NEAR(out_dy_[At(x, y)], expected[1], 1e-5) << size_ << " " << x << " " << y;
      }
    }
    EXPECT_EQ(out_dx_[At(0, size_.height)], kUntouched) << "written behind the last pixel";
    EXPECT_EQ(out_dy_[At(0, size_.height)], kUntouched) << "written behind the last pixel";
  }

  cv::Size size_;
  Field dx_, dy_, out_dx_, out_dy_;
};

INSTANTIATE_TEST_SUITE_P(All, SmoothKernels, testing::EveryKernel(), testing::NameOf);

const std::vector<cv::Size> kSizes = {{1, 1}, {5, 3}, {8, 8}, {61, 17}, {64, 40}, {83, 2}};

TEST_P(SmoothKernels, RowsAreMeansOfWhatIsNear) {
  for (const cv::Size size : kSizes) {
    for (const int radius : {1, 4, 16}) {
      MakeField(size);
      std::vector<float> scratch(2 * PaddedRow(size.width, radius));
      for (int y = 0; y < size.height; ++y) kernels_.smooth_row(Task(radius), y, scratch.data());
      ExpectMeans(radius, {1, 0});
    }
  }
}

TEST_P(SmoothKernels, ColumnsAreMeansOfWhatIsNear) {
  for (const cv::Size size : kSizes) {
    for (const int radius : {1, 4, 16}) {
      MakeField(size);
      for (int y = 0; y < size.height; ++y) kernels_.smooth_across_rows(Task(radius), y);
      ExpectMeans(radius, {0, 1});
    }
  }
}

}  // namespace
}  // namespace horopter::vision
