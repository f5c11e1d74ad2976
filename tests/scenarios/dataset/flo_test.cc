// SPDX-License-Identifier: Apache-2.0
#include "scenarios/dataset/flo.h"

#include <cmath>
#include <limits>
#include <opencv2/core.hpp>
#include <stdexcept>

#include "tests/scenarios/dataset/bytes.h"

namespace horopter::scenarios {
namespace {

using testing::HasSubstr;

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

/// 2 x 1 pixels: (1.5, -2) and unknown.
DisplacementMaps Small() {
  return {(cv::Mat1f(1, 2) << 1.5f, kNaN), (cv::Mat1f(1, 2) << -2.0f, 3.0f)};
}

std::string SmallBytes() {
  return "PIEH" + Bytes({2,    0,    0,    0,    1,    0,    0,    0,       // width, height
                         0,    0,    0xc0, 0x3f, 0,    0,    0,    0xc0,    // 1.5, -2
                         0xf9, 0x02, 0x15, 0x50, 0xf9, 0x02, 0x15, 0x50});  // 1e10, twice
}

TEST(Flo, IsTheFormatByteForByte) { EXPECT_EQ(EncodeFlo(Small()), SmallBytes()); }

TEST(Flo, ReadsBackWhatItWroteAndKeepsUnknownPixelsUnknown) {
  const DisplacementMaps read = DecodeFlo(SmallBytes(), "f.flo");
  ASSERT_EQ(read.dx.size(), cv::Size(2, 1));
  EXPECT_EQ(read.dx(0, 0), 1.5f);
  EXPECT_EQ(read.dy(0, 0), -2.0f);
  EXPECT_TRUE(std::isnan(read.dx(0, 1)));
  EXPECT_TRUE(std::isnan(read.dy(0, 1)));
}

TEST(Flo, KeepsEveryBitOfARandomField) {
  DisplacementMaps field{cv::Mat1f(37, 23), cv::Mat1f(37, 23)};
  cv::RNG random(4);
  random.fill(field.dx, cv::RNG::NORMAL, 0, 50);
  random.fill(field.dy, cv::RNG::NORMAL, 0, 50);
  const DisplacementMaps read = DecodeFlo(EncodeFlo(field), "f.flo");
  EXPECT_EQ(cv::norm(read.dx, field.dx, cv::NORM_INF), 0);
  EXPECT_EQ(cv::norm(read.dy, field.dy, cv::NORM_INF), 0);
}

TEST(Flo, NamesWhatIsWrong) {
  const auto complaint = [](std::string bytes) {
    return FormatComplaint([&] { DecodeFlo(bytes, "f.flo"); });
  };
  const std::string good = SmallBytes();
  EXPECT_THAT(complaint(""), HasSubstr("f.flo: truncated: 0 bytes"));
  EXPECT_THAT(complaint(good.substr(0, 11)), HasSubstr("truncated: 11 bytes"));
  EXPECT_THAT(complaint(good.substr(0, 27)),
              HasSubstr("truncated: 27 bytes, 2 x 1 pixels take 28"));
  EXPECT_THAT(complaint(good + "x"), HasSubstr("bytes left over: 29"));
  EXPECT_THAT(complaint("PNG!" + good.substr(4)), HasSubstr("does not begin with PIEH"));
  EXPECT_THAT(complaint("HEIP" + good.substr(4)), HasSubstr("big-endian"));
  EXPECT_THAT(complaint("PIEH" + Bytes({0, 0, 0, 0, 1, 0, 0, 0})), HasSubstr("size 0 x 1"));
  EXPECT_THAT(complaint("PIEH" + Bytes({255, 255, 255, 255, 1, 0, 0, 0})),
              HasSubstr("size -1 x 1"));
  EXPECT_THAT(complaint("PIEH" + Bytes({0, 0, 0, 1, 1, 0, 0, 0})), HasSubstr("must be 1 to 99999"));
}

TEST(Flo, RefusesMapsThatDoNotMatch) {
  EXPECT_THROW(EncodeFlo({cv::Mat1f(2, 3), cv::Mat1f(3, 2)}), std::invalid_argument);
  EXPECT_THROW(EncodeFlo({}), std::invalid_argument);
}

}  // namespace
}  // namespace horopter::scenarios
