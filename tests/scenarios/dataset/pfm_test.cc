// SPDX-License-Identifier: Apache-2.0
#include "scenarios/dataset/pfm.h"

#include <cmath>
#include <limits>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <stdexcept>
#include <vector>

#include "tests/scenarios/dataset/bytes.h"

namespace horopter::scenarios {
namespace {

using testing::HasSubstr;

/// Top row 1, NaN; bottom row -2, 0.5.
cv::Mat1f Small() {
  return (cv::Mat1f(2, 2) << 1, std::numeric_limits<float>::quiet_NaN(), -2, 0.5);
}

std::string SmallBytes() {
  return "Pf\n2 2\n-1.0\n" + Bytes({0, 0, 0, 0xc0, 0, 0, 0, 0x3f,          // bottom row first
                                    0, 0, 0x80, 0x3f, 0, 0, 0x80, 0x7f});  // 1, infinity
}

TEST(Pfm, IsTheFormatByteForByteBottomRowFirst) { EXPECT_EQ(EncodePfm(Small()), SmallBytes()); }

TEST(Pfm, ReadsBackWithUnknownAsInfinity) {
  const cv::Mat1f read = DecodePfm(SmallBytes(), "d.pfm");
  EXPECT_EQ(read(0, 0), 1);
  EXPECT_EQ(read(0, 1), std::numeric_limits<float>::infinity());
  EXPECT_EQ(read(1, 0), -2);
  EXPECT_EQ(read(1, 1), 0.5);
}

TEST(Pfm, ReadsBigEndianWhereTheScaleIsPositive) {
  const cv::Mat1f read =
      DecodePfm("Pf 1 2 1\n" + Bytes({0xc0, 0, 0, 0, 0x3f, 0x80, 0, 0}), "d.pfm");
  EXPECT_EQ(read(0, 0), 1);
  EXPECT_EQ(read(1, 0), -2);
}

TEST(Pfm, IgnoresTheScalesMagnitude) {
  const cv::Mat1f read = DecodePfm("Pf\n1 1\n-0.003922\n" + Bytes({0, 0, 0x80, 0x3f}), "d.pfm");
  EXPECT_EQ(read(0, 0), 1);
}

TEST(Pfm, KeepsEveryBitOfOneAndThreeChannels) {
  for (const int type : {CV_32FC1, CV_32FC3}) {
    cv::Mat map(19, 31, type);
    cv::RNG(3).fill(map, cv::RNG::NORMAL, 0, 5);
    const cv::Mat read = DecodePfm(EncodePfm(map), "d.pfm");
    ASSERT_EQ(read.type(), type);
    EXPECT_EQ(cv::norm(read, map, cv::NORM_INF), 0);
  }
}

TEST(Pfm, OpenCvReadsTheSame) {
  cv::Mat1f map(7, 5);
  cv::RNG(8).fill(map, cv::RNG::NORMAL, 0, 5);
  const std::string bytes = EncodePfm(map);
  const cv::Mat theirs =
      cv::imdecode(std::vector<uchar>(bytes.begin(), bytes.end()), cv::IMREAD_UNCHANGED);
  ASSERT_EQ(theirs.size(), map.size());
  EXPECT_EQ(cv::norm(theirs, map, cv::NORM_INF), 0);
}

TEST(Pfm, NamesWhatIsWrong) {
  const auto complaint = [](std::string bytes) {
    return FormatComplaint([&] { DecodePfm(bytes, "d.pfm"); });
  };
  const std::string good = SmallBytes();
  EXPECT_THAT(complaint(""), HasSubstr("d.pfm: no .pfm file"));
  EXPECT_THAT(complaint("P6\n2 2\n255\n"), HasSubstr("neither Pf nor PF"));
  EXPECT_THAT(complaint("Pf\n2"), HasSubstr("no width"));
  EXPECT_THAT(complaint("Pf\n2 2\n"), HasSubstr("no scale"));
  EXPECT_THAT(complaint("Pf\n2 2\n-1.0"), HasSubstr("no scale")) << "its end belongs to it";
  EXPECT_THAT(complaint("Pf\ntwo 2\n-1\n"), HasSubstr("width 'two' is no number"));
  EXPECT_THAT(complaint("Pf\n2 2.5\n-1\n"), HasSubstr("height '2.5' is no number"));
  EXPECT_THAT(complaint("Pf\n0 2\n-1\n"), HasSubstr("size 0 x 2"));
  EXPECT_THAT(complaint("Pf\n2 100000\n-1\n"), HasSubstr("must be 1 to 99999"));
  EXPECT_THAT(complaint("Pf\n2 2\n0\n"), HasSubstr("scale 0"));
  EXPECT_THAT(complaint("Pf\n2 2\nnan\n"), HasSubstr("scale nan"));
  EXPECT_THAT(complaint(good.substr(0, good.size() - 1)), HasSubstr("truncated: 27 bytes"));
  EXPECT_THAT(complaint(good + "x"), HasSubstr("bytes left over: 29"));
  EXPECT_THAT(complaint("PF" + good.substr(2)), HasSubstr("2 x 2 x 3 floats take 60"));
}

TEST(Pfm, HoldsFloatsInOneOrThreeChannels) {
  EXPECT_THROW(EncodePfm(cv::Mat1b(2, 2)), std::invalid_argument);
  EXPECT_THROW(EncodePfm(cv::Mat2f(2, 2)), std::invalid_argument);
  EXPECT_THROW(EncodePfm(cv::Mat()), std::invalid_argument);
}

}  // namespace
}  // namespace horopter::scenarios
