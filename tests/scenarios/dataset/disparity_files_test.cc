// SPDX-License-Identifier: Apache-2.0
#include "scenarios/dataset/disparity_files.h"

#include <cmath>
#include <limits>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <stdexcept>
#include <string>

#include "scenarios/dataset/pfm.h"
#include "scenarios/dataset/png16.h"
#include "scenarios/results/results_error.h"
#include "tests/scenarios/dataset/bytes.h"
#include "tests/scenarios/format/corpus.h"

namespace horopter::scenarios {
namespace {

using testing::HasSubstr;

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

class DisparityFiles : public testing::Test {
 protected:
  std::string At(const std::string& name) const { return (folder_.path() / name).string(); }

  TemporaryFolder folder_;
  /// Far, unknown, and beyond fixation.
  const vision::DisparityField field_{(cv::Mat1f(1, 3) << -2.5F, kNaN, 4),
                                      (cv::Mat1f(1, 3) << 1, kNaN, -1), cv::Mat1f::ones(1, 3),
                                      (cv::Mat1b(1, 3) << 255, 0, 255)};
};

TEST_F(DisparityFiles, FloKeepsBothComponents) {
  EXPECT_EQ(WriteDisparity(At("d.flo"), field_), 0);
  const vision::DisparityMaps read = ReadDisparity(At("d.flo"));
  EXPECT_EQ(read.dx(0, 0), -2.5F);
  EXPECT_EQ(read.dy(0, 2), -1);
  EXPECT_TRUE(std::isnan(read.dx(0, 1)));
}

TEST_F(DisparityFiles, PfmHoldsTheOppositeSignAndInfinity) {
  EXPECT_EQ(WriteDisparity(At("d.pfm"), field_), 0);
  const cv::Mat1f stored = ReadPfm(At("d.pfm"));
  EXPECT_EQ(stored(0, 0), 2.5F);
  EXPECT_EQ(stored(0, 1), std::numeric_limits<float>::infinity());
  const vision::DisparityMaps read = ReadDisparity(At("d.pfm"));
  EXPECT_EQ(read.dx(0, 2), 4);
  EXPECT_FALSE(std::isfinite(read.dx(0, 1)));
  EXPECT_TRUE(read.dy.empty());
}

TEST_F(DisparityFiles, KittiPngSaysWhatItCouldNotHold) {
  EXPECT_EQ(WriteDisparity(At("d.png"), field_), 1) << "beyond fixation";
  const vision::DisparityMaps read = ReadDisparity(At("d.png"));
  EXPECT_EQ(read.dx(0, 0), -2.5F);
  EXPECT_TRUE(std::isnan(read.dx(0, 1)) && std::isnan(read.dx(0, 2)));
}

TEST_F(DisparityFiles, KittiFlowHasBothComponents) {
  WritePng(At("f.png"), PackKittiFlow({field_.dx, field_.dy}).pixels);
  const vision::DisparityMaps read = ReadDisparity(At("f.png"));
  EXPECT_EQ(read.dx(0, 2), 4);
  EXPECT_EQ(read.dy(0, 2), -1);
  EXPECT_TRUE(std::isnan(read.dy(0, 1)));
}

TEST_F(DisparityFiles, PicturesAreScaledAndZeroIsUnknown) {
  const cv::Mat1b grey = (cv::Mat1b(1, 3) << 10, 0, 255);
  for (const char* name : {"g.png", "g.pgm", "G.PNG"}) {
    cv::imwrite(At(name), grey);
    const vision::DisparityMaps read = ReadDisparity(At(name), 4);
    EXPECT_EQ(read.dx(0, 0), -2.5F) << name;
    EXPECT_TRUE(std::isnan(read.dx(0, 1)));
    EXPECT_EQ(ReadDisparity(At(name)).dx(0, 2), -255);
  }
  cv::Mat3b as_colour;
  cv::merge(std::vector<cv::Mat>(3, grey), as_colour);
  cv::imwrite(At("c.png"), as_colour);
  EXPECT_EQ(ReadDisparity(At("c.png")).dx(0, 0), -10);
  cv::imwrite(At("w.png"), cv::Mat1w(1, 1, std::uint16_t{512}));
  EXPECT_EQ(ReadDisparity(At("w.png"), 4).dx(0, 0), -2) << "KITTI's steps, always";
}

TEST_F(DisparityFiles, NamesWhatIsWrong) {
  const auto complaint = [this](const std::string& name) {
    return FormatComplaint([&] { ReadDisparity(At(name)); });
  };
  cv::imwrite(At("c.png"), cv::Mat3b(2, 2, cv::Vec3b(1, 2, 3)));
  EXPECT_THAT(complaint("c.png"), HasSubstr("a colour picture holds no disparity"));
  WritePfm(At("n.pfm"), cv::Mat3f::ones(2, 2));
  EXPECT_THAT(complaint("n.pfm"), HasSubstr("three channels: a disparity has one"));
  EXPECT_THROW(ReadDisparity(At("none.flo")), UnusableResults);
  EXPECT_THROW(ReadDisparity(At("c.png"), 0), std::invalid_argument);
  const auto usage = [](const auto& call) -> std::string {
    try {
      call();
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_THAT(usage([] { ReadDisparity("d.exr"); }),
              HasSubstr("unknown disparity format '.exr': known are .flo, .pfm, .png"));
  EXPECT_THAT(usage([&] { WriteDisparity(At("d.tif"), field_); }), HasSubstr("'.tif'"));
}

}  // namespace
}  // namespace horopter::scenarios
