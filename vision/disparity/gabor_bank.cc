// SPDX-License-Identifier: Apache-2.0
#include "vision/disparity/gabor_bank.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace horopter::vision {
namespace {

cv::Mat1f Separable(const cv::Mat1f& image, const cv::Mat1f& along_x, const cv::Mat1f& along_y) {
  cv::Mat1f out;
  cv::sepFilter2D(image, out, CV_32F, along_x, along_y, cv::Point(-1, -1), 0, cv::BORDER_REPLICATE);
  return out;
}

/// The mean of four pixels' values. A fixed count of them makes fixed loops.
template <int kCount>
void Interpolate(const float* top, const float* bottom, std::ptrdiff_t right, float ax, float ay,
                 int count, float* __restrict out) {
  if (kCount > 0) count = kCount;
  const float w00 = (1 - ax) * (1 - ay), w10 = ax * (1 - ay), w01 = (1 - ax) * ay, w11 = ax * ay;
  for (int i = 0; i < count; ++i) {
    out[i] = w00 * top[i] + w10 * top[right + i] + w01 * bottom[i] + w11 * bottom[right + i];
  }
}

}  // namespace

void SimpleCellMap::At(float x, float y, float* cells) const {
  const int x0 = static_cast<int>(x);
  const int y0 = static_cast<int>(y);
  const std::ptrdiff_t count = 2 * static_cast<std::ptrdiff_t>(orientations_);
  const std::ptrdiff_t right = x0 + 1 < size_.width ? count : 0;
  const float* top = data_.ptr<float>(y0) + x0 * count;
  const float* bottom = data_.ptr<float>(std::min(y0 + 1, size_.height - 1)) + x0 * count;
  const auto interpolate =
      orientations_ == kOrientations ? Interpolate<2 * kOrientations> : Interpolate<0>;
  interpolate(top, bottom, right, x - static_cast<float>(x0), y - static_cast<float>(y0),
              static_cast<int>(count), cells);
}

GaborBank::GaborBank(const V1Config& config) : orientations_(config.orientations) {
  gaussian_ = MakeKernel(config, 0).even;
  for (int i = 0; i <= orientations_ / 2; ++i) {
    const double theta = OrientationRad(i, orientations_);
    along_x_.push_back(MakeKernel(config, config.peak_frequency * std::cos(theta)));
    along_y_.push_back(MakeKernel(config, config.peak_frequency * std::sin(theta)));
  }
}

GaborBank::Kernel1D GaborBank::MakeKernel(const V1Config& config, double frequency) const {
  const int radius = config.filter_px / 2;
  const double sigma2 = config.envelope_sigma_px * config.envelope_sigma_px;
  double gaussian_sum = 0;
  for (int t = -radius; t <= radius; ++t) gaussian_sum += std::exp(-t * t / (2 * sigma2));

  // A correlation with exp(-i k t), as an analysing filter has it, so that the response to
  // exp(i k x) oscillates as exp(i k x).
  Kernel1D kernel{cv::Mat1f(1, config.filter_px), cv::Mat1f(1, config.filter_px), 0};
  for (int t = -radius; t <= radius; ++t) {
    const double weight = std::exp(-t * t / (2 * sigma2)) / gaussian_sum;
    const double phase = 2 * CV_PI * frequency * t;
    kernel.even(0, t + radius) = static_cast<float>(weight * std::cos(phase));
    kernel.odd(0, t + radius) = static_cast<float>(-weight * std::sin(phase));
    kernel.even_sum += weight * std::cos(phase);
  }
  return kernel;
}

SimpleCellMap GaborBank::Apply(const cv::Mat1f& grey) const {
  SimpleCellMap out(grey.size(), orientations_);
  const cv::Mat1f blurred = Separable(grey, gaussian_, gaussian_);
  cv::parallel_for_(cv::Range(0, orientations_ / 2 + 1), [&](const cv::Range& range) {
    for (int i = range.start; i < range.end; ++i) FilterOrientation(grey, blurred, i, out);
  });
  return out;
}

void GaborBank::FilterOrientation(const cv::Mat1f& grey, const cv::Mat1f& blurred, int i,
                                  SimpleCellMap& out) const {
  const Kernel1D& kx = along_x_[i];
  const Kernel1D& ky = along_y_[i];
  const cv::Mat1f even_even = Separable(grey, kx.even, ky.even);
  const cv::Mat1f odd_odd = Separable(grey, kx.odd, ky.odd);
  const cv::Mat1f odd_even = Separable(grey, kx.odd, ky.even);
  const cv::Mat1f even_odd = Separable(grey, kx.even, ky.odd);
  const float dc = static_cast<float>(kx.even_sum * ky.even_sum);
  const int n = orientations_;
  const int mirror = (n - i) % n;  // 0 and pi / 2 mirror themselves
  for (int y = 0; y < grey.rows; ++y) {
    float* even = out.data(y);
    for (int x = 0; x < grey.cols; ++x, even += 2 * n) {
      float* odd = even + n;
      const float balance = dc * blurred(y, x);
      even[mirror] = even_even(y, x) + odd_odd(y, x) - balance;
      odd[mirror] = even_odd(y, x) - odd_even(y, x);
      even[i] = even_even(y, x) - odd_odd(y, x) - balance;
      odd[i] = odd_even(y, x) + even_odd(y, x);
    }
  }
}

}  // namespace horopter::vision
