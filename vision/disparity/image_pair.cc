// SPDX-License-Identifier: Apache-2.0
#include "vision/disparity/image_pair.h"

#include <opencv2/imgproc.hpp>
#include <stdexcept>
#include <string>

namespace horopter::vision {
namespace {

std::string Describe(const cv::Mat& image) {
  return std::to_string(image.cols) + "x" + std::to_string(image.rows) + " " +
         cv::typeToString(image.type());
}

bool Usable(const cv::Mat& image) {
  return !image.empty() && image.dims == 2 && (image.type() == CV_8UC1 || image.type() == CV_8UC3);
}

}  // namespace

void CheckPair(const cv::Mat& left, const cv::Mat& right) {
  if (Usable(left) && Usable(right) && left.size() == right.size() && left.type() == right.type()) {
    return;
  }
  throw std::invalid_argument("stereo pair: left is " + Describe(left) + ", right is " +
                              Describe(right) +
                              "; both must be CV_8UC1 or CV_8UC3 (BGR), of the same size and type, "
                              "at least 1x1");
}

cv::Mat1b ToGrey(const cv::Mat& image) {
  if (image.channels() == 1) return image;
  cv::Mat1b grey;
  cv::cvtColor(image, grey, cv::COLOR_BGR2GRAY);
  return grey;
}

}  // namespace horopter::vision
