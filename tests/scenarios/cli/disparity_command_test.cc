// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <string>

#include "scenarios/dataset/flo.h"
#include "scenarios/dataset/pfm.h"
#include "scenarios/dataset/png16.h"
#include "tests/scenarios/cli/horopter_program.h"
#include "tests/scenarios/format/corpus.h"
#include "tests/vision/disparity/textured_pair.h"
#include "vision/disparity/disparity_factory.h"

namespace horopter::scenarios {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

const cv::Size kSize(160, 120);
constexpr double kDx = -6;

class DisparityCommand : public testing::Test {
 protected:
  DisparityCommand() {
    const auto pair = vision::testing::ShiftedPair(kSize, kDx, 0);
    cv::imwrite(At("left.png"), pair.left);
    cv::imwrite(At("right.png"), pair.right);
  }

  std::string At(const std::string& name) const { return (folder_.path() / name).string(); }
  std::string Quoted(const std::string& name) const {
    return std::string("'").append(At(name)).append("'");
  }
  std::string Pair() const { return Quoted("left.png") + " " + Quoted("right.png") + " "; }

  std::string Estimate(const std::string& arguments, const std::string& streams = "2>&1") const {
    const Ran ran = Horopter("disparity " + arguments, streams);
    EXPECT_EQ(ran.code, 0) << ran.output;
    return ran.output;
  }

  void ExpectRefused(const std::string& arguments, const std::string& remedy) const {
    const Ran ran = Horopter("disparity " + arguments);
    EXPECT_EQ(ran.code, 2) << arguments << "\n" << ran.output;
    EXPECT_THAT(ran.output, HasSubstr(remedy)) << arguments;
    EXPECT_EQ(std::count(ran.output.begin(), ran.output.end(), '\n'), 1) << ran.output;
  }

  TemporaryFolder folder_;
};

TEST_F(DisparityCommand, HelpListsEveryMethodAndPreset) {
  const std::string help = Horopter("disparity --help").output;
  for (const vision::DisparityMethod& method : vision::DisparityMethods()) {
    EXPECT_THAT(help, HasSubstr("  " + std::string(method.name)));
    for (const auto preset : method.presets) EXPECT_THAT(help, HasSubstr(std::string(preset)));
  }
}

TEST_F(DisparityCommand, EveryFormatHoldsTheDisparityInItsOwnSign) {
  Estimate(Pair() + "--method dis --out " + Quoted("d.flo"));
  const DisplacementMaps flow = ReadFlo(At("d.flo"));
  ASSERT_EQ(flow.dx.size(), kSize);
  EXPECT_NEAR(flow.dx(60, 80), kDx, 0.3);
  EXPECT_NEAR(flow.dy(60, 80), 0, 0.3);
  EXPECT_TRUE(std::isnan(flow.dx(60, 1))) << "its match lies outside";
  Estimate(Pair() + "--method dis --out " + Quoted("d.pfm"));
  EXPECT_EQ(ReadPfm(At("d.pfm")).at<float>(60, 80), -flow.dx(60, 80));
  EXPECT_TRUE(std::isinf(ReadPfm(At("d.pfm")).at<float>(60, 1)));
  Estimate(Pair() + "--method dis --out " + Quoted("d.png"));
  const cv::Mat1f kitti = UnpackKittiDisparity(ReadPng16(At("d.png"), 1));
  EXPECT_NEAR(kitti(60, 80), -flow.dx(60, 80), 1 / 256.0);
  EXPECT_TRUE(std::isnan(kitti(60, 1)));
}

TEST_F(DisparityCommand, JsonSaysWhatRanAndHowLong) {
  const auto report = nlohmann::json::parse(
      Estimate(Pair() + "--method sgbm --range 0:16 --repeat 3 --json", "2>&-"));
  EXPECT_EQ(report.at("method"), "sgbm");
  EXPECT_EQ(report.at("preset"), "3way") << "the default has a name";
  EXPECT_EQ(report.at("width"), kSize.width);
  EXPECT_EQ(report.at("height"), kSize.height);
  EXPECT_EQ(report.at("repeat"), 3);
  EXPECT_GE(report.at("threads"), 1);
  EXPECT_THAT(report.at("instruction_set").get<std::string>(),
              ::testing::AnyOf("portable", "avx2", "avx512"));
  EXPECT_GT(report.at("density"), 0.7);
  EXPECT_LE(report.at("density"), 1);
  EXPECT_GT(report.at("total_ms"), 0);
  EXPECT_GT(report.at("stages_ms").at("matching"), 0);
  EXPECT_GT(report.at("peak_memory_before_mb"), 1);
  EXPECT_GE(report.at("peak_memory_mb"), report.at("peak_memory_before_mb"));
}

TEST_F(DisparityCommand, WhatWasFilledInIsSaid) {
  const auto report = nlohmann::json::parse(Estimate(Pair() + "--preset dense --json"));
  EXPECT_EQ(report.at("density"), 1);
  EXPECT_GT(report.at("filled"), 0);
  EXPECT_LT(report.at("filled"), 0.3);
  EXPECT_THAT(Estimate(Pair() + "--preset dense"), HasSubstr("filled in)"));
}

TEST_F(DisparityCommand, AnyMethodsFieldCanBeFilledIn) {
  for (const char* method : {"--method dis", "--preset dense"}) {
    const auto report = nlohmann::json::parse(Estimate(Pair() + method + " --fill-in --json"));
    EXPECT_EQ(report.at("density"), 1) << method;
    EXPECT_GT(report.at("filled"), 0) << method;
  }
}

TEST_F(DisparityCommand, TextSaysTheSame) {
  const std::string text = Estimate(Pair() + "--method bm --range 0:16");
  EXPECT_THAT(text, HasSubstr("bm block_15: 160 x 120 px, density 0."));
  EXPECT_THAT(text, testing::ContainsRegex("total +[0-9.]+ ms"));
  EXPECT_THAT(text, testing::ContainsRegex("peak memory +[0-9.]+ MB"));
}

TEST_F(DisparityCommand, ConfidenceAndPictureAreWritten) {
  Estimate(Pair() + "--method dis --confidence " + Quoted("c.png") + " --viz " + Quoted("v.png"));
  const cv::Mat confidence = cv::imread(At("c.png"), cv::IMREAD_UNCHANGED);
  ASSERT_EQ(confidence.type(), CV_8UC1);
  EXPECT_EQ(confidence.at<uchar>(60, 80), 255);
  EXPECT_EQ(confidence.at<uchar>(60, 1), 0);
  EXPECT_GT(cv::imread(At("v.png")).cols, kSize.width);
  Estimate(Pair() + "--method dis --confidence " + Quoted("c.pfm"));
  EXPECT_EQ(ReadPfm(At("c.pfm")).at<float>(60, 80), 1);
}

TEST_F(DisparityCommand, SixteenBitsAndColourBesideGreyAreTaken) {
  const cv::Mat left = cv::imread(At("left.png"), cv::IMREAD_GRAYSCALE);
  cv::Mat deep, colour;
  left.convertTo(deep, CV_16U, 257);
  cv::merge(std::vector<cv::Mat>(3, left), colour);
  cv::imwrite(At("deep.png"), deep);
  cv::imwrite(At("colour.png"), colour);
  Estimate(Pair() + "--method dis --out " + Quoted("d.flo"));
  const cv::Mat1f expected = ReadFlo(At("d.flo")).dx;
  for (const char* name : {"deep.png", "colour.png"}) {
    const std::string said = Estimate(
        Quoted(name) + " " + Quoted("right.png") + " --method dis --out " + Quoted("e.flo"),
        "2>&1 >&-");
    EXPECT_THAT(said, HasSubstr("horopter disparity: ")) << "it is said";
    EXPECT_NEAR(ReadFlo(At("e.flo")).dx(60, 80), expected(60, 80), 1e-6) << name;
  }
}

TEST_F(DisparityCommand, DisparitiesThatAFormatCannotHoldAreCounted) {
  const std::string swapped = Quoted("right.png") + " " + Quoted("left.png");
  EXPECT_THAT(Estimate(swapped + " --method dis --out " + Quoted("d.png")),
              HasSubstr("disparities are not positive"));
}

TEST_F(DisparityCommand, OnePixelIsNoError) {
  cv::imwrite(At("one.png"), cv::Mat1b(1, 1, uchar{7}));
  for (const vision::DisparityMethod& method : vision::DisparityMethods()) {
    EXPECT_THAT(Estimate(Quoted("one.png") + " " + Quoted("one.png") + " --method " +
                         std::string(method.name) + " --viz " + Quoted("v.png")),
                HasSubstr("density 0.000"));
  }
}

TEST_F(DisparityCommand, BadInputNamesThePlaceAndTheRemedy) {
  ExpectRefused(Pair() + "--method elas", "known are v1 (");
  ExpectRefused(Pair() + "--method dis --preset slow", "known are medium, fast, ultrafast");
  ExpectRefused(Pair() + "--method dis --range 0:64", "takes no search range");
  ExpectRefused(Pair() + "--method bm --range 64:0", "--range 64:0: must be MIN:MAX");
  ExpectRefused(Pair() + "--method bm --range 0:64x", "MIN:MAX");
  ExpectRefused(Pair() + "--method bm --range 0:9000", "bm.range.count_px");
  ExpectRefused(Pair() + "--out d.exr", "--out d.exr: unknown format '.exr': known are .flo");
  ExpectRefused(Pair() + "--viz no/such/v.png", "there is no folder no/such: make it first");
  ExpectRefused(Pair() + "--confidence c.flo", "known are .pfm, .png");
  ExpectRefused(Pair() + "--repeat 0", "--repeat");
  ExpectRefused(Quoted("none.png") + " " + Quoted("right.png"), "none.png: No such file");
  cv::imwrite(At("small.png"), cv::Mat1b(60, 80, uchar{0}));
  ExpectRefused(Quoted("left.png") + " " + Quoted("small.png"), "small.png is 80x60");
  folder_.Write("text.png", "no picture");
  ExpectRefused(Quoted("text.png") + " " + Quoted("right.png"), "text.png: no image");
  folder_.Write("short.ppm", "P6 30 30 255\nabc");
  ExpectRefused(Quoted("short.ppm") + " " + Quoted("right.png"), "short.ppm: damaged PNM");
  folder_.Write("empty.png", "");
  ExpectRefused(Quoted("empty.png") + " " + Quoted("right.png"), "empty.png: empty file");
}

TEST(Aloe, SemiGlobalMatchingFindsMostOfIt) {
  const std::string folder = "/usr/share/doc/opencv-doc/examples/data/";
  if (!fs::exists(folder + "aloeL.jpg")) {
    GTEST_SKIP() << "Aloe is not there: install Debian's opencv-doc";
  }
  TemporaryFolder out;
  const std::string flo = (out.path() / "aloe.pfm").string();
  const Ran ran = Horopter("disparity " + folder + "aloeL.jpg " + folder +
                           "aloeR.jpg --method sgbm --range 0:224 --out " + flo);
  ASSERT_EQ(ran.code, 0) << ran.output;
  const Ran scored = Horopter("score " + flo + " " + folder + "aloeGT.png --json");
  ASSERT_EQ(scored.code, 0) << scored.output;
  const auto dx = nlohmann::json::parse(scored.output).at("dx");
  EXPECT_GT(dx.at("density"), 0.7);
  EXPECT_LT(dx.at("bad_estimated").at("2"), 0.05);
}

}  // namespace
}  // namespace horopter::scenarios
