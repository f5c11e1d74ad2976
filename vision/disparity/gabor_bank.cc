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

}  // namespace

SimpleCells SimpleCellMap::At(float x, float y) const {
  const int x0 = static_cast<int>(x);
  const int y0 = static_cast<int>(y);
  const int right = x0 + 1 < size_.width ? 1 : 0;
  const SimpleCells* top = row(y0) + x0;
  const SimpleCells* bottom = row(std::min(y0 + 1, size_.height - 1)) + x0;
  const float ax = x - static_cast<float>(x0);
  const float ay = y - static_cast<float>(y0);
  const float w00 = (1 - ax) * (1 - ay), w10 = ax * (1 - ay), w01 = (1 - ax) * ay, w11 = ax * ay;
  SimpleCells out;
  for (int i = 0; i < kOrientations; ++i) {
    out.even[i] = w00 * top[0].even[i] + w10 * top[right].even[i] + w01 * bottom[0].even[i] +
                  w11 * bottom[right].even[i];
  }
  for (int i = 0; i < kOrientations; ++i) {
    out.odd[i] = w00 * top[0].odd[i] + w10 * top[right].odd[i] + w01 * bottom[0].odd[i] +
                 w11 * bottom[right].odd[i];
  }
  return out;
}

GaborBank::GaborBank(const V1Config& config) {
  gaussian_ = MakeKernel(config, 0).even;
  for (int i = 0; i <= kOrientations / 2; ++i) {
    along_x_[i] = MakeKernel(config, config.peak_frequency * std::cos(OrientationRad(i)));
    along_y_[i] = MakeKernel(config, config.peak_frequency * std::sin(OrientationRad(i)));
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
  SimpleCellMap out(grey.size());
  const cv::Mat1f blurred = Separable(grey, gaussian_, gaussian_);
  cv::parallel_for_(cv::Range(0, kOrientations / 2 + 1), [&](const cv::Range& range) {
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
  const int mirror = (kOrientations - i) % kOrientations;  // 0 and pi / 2 mirror themselves
  for (int y = 0; y < grey.rows; ++y) {
    SimpleCells* cells = out.row(y);
    for (int x = 0; x < grey.cols; ++x) {
      const float balance = dc * blurred(y, x);
      cells[x].even[mirror] = even_even(y, x) + odd_odd(y, x) - balance;
      cells[x].odd[mirror] = even_odd(y, x) - odd_even(y, x);
      cells[x].even[i] = even_even(y, x) - odd_odd(y, x) - balance;
      cells[x].odd[i] = odd_even(y, x) + even_odd(y, x);
    }
  }
}

}  // namespace horopter::vision
