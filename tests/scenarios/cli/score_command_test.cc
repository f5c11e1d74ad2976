// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <string>

#include "scenarios/dataset/flo.h"
#include "scenarios/dataset/pfm.h"
#include "scenarios/dataset/png16.h"
#include "tests/scenarios/cli/horopter_program.h"
#include "tests/scenarios/format/corpus.h"

namespace horopter::scenarios {
namespace {

using testing::HasSubstr;

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

class ScoreCommand : public testing::Test {
 protected:
  ScoreCommand() {
    const cv::Mat1f zero = cv::Mat1f::zeros(1, 4);
    WriteFlo(At("truth.flo"), {(cv::Mat1f(1, 4) << -10, -10, -10, -20), zero});
    // Off by 0, 3 in dx, 4 in dy as well; one missing.
    WriteFlo(At("estimate.flo"),
             {(cv::Mat1f(1, 4) << -10, -13, -7, kNaN), (cv::Mat1f(1, 4) << 0, 0, 4, kNaN)});
    WritePfm(At("truth.pfm"), (cv::Mat1f(1, 4) << 10, 10, 10, 20));
  }

  std::string At(const std::string& name) const { return (folder_.path() / name).string(); }
  std::string Files(const std::string& estimate, const std::string& truth) const {
    return "score '" + At(estimate) + "' '" + At(truth) + "' ";
  }
  nlohmann::json Json(const std::string& arguments) const {
    const Ran ran = Horopter(arguments + " --json");
    EXPECT_EQ(ran.code, 0) << ran.output;
    return nlohmann::json::parse(ran.output);
  }
  void ExpectRefused(const std::string& arguments, const std::string& remedy) const {
    const Ran ran = Horopter(arguments);
    EXPECT_EQ(ran.code, 2) << arguments << "\n" << ran.output;
    EXPECT_THAT(ran.output, HasSubstr(remedy)) << arguments;
    EXPECT_EQ(std::count(ran.output.begin(), ran.output.end(), '\n'), 1) << ran.output;
  }

  TemporaryFolder folder_;
};

TEST_F(ScoreCommand, ComponentsAndVectorApart) {
  const auto scores = Json(Files("estimate.flo", "truth.flo"));
  EXPECT_EQ(scores.at("dx").at("known"), 4);
  EXPECT_EQ(scores.at("dx").at("density"), 0.75);
  EXPECT_EQ(scores.at("dx").at("mean_px"), 2);
  EXPECT_EQ(scores.at("dy").at("max_px"), 4);
  EXPECT_EQ(scores.at("vector").at("max_px"), 5);
  EXPECT_EQ(scores.at("vector").at("max_at"), nlohmann::json({2, 0}));
  EXPECT_EQ(scores.at("vector").at("bad_known").at("4"), 0.5) << "one wrong, one missing";
}

TEST_F(ScoreCommand, MapsHaveNoVerticalPartToScore) {
  const auto scores = Json(Files("estimate.flo", "truth.pfm"));
  EXPECT_EQ(scores.at("dx").at("median_px"), 3);
  EXPECT_FALSE(scores.contains("dy") || scores.contains("vector"));
}

TEST_F(ScoreCommand, TableHasTheLargestErrorWhenAsked) {
  const Ran plain = Horopter(Files("estimate.flo", "truth.flo"));
  EXPECT_THAT(plain.output, HasSubstr("| dx | 4 | 0.750 | 2.000 | 3.000 |"));
  EXPECT_THAT(plain.output, testing::Not(HasSubstr("max px")));
  const Ran with_max = Horopter(Files("estimate.flo", "truth.flo") + "--max-px");
  EXPECT_THAT(with_max.output, HasSubstr("| 5.000 | (2, 0) |"));
}

TEST_F(ScoreCommand, KittiAndMiddleburyPictures) {
  const cv::Mat1f disparity = (cv::Mat1f(1, 4) << 10, 13, 7, kNaN);
  WritePng(At("kitti.png"), PackKittiDisparity(disparity).pixels);
  cv::imwrite(At("quarter.pgm"), cv::Mat1b((cv::Mat1b(1, 4) << 40, 40, 40, 80)));
  cv::imwrite(At("quarter.png"), cv::Mat1b((cv::Mat1b(1, 4) << 40, 40, 40, 0)));
  EXPECT_EQ(Json(Files("kitti.png", "truth.pfm")).at("dx").at("max_px"), 3);
  EXPECT_EQ(Json(Files("kitti.png", "quarter.pgm") + "--scale 4").at("dx").at("max_px"), 3);
  EXPECT_EQ(Json(Files("kitti.png", "quarter.png") + "--scale 4").at("dx").at("known"), 3)
      << "0 is unknown";
  WritePng(At("flow.png"), PackKittiFlow({-disparity, cv::Mat1f::zeros(1, 4)}).pixels);
  EXPECT_EQ(Json(Files("flow.png", "truth.flo")).at("dy").at("max_px"), 0);
}

TEST_F(ScoreCommand, MaskSaysWhatCounts) {
  cv::imwrite(At("mask.png"), cv::Mat1b((cv::Mat1b(1, 4) << 255, 1, 0, 0)));
  const auto dx = Json(Files("estimate.flo", "truth.flo") + "--mask '" + At("mask.png") + "'");
  EXPECT_EQ(dx.at("dx").at("known"), 2);
}

TEST_F(ScoreCommand, WhatWasNotMeasuredIsNull) {
  WritePfm(At("none.pfm"), cv::Mat1f(1, 4, kNaN));
  const auto dx = Json(Files("none.pfm", "truth.pfm")).at("dx");
  EXPECT_TRUE(dx.at("median_px").is_null());
  EXPECT_EQ(dx.at("bad_known").at("2"), 1);
}

TEST_F(ScoreCommand, BadInputNamesThePlaceAndTheRemedy) {
  WritePfm(At("none.pfm"), cv::Mat1f(1, 4, kNaN));
  WritePfm(At("wide.pfm"), cv::Mat1f::ones(1, 5));
  cv::imwrite(At("colour.png"), cv::Mat3b(1, 4, cv::Vec3b(1, 2, 3)));
  folder_.Write("damaged.flo", "PIEH");
  ExpectRefused(Files("truth.pfm", "none.pfm"), "unknown everywhere");
  ExpectRefused(Files("wide.pfm", "truth.pfm"), "estimate is 5x1, truth is 4x1");
  ExpectRefused(Files("truth.txt", "truth.pfm"), "unknown disparity format '.txt': known are .flo");
  ExpectRefused(Files("damaged.flo", "truth.pfm"), "damaged.flo: truncated");
  ExpectRefused(Files("missing.flo", "truth.pfm"), "missing.flo: No such file");
  ExpectRefused(Files("truth.pfm", "truth.pfm") + "--scale 0", "must be positive");
  ExpectRefused(Files("truth.pfm", "truth.pfm") + "--mask '" + At("colour.png") + "'",
                "3 channels: a mask has one");
}

}  // namespace
}  // namespace horopter::scenarios
