// SPDX-License-Identifier: Apache-2.0
#include "scenarios/dataset/png16.h"

#include <cmath>
#include <limits>
#include <opencv2/core.hpp>
#include <stdexcept>

#include "tests/scenarios/dataset/bytes.h"

namespace horopter::scenarios {
namespace {

using testing::HasSubstr;

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// A PNG of 2 x 1 pixels of 16 bits, 0x0280 and 0xffff, put together by hand from the specification
/// (its data stored, not compressed), with check sums by an independent program.
std::string HandMade() {
  return Bytes({0x89, 'P',  'N',  'G',  13,   10,   26,   10,  //
                0,    0,    0,    13,   'I',  'H',  'D',  'R',  0,    0,    0,    2,
                0,    0,    0,    1,    16,   0,    0,    0,    0,  //
                0x81, 0xd9, 0xfc, 0x15,                             //
                0,    0,    0,    16,   'I',  'D',  'A',  'T',  0x78, 0x01, 0x01, 5,
                0,    0xfa, 0xff,                                      //
                0,    0x02, 0x80, 0xff, 0xff, 0x04, 0x8a, 0x02, 0x81,  //
                0x3a, 0x6e, 0x3e, 0xbf,                                //
                0,    0,    0,    0,    'I',  'E',  'N',  'D',  0xae, 0x42, 0x60, 0x82});
}

TEST(Png16, ReadsAFileMadeByHand) {
  const cv::Mat pixels = DecodePng16(HandMade(), 1, "d.png");
  ASSERT_EQ(pixels.size(), cv::Size(2, 1));
  EXPECT_EQ(pixels.at<std::uint16_t>(0, 0), 0x0280);
  EXPECT_EQ(pixels.at<std::uint16_t>(0, 1), 0xffff);
  EXPECT_EQ(UnpackKittiDisparity(pixels)(0, 0), 2.5f);
}

TEST(Png16, WritesSixteenBitsThatReadBack) {
  cv::Mat1w one(13, 7);
  cv::Mat3w three(13, 7);
  cv::RNG random(2);
  random.fill(one, cv::RNG::UNIFORM, 0, 65536);
  random.fill(three, cv::RNG::UNIFORM, 0, 65536);
  const std::string bytes = EncodePng(one);
  EXPECT_EQ(bytes.substr(12, 4), "IHDR");
  EXPECT_EQ(bytes.substr(16, 9), Bytes({0, 0, 0, 7, 0, 0, 0, 13, 16})) << "size and bit depth";
  EXPECT_EQ(bytes[25], 0) << "grey";
  EXPECT_EQ(cv::norm(DecodePng16(bytes, 1, "a"), one, cv::NORM_INF), 0);
  EXPECT_EQ(EncodePng(three)[25], 2) << "red, green, blue";
  EXPECT_EQ(cv::norm(DecodePng16(EncodePng(three), 3, "a"), three, cv::NORM_INF), 0);
}

TEST(Png16, NamesWhatIsWrong) {
  const auto complaint = [](std::string bytes, int channels = 1) {
    return FormatComplaint([&] { DecodePng16(bytes, channels, "d.png"); });
  };
  const std::string good = HandMade();
  EXPECT_THAT(complaint(""), HasSubstr("d.png: no PNG file"));
  EXPECT_THAT(complaint("GIF89a..."), HasSubstr("no PNG file"));
  for (const std::size_t kept : {8, 20, 40, 60, 70}) {
    EXPECT_THAT(complaint(good.substr(0, kept)), HasSubstr("truncated")) << kept;
  }
  EXPECT_THAT(complaint(good + "x"), HasSubstr("1 bytes left over"));
  std::string damaged = good;
  damaged[51] ^= 0x40;  // a pixel
  EXPECT_THAT(complaint(damaged), HasSubstr("damaged PNG"));
  EXPECT_THAT(complaint(good, 3), HasSubstr("1 channels of 16 bits, expected 3 of 16"));
  EXPECT_THAT(complaint(EncodePng(cv::Mat1b(2, 2, uchar{7}))), HasSubstr("1 channels of 8 bits"));
}

TEST(Png16, RefusesWhatNoPngHolds) {
  EXPECT_THROW(EncodePng(cv::Mat1f(2, 2)), std::invalid_argument);
  EXPECT_THROW(EncodePng(cv::Mat()), std::invalid_argument);
  EXPECT_THROW(EncodePng(cv::Mat2w(2, 2)), std::invalid_argument);
}

TEST(KittiDisparity, IsTwoHundredFiftySixTimesThePixelsAndZeroIsInvalid) {
  const Packed packed =
      PackKittiDisparity((cv::Mat1f(1, 6) << 2.5f, kNaN, 0.0005f, 255.99f, 256.1f, -1.0f));
  const cv::Mat1w pixels = packed.pixels;
  EXPECT_EQ(pixels(0, 0), 640);
  EXPECT_EQ(pixels(0, 1), 0);
  EXPECT_EQ(pixels(0, 2), 1) << "0 would be invalid";
  EXPECT_EQ(pixels(0, 3), 65533);
  EXPECT_EQ(pixels(0, 4), 0);
  EXPECT_EQ(pixels(0, 5), 0);
  EXPECT_EQ(packed.left_out, 2) << "too large, and negative";
  const cv::Mat1f read = UnpackKittiDisparity(pixels);
  EXPECT_EQ(read(0, 0), 2.5f);
  EXPECT_TRUE(std::isnan(read(0, 1)));
}

TEST(KittiFlow, IsSixtyFourTimesThePixelsAroundTwoToTheFifteen) {
  const Packed packed = PackKittiFlow(
      {(cv::Mat1f(1, 4) << 1.0f, -512.0f, kNaN, 512.0f), (cv::Mat1f(1, 4) << -0.5f, 0, 0, 0)});
  const cv::Mat3w pixels = packed.pixels;
  EXPECT_EQ(pixels(0, 0), cv::Vec3w(1, 32768 - 32, 32768 + 64)) << "blue, green, red";
  EXPECT_EQ(pixels(0, 1), cv::Vec3w(1, 32768, 0));
  EXPECT_EQ(pixels(0, 2), cv::Vec3w(0, 0, 0));
  EXPECT_EQ(pixels(0, 3), cv::Vec3w(0, 0, 0));
  EXPECT_EQ(packed.left_out, 1);
  const DisplacementMaps read = UnpackKittiFlow(pixels);
  EXPECT_EQ(read.dx(0, 0), 1);
  EXPECT_EQ(read.dy(0, 0), -0.5f);
  EXPECT_TRUE(std::isnan(read.dx(0, 2)));
}

TEST(DepthPng, CountsInStepsOfTheStatedScale) {
  const cv::Mat1f depth = (cv::Mat1f(1, 5) << 1.2344f, kInfinity, 65.6f, 0.0001f, kNaN);
  const Packed packed = PackDepth(depth, 1000);
  const cv::Mat1w pixels = packed.pixels;
  EXPECT_EQ(pixels(0, 0), 1234);
  EXPECT_EQ(pixels(0, 1), 0);
  EXPECT_EQ(pixels(0, 2), 0);
  EXPECT_EQ(pixels(0, 3), 0);
  EXPECT_EQ(packed.left_out, 2) << "too far for millimetres, and too near";
  EXPECT_NEAR(UnpackDepth(pixels, 1000)(0, 0), 1.234f, 1e-6);
  EXPECT_EQ(UnpackDepth(pixels, 1000)(0, 1), kInfinity);
  EXPECT_EQ(cv::Mat1w(PackDepth(depth, 5000).pixels)(0, 0), 6172);
}

TEST(IdPng, IsOneMoreThanTheIdAndZeroForNothing) {
  const cv::Mat1i ids = (cv::Mat1i(1, 3) << -1, 0, 65534);
  const cv::Mat1w pixels = PackIds(ids);
  EXPECT_EQ(pixels(0, 0), 0);
  EXPECT_EQ(pixels(0, 1), 1);
  EXPECT_EQ(pixels(0, 2), 65535);
  EXPECT_EQ(cv::countNonZero(UnpackIds(pixels) != ids), 0);
  EXPECT_THROW(PackIds((cv::Mat1i(1, 1) << 65535)), std::invalid_argument);
  EXPECT_THROW(PackIds((cv::Mat1i(1, 1) << -2)), std::invalid_argument);
}

}  // namespace
}  // namespace horopter::scenarios
