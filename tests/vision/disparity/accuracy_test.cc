// SPDX-License-Identifier: Apache-2.0
// The program that measures accuracy measures what it says.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>
#include <stdexcept>
#include <string>

#include "accuracy_plot.h"
#include "accuracy_runs.h"
#include "accuracy_scenes.h"
#include "textured_pair.h"

namespace horopter::vision::testing {
namespace {

const cv::Size kSize(200, 120);
constexpr float kDx = -6;

PairWithTruth Pair() {
  const SyntheticPair pair = ShiftedPair(kSize, kDx, 0);
  return {pair.left, pair.right, cv::Mat1f(kSize, kDx), cv::Mat1f::zeros(kSize)};
}

double Distance(const cv::Mat& a, const cv::Mat& b) { return cv::norm(a, b, cv::NORM_INF); }

TEST(AccuracyScenes, DegradingAPairLeavesItAsItWas) {
  const PairWithTruth pair = Pair(), same = Pair();
  WithNoise(pair, 20);
  WithGain(pair, 0.5);
  WithGain(pair, 2);
  WithVerticalOffset(pair, 5);
  Shifted(pair, 50, -10);
  EXPECT_EQ(Distance(pair.left, same.left) + Distance(pair.right, same.right), 0);
  EXPECT_EQ(Distance(pair.dx, same.dx) + Distance(pair.dy, same.dy), 0);
}

TEST(AccuracyScenes, NoiseIsDrawnForEachEyeApart) {
  const PairWithTruth grey{cv::Mat1b(kSize, uchar{128}), cv::Mat1b(kSize, uchar{128}), {}, {}};
  const PairWithTruth noisy = WithNoise(grey, 5);
  cv::Scalar mean, deviation;
  cv::meanStdDev(noisy.left, mean, deviation);
  EXPECT_NEAR(deviation[0], 5, 0.2);
  cv::Mat1s difference;
  cv::subtract(noisy.left, noisy.right, difference, cv::noArray(), CV_16S);
  cv::meanStdDev(difference, mean, deviation);
  EXPECT_NEAR(deviation[0], 5 * std::sqrt(2.0), 0.3);
  EXPECT_EQ(Distance(WithNoise(grey, 0).left, grey.left), 0);
}

TEST(AccuracyScenes, GainDarkensTheOtherEye) {
  const PairWithTruth pair = Pair();
  const auto ratio = [](const PairWithTruth& p) {
    return cv::mean(p.right)[0] / cv::mean(p.left)[0];
  };
  EXPECT_NEAR(ratio(WithGain(pair, 0.5)) / ratio(pair), 0.5, 0.01);
  EXPECT_NEAR(ratio(WithGain(pair, 2)) / ratio(pair), 2, 0.02);
  EXPECT_EQ(Distance(WithGain(pair, 1).right, pair.right), 0);
}

TEST(AccuracyScenes, MovedImagesTakeTheirTruthAlong) {
  const PairWithTruth pair = Pair();
  const PairWithTruth moved = WithVerticalOffset(pair, 5);
  EXPECT_EQ(moved.right.at<uchar>(55, 60), pair.right.at<uchar>(50, 60));
  EXPECT_EQ(moved.dy(50, 60), 5);
  EXPECT_TRUE(std::isnan(moved.dy(kSize.height - 5, 60))) << "its match left the image";
  const PairWithTruth shifted = Shifted(pair, 150, -20);
  const cv::Point at = cv::Point(60, 50) + cv::Point(200, 30);
  EXPECT_EQ(shifted.left.at<uchar>(at), pair.left.at<uchar>(50, 60));
  EXPECT_EQ(shifted.dx(at), kDx + 150);
  EXPECT_EQ(shifted.dy(at), -20);
  const cv::Point match(cvRound(at.x + shifted.dx(at)), cvRound(at.y + shifted.dy(at)));
  EXPECT_LE(std::abs(shifted.left.at<uchar>(at) - shifted.right.at<uchar>(match)), 1);
  EXPECT_EQ(cv::countNonZero(shifted.dx == shifted.dx), kSize.area()) << "no truth is lost";
}

TEST(AccuracyRuns, MethodsGoByName) {
  EXPECT_EQ(MethodChoice::Parse("dis:fast").name(), "dis:fast");
  EXPECT_EQ(MethodChoice::Parse("dis").name(), "dis:medium") << "the first preset";
  EXPECT_THROW(MethodChoice::Parse("dis:slow"), std::invalid_argument);
  EXPECT_THROW(MethodChoice::Parse("elas"), std::invalid_argument);
}

TEST(AccuracyRuns, ScoresEveryMethodThatThePairIsFor) {
  const std::vector<MethodChoice> methods = {MethodChoice::Parse("dis"), MethodChoice::Parse("bm")};
  const auto both = RunMethods(methods, Pair(), SearchRange::Covering(0, 16), 2);
  ASSERT_EQ(both.size(), 2U);
  for (const MethodResult& result : both) {
    EXPECT_GT(result.score.density, 0.5) << result.name;
    EXPECT_LT(result.score.median_px, 0.2) << result.name;
    EXPECT_GT(result.median_ms, 0) << result.name;
  }
  const auto verged = RunMethods(methods, Pair(), std::nullopt, 1);
  ASSERT_EQ(verged.size(), 1U);
  EXPECT_EQ(verged[0].name, "dis:medium");
}

TEST(AccuracyPlot, ShowsEveryMethodThatEstimatedAnything) {
  MethodResult good{"v1:fast", {}, 100}, poor{"dis:fast", {}, 10}, none{"bm:block_9", {}, 5};
  good.score.estimated = poor.score.estimated = 100;
  good.score.density = poor.score.density = 1;
  good.score.bad_estimated = {0.4, 0.3, 0.02, 0.01};
  poor.score.bad_estimated = {0.9, 0.8, 0.2, 0.1};
  const std::string svg = AccuracyPlot("two", {good, poor, none});
  EXPECT_THAT(svg, ::testing::HasSubstr(">v1:fast</text>"));
  EXPECT_THAT(svg, ::testing::HasSubstr(">dis:fast</text>"));
  EXPECT_THAT(svg, ::testing::Not(::testing::HasSubstr("bm:block_9")));
  EXPECT_THAT(AccuracyPlot("none", {none}), ::testing::HasSubstr("</svg>"));
}

}  // namespace
}  // namespace horopter::vision::testing
