// SPDX-License-Identifier: Apache-2.0
#include "scenarios/results/hasher.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

namespace horopter::scenarios {
namespace {

std::string HexOfBytes(const std::string& text) {
  Hasher hasher;
  hasher.Update(std::as_bytes(std::span(text)));
  return hasher.Hex();
}

template <typename... Values>
std::string HexOf(const Values&... values) {
  Hasher hasher;
  (hasher.Update(values), ...);
  return hasher.Hex();
}

// The examples that NIST publishes with FIPS 180.
TEST(Hasher, AgreesWithThePublishedVectors) {
  EXPECT_EQ(HexOfBytes(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(HexOfBytes("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(HexOfBytes("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  EXPECT_EQ(HexOfBytes(std::string(1000000, 'a')),
            "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(Hasher, DoesNotDependOnHowBytesArePortioned) {
  const std::string text(517, 'x');
  for (const std::size_t portion : {1u, 3u, 63u, 64u, 65u, 200u}) {
    Hasher hasher;
    for (std::size_t at = 0; at < text.size(); at += portion) {
      const std::string part = text.substr(at, portion);
      hasher.Update(std::as_bytes(std::span(part)));
    }
    EXPECT_EQ(hasher.Hex(), HexOfBytes(text)) << portion;
  }
}

TEST(Hasher, GoesOnAfterHex) {
  Hasher hasher;
  hasher.Update("first");
  const std::string half = hasher.Hex();
  EXPECT_EQ(half, hasher.Hex());
  hasher.Update("second");
  EXPECT_EQ(hasher.Hex(), HexOf("first", "second"));
  EXPECT_NE(hasher.Hex(), half);
}

TEST(Hasher, SeparatesTextsAndTheirOrder) {
  EXPECT_NE(HexOf("ab", "c"), HexOf("a", "bc"));
  EXPECT_NE(HexOf("a", "b"), HexOf("b", "a"));
}

TEST(Hasher, TellsNumbersApartByTheirBits) {
  EXPECT_NE(HexOf(1.0), HexOf(std::nextafter(1.0, 2)));
  EXPECT_NE(HexOf(1.0), HexOf(1));
  EXPECT_EQ(HexOf(std::numeric_limits<double>::quiet_NaN()), HexOf(-std::nan("7")));
}

TEST(Hasher, SeesEveryPixelAndTheShape) {
  cv::Mat3b image(6, 8, cv::Vec3b(1, 2, 3));
  const std::string before = HexOf(image);
  image(5, 7)[2] ^= 1;
  EXPECT_NE(HexOf(image), before);
  EXPECT_NE(HexOf(cv::Mat1b(4, 6, uchar{0})), HexOf(cv::Mat1b(6, 4, uchar{0})));
  EXPECT_NE(HexOf(cv::Mat1b(4, 6, uchar{0})), HexOf(cv::Mat3b(4, 2, cv::Vec3b())));
}

TEST(Hasher, TakesAViewForItsCopy) {
  cv::Mat1b image(10, 10);
  for (int i = 0; i < 100; ++i) image(i / 10, i % 10) = static_cast<uchar>(i);
  const cv::Mat view = image(cv::Rect(2, 3, 5, 4));
  EXPECT_EQ(HexOf(view), HexOf(view.clone()));
}

}  // namespace
}  // namespace horopter::scenarios
