// SPDX-License-Identifier: Apache-2.0
#include "scenarios/dataset/image_file.h"

#include <opencv2/imgcodecs.hpp>
#include <string>
#include <vector>

#include "scenarios/dataset/image_header.h"
#include "scenarios/results/results_error.h"
#include "tests/scenarios/dataset/bytes.h"

namespace horopter::scenarios {
namespace {

using testing::HasSubstr;

std::string Encoded(const std::string& extension, const cv::Mat& pixels) {
  std::vector<uchar> bytes;
  EXPECT_TRUE(cv::imencode(extension, pixels, bytes));
  return {bytes.begin(), bytes.end()};
}

cv::Mat3b Picture() {
  cv::Mat3b pixels(11, 17);
  cv::RNG random(3);
  random.fill(pixels, cv::RNG::UNIFORM, 0, 256);
  return pixels;
}

TEST(ImageHeader, ClaimsTheSizeInEveryFormat) {
  for (const char* extension : {".png", ".jpg", ".ppm", ".bmp", ".tiff"}) {
    const auto header = ReadImageHeader(Encoded(extension, Picture()));
    ASSERT_TRUE(header && header->size) << extension;
    EXPECT_EQ(*header->size, cv::Size(17, 11)) << extension;
  }
  const auto commented = ReadImageHeader("P5 # by hand 9 9\n 640\t480 255\n");
  EXPECT_EQ(*commented->size, cv::Size(640, 480));
  EXPECT_FALSE(ReadImageHeader("GIF89a"));
  EXPECT_FALSE(ReadImageHeader(""));
}

TEST(ImageFile, KeepsBitsAndChannels) {
  EXPECT_EQ(DecodeImage(Encoded(".png", Picture()), "a").type(), CV_8UC3);
  EXPECT_EQ(DecodeImage(Encoded(".png", cv::Mat1w(3, 4, std::uint16_t{500})), "a").type(),
            CV_16UC1);
  EXPECT_EQ(DecodeImage(Encoded(".png", cv::Mat4b(3, 4, cv::Vec4b(1, 2, 3, 4))), "a").type(),
            CV_8UC4);
  EXPECT_EQ(DecodeImage(Encoded(".tiff", cv::Mat1f(3, 4, 0.5F)), "a").type(), CV_32FC1);
}

TEST(ImageFile, NamesWhatIsWrong) {
  const auto complaint = [](const std::string& bytes) {
    return FormatComplaint([&] { DecodeImage(bytes, "left.png"); });
  };
  EXPECT_EQ(complaint(""), "left.png: empty file");
  EXPECT_THAT(complaint("no picture at all"), HasSubstr("left.png: no image of a known format"));
  const std::string png = Encoded(".png", Picture());
  EXPECT_THAT(complaint(png.substr(0, png.size() / 2)), HasSubstr("left.png: damaged PNG"));
  EXPECT_THROW(ReadImage("/no/such/left.png"), UnusableResults);
  EXPECT_THROW(ReadImage("/tmp"), UnusableResults);
}

TEST(ImageFile, RefusesSizesThatNoSuchFileHoldsBeforeMakingRoom) {
  const auto complaint = [](const std::string& bytes) {
    return FormatComplaint([&] { DecodeImage(bytes, "a"); });
  };
  EXPECT_THAT(complaint("P5 90000 90000 255\nabc"), HasSubstr("90000 x 90000 pixels in 22 bytes"));
  std::string bmp = Encoded(".bmp", Picture());
  bmp[20] = 0x7f;  // width
  EXPECT_THAT(complaint(bmp), HasSubstr("damaged BMP, or too large"));
}

TEST(ImageFile, ExtensionsAreTakenInLowerCase) {
  EXPECT_EQ(ExtensionOf("a/b.PNG"), ".png");
  EXPECT_EQ(ExtensionOf("a.b/c"), "");
}

}  // namespace
}  // namespace horopter::scenarios
