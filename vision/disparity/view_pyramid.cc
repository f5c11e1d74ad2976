// SPDX-License-Identifier: Apache-2.0
#include "vision/disparity/view_pyramid.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "vision/disparity/noise_level.h"

namespace horopter::vision {
namespace {

constexpr int kLeastSide = 2;

cv::Mat1f GreyOf(ViewOctave& octave) { return {octave.height, octave.width, octave.grey.data()}; }

}  // namespace

void ViewPyramid::Build(const cv::Mat& image, int octaves) {
  octaves_.resize(std::max<std::size_t>(octaves_.size(), octaves));
  octaves_[0].width = image.cols;
  octaves_[0].height = image.rows;
  octaves_[0].colour = image;
  octaves_[0].grey.Resize(image.cols, image.rows);
  cv::Mat1f grey = GreyOf(octaves_[0]);
  if (image.channels() == 1) {
    image.convertTo(grey, CV_32F);
  } else {
    cv::cvtColor(image, grey_8_, cv::COLOR_BGR2GRAY);
    grey_8_.convertTo(grey, CV_32F);
  }
  noise_grey_ = NoiseLevel(grey);
  size_ = 1;
  while (size_ < octaves) {
    const ViewOctave& last = octaves_[size_ - 1];
    if (std::min(last.width, last.height) < 2 * kLeastSide) break;
    Halve(size_++);
  }
  texture_grey_ = TextureLevel(GreyOf(octaves_[std::min(1, size_ - 1)]));
}

void ViewPyramid::Respond(int finest, double noise_grey, const CellBank& bank,
                          const ClosedFormKernels& kernels) {
  finest_ = std::min(finest, size_ - 1);
  for (int i = finest_; i < size_; ++i) {
    ViewOctave& octave = octaves_[i];
    bank.Apply(kernels, octave.grey.data(), octave.width, octave.height, octave.cells);
    const double ignored = kEdgeNoise * NoiseAtOctave(noise_grey, i);
    FindEdges(octave.colour, static_cast<int>(std::lround(ignored)), octave.edges);
  }
}

void ViewPyramid::Halve(int index) {
  ViewOctave& from = octaves_[index - 1];
  ViewOctave& to = octaves_[index];
  to.width = (from.width + 1) / 2;
  to.height = (from.height + 1) / 2;
  to.grey.Resize(to.width, to.height);
  cv::Mat1f grey = GreyOf(to);
  cv::pyrDown(GreyOf(from), grey, grey.size(), cv::BORDER_REPLICATE);
  cv::pyrDown(from.colour, to.colour, grey.size(), cv::BORDER_REPLICATE);
}

}  // namespace horopter::vision
