// SPDX-License-Identifier: Apache-2.0
#include "vision/disparity/image_pair.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <opencv2/core.hpp>
#include <stdexcept>

namespace horopter::vision {
namespace {

std::string Complaint(const cv::Mat& left, const cv::Mat& right) {
  try {
    CheckPair(left, right);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(ImagePair, MismatchStatesBothSizesAndTypes) {
  using ::testing::HasSubstr;
  const std::string sizes = Complaint(cv::Mat1b(10, 20), cv::Mat1b(10, 21));
  EXPECT_THAT(sizes, HasSubstr("left is 20x10 CV_8UC1"));
  EXPECT_THAT(sizes, HasSubstr("right is 21x10 CV_8UC1"));
  const std::string types = Complaint(cv::Mat1b(10, 20), cv::Mat3b(10, 20));
  EXPECT_THAT(types, HasSubstr("CV_8UC1"));
  EXPECT_THAT(types, HasSubstr("CV_8UC3"));
  EXPECT_THAT(Complaint(cv::Mat1f(4, 4), cv::Mat1f(4, 4)), HasSubstr("CV_32FC1"));
  EXPECT_THAT(Complaint(cv::Mat(), cv::Mat()), HasSubstr("0x0"));
}

TEST(ImagePair, AcceptsWhatTheContractSays) {
  EXPECT_EQ(Complaint(cv::Mat1b(1, 1), cv::Mat1b(1, 1)), "");
  EXPECT_EQ(Complaint(cv::Mat3b(3, 5), cv::Mat3b(3, 5)), "");
}

TEST(ImagePair, GreyOfColourlessColourIsTheGrey) {
  cv::Mat1b grey(1, 256);
  for (int i = 0; i < 256; ++i) grey(0, i) = static_cast<unsigned char>(i);
  cv::Mat bgr;
  cv::merge(std::vector<cv::Mat>{grey, grey, grey}, bgr);
  EXPECT_EQ(cv::norm(ToGrey(bgr), grey, cv::NORM_INF), 0);
}

}  // namespace
}  // namespace horopter::vision
