// SPDX-License-Identifier: Apache-2.0
// The closed form keeps its buffers from pair to pair.
#include <gtest/gtest.h>

#include <atomic>
#include <opencv2/core.hpp>

#include "textured_pair.h"
#include "vision/disparity/v1_closed_form.h"
#include "vision/disparity/v1_config.h"

namespace horopter::vision {
namespace {

/// Adds up the bytes of the matrices that anyone asks for while it lives.
class AllocationCount : public cv::MatAllocator {
 public:
  AllocationCount() : real_(cv::Mat::getDefaultAllocator()) { cv::Mat::setDefaultAllocator(this); }
  ~AllocationCount() override { cv::Mat::setDefaultAllocator(real_); }

  std::size_t bytes() const { return bytes_; }

  cv::UMatData* allocate(int dims, const int* sizes, int type, void* data, std::size_t* step,
                         cv::AccessFlag flags, cv::UMatUsageFlags usage) const override {
    std::size_t bytes = data == nullptr ? CV_ELEM_SIZE(type) : 0;
    for (int i = 0; i < dims; ++i) bytes *= static_cast<std::size_t>(sizes[i]);
    bytes_ += bytes;
    return real_->allocate(dims, sizes, type, data, step, flags, usage);
  }
  bool allocate(cv::UMatData* data, cv::AccessFlag flags, cv::UMatUsageFlags usage) const override {
    return real_->allocate(data, flags, usage);
  }
  void deallocate(cv::UMatData* data) const override { real_->deallocate(data); }

 private:
  cv::MatAllocator* real_;
  mutable std::atomic<std::size_t> bytes_ = 0;
};

TEST(V1Memory, ASecondPairTakesLittleMoreThanItsField) {
  const cv::Size size(320, 240);
  const testing::SyntheticPair pair = testing::ShiftedPair(size, 6.5, -1.5);
  constexpr std::size_t kFieldBytes = 3 * sizeof(float) + 1;
  for (const char* preset : {"accurate", "fast"}) {
    V1ClosedFormEstimator estimator(V1Config::Preset(preset).closed_form);
    DisparityField field = estimator.Estimate(pair.left, pair.right);
    AllocationCount count;
    field = estimator.Estimate(pair.left, pair.right);
    const double per_pixel = static_cast<double>(count.bytes()) / size.area();
    EXPECT_GE(per_pixel, kFieldBytes) << preset;
    EXPECT_LE(per_pixel, kFieldBytes + 8) << preset << ": masks of the checks";
  }
}

}  // namespace
}  // namespace horopter::vision
