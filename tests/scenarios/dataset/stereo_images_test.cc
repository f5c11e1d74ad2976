// SPDX-License-Identifier: Apache-2.0
#include "scenarios/dataset/stereo_images.h"

#include <limits>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <string>
#include <vector>

#include "tests/scenarios/dataset/bytes.h"

namespace horopter::scenarios {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// Grey levels 0 to 255.
cv::Mat1b Ramp() {
  cv::Mat1b ramp(16, 16);
  for (int i = 0; i < 256; ++i) ramp(i / 16, i % 16) = static_cast<uchar>(i);
  return ramp;
}

cv::Mat As(const cv::Mat& pixels, int depth, double factor) {
  cv::Mat out;
  pixels.convertTo(out, depth, factor);
  return out;
}

cv::Mat Colour(const cv::Mat& grey) {
  cv::Mat out;
  cv::merge(std::vector<cv::Mat>(3, grey), out);
  return out;
}

StereoImages Convert(const cv::Mat& left, const cv::Mat& right) {
  return ConvertStereoImages({"l.png", left}, {"r.png", right});
}

std::string Complaint(const cv::Mat& left, const cv::Mat& right) {
  return FormatComplaint([&] { Convert(left, right); });
}

bool Same(const cv::Mat& a, const cv::Mat& b) {
  return a.type() == b.type() && a.size() == b.size() && cv::norm(a, b, cv::NORM_INF) == 0;
}

TEST(StereoImages, EightBitsStayAsTheyAre) {
  const StereoImages grey = Convert(Ramp(), 255 - Ramp());
  EXPECT_TRUE(Same(grey.left, Ramp()));
  EXPECT_THAT(grey.notes, IsEmpty());
  EXPECT_TRUE(Same(Convert(Colour(Ramp()), Colour(Ramp())).left, Colour(Ramp())));
}

TEST(StereoImages, DeeperImagesAreScaledByTheirBits) {
  // Full scale of 16, 12 and 10 bits, all stored in 16; and floats to 1 and to 255.
  for (const double full : {65535.0, 4095.0, 1023.0}) {
    const StereoImages pair =
        Convert(As(Ramp(), CV_16U, full / 255), As(Ramp(), CV_16U, full / 255));
    EXPECT_LE(cv::norm(pair.left, Ramp(), cv::NORM_INF), 1) << full;
    EXPECT_EQ(pair.left.type(), CV_8UC1);
  }
  for (const double full : {1.0, 255.0}) {
    for (const int depth : {CV_32F, CV_64F}) {
      const StereoImages pair =
          Convert(As(Ramp(), depth, full / 255), As(Ramp(), depth, full / 255));
      EXPECT_TRUE(Same(pair.left, Ramp())) << full;
    }
  }
}

TEST(StereoImages, OneFactorForBothEyes) {
  const StereoImages pair = Convert(As(Ramp(), CV_16U, 257), As(Ramp(), CV_16U, 257.0 / 4));
  EXPECT_TRUE(Same(pair.left, Ramp()));
  EXPECT_LE(cv::norm(pair.right, As(Ramp(), CV_8U, 0.25), cv::NORM_INF), 1)
      << "an eye of a quarter of the exposure stays so";
  EXPECT_THAT(pair.notes, IsEmpty());
}

TEST(StereoImages, AHotPixelDoesNotDarkenTheRest) {
  cv::Mat1w left(100, 100, std::uint16_t{1000}), right = left.clone();
  left(3, 3) = 65535;
  const StereoImages pair = Convert(left, right);
  EXPECT_EQ(pair.left.at<uchar>(0, 0), cvRound(1000 * 255.0 / 1023));
  EXPECT_EQ(pair.left.at<uchar>(3, 3), 255);
}

TEST(StereoImages, MixedDepthsAndColoursAreConvertedAndSaidSo) {
  const StereoImages depths = Convert(Ramp(), As(Ramp(), CV_16U, 257));
  EXPECT_TRUE(Same(depths.left, Ramp()) && Same(depths.right, Ramp()));
  EXPECT_THAT(depths.notes, ElementsAre("l.png has 8 bits and r.png more: it is scaled by itself"));
  const StereoImages colours = Convert(Colour(Ramp()), Ramp());
  EXPECT_TRUE(Same(colours.left, Ramp()) && Same(colours.right, Ramp()));
  EXPECT_THAT(colours.notes, ElementsAre("r.png is grey: l.png is taken in grey, too"));
  cv::Mat alpha;
  cv::cvtColor(Colour(Ramp()), alpha, cv::COLOR_BGR2BGRA);
  EXPECT_TRUE(Same(Convert(alpha, alpha).left, Colour(Ramp())));
}

TEST(StereoImages, RefusesOtherSizesAndWhatIsNoNumber) {
  EXPECT_EQ(Complaint(cv::Mat1b(3, 4), cv::Mat1b(3, 5)),
            "l.png is 4x3, r.png is 5x3: both eyes must have one size");
  cv::Mat1f floats = cv::Mat1f::ones(4, 6);
  floats(3, 2) = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THAT(Complaint(cv::Mat1f::ones(4, 6), floats),
              HasSubstr("r.png: NaN or infinite at (2, 3)"));
}

TEST(StereoImages, OnePixelIsAPair) {
  EXPECT_EQ(
      Convert(cv::Mat1w(1, 1, std::uint16_t{65535}), cv::Mat1w::zeros(1, 1)).left.at<uchar>(0),
      255);
}

}  // namespace
}  // namespace horopter::scenarios
