// SPDX-License-Identifier: Apache-2.0
// The program that measures accuracy measures what it says.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/video/tracking.hpp>
#include <stdexcept>
#include <string>

#include "accuracy_ablation.h"
#include "accuracy_pictures.h"
#include "accuracy_plot.h"
#include "accuracy_runs.h"
#include "accuracy_scenes.h"
#include "textured_pair.h"
#include "vision/disparity/epipolar_prior.h"

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

/// A data set's frame as `horopter render --truth` lays it out.
class RenderedFrame : public ::testing::Test {
 protected:
  void SetUp() override { std::filesystem::create_directories(folder_ / "000000"); }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  std::string In(const char* name) const { return (folder_ / "000000" / name).string(); }

  std::filesystem::path folder_ = std::filesystem::path(::testing::TempDir()) /
                                  ::testing::UnitTest::GetInstance()->current_test_info()->name() /
                                  "near";
};

TEST_F(RenderedFrame, IsASceneOfItsName) {
  const PairWithTruth pair = Pair();
  cv::Mat2f flow(kSize, cv::Vec2f(kDx, 1));
  flow(3, 4) = {1e10F, 1e10F};
  cv::imwrite(In("left.png"), pair.left);
  cv::imwrite(In("right.png"), pair.right);
  cv::writeOpticalFlow(In("left_disparity.flo"), flow);
  const AccuracyScene scene = RenderedScene(folder_.string());
  EXPECT_EQ(scene.name, "near");
  EXPECT_EQ(scene.pair.left.size(), kSize);
  EXPECT_EQ(scene.pair.dx(3, 3), kDx);
  EXPECT_EQ(scene.pair.dy(3, 3), 1);
  EXPECT_TRUE(std::isnan(scene.pair.dx(3, 4)));
}

TEST_F(RenderedFrame, NamesWhatIsMissing) {
  try {
    RenderedScene(folder_.string());
    FAIL() << "accepted";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), ::testing::HasSubstr("left_disparity.flo"));
  }
}

TEST(AccuracyScenes, TheMotorcyclePoseExplainsItsTruth) {
  const auto data = DataFolder();
  if (!data) GTEST_SKIP() << kDataRemedy;
  const StereoCameras cameras = MotorcycleCameras();
  for (const EyeTurn& turn : kTurns) {
    const PairWithTruth pair = VergedMotorcycle(*data, turn);
    RelativePose pose{MotorcyclePose(turn)};
    const EpipolarPrior prior(cameras.left, cameras.right, pose, {.min_depth_m = 1});
    int allowed = 0, known = 0;
    for (int y = 0; y < pair.dx.rows; y += 7) {
      for (int x = 0; x < pair.dx.cols; x += 7) {
        if (std::isnan(pair.dx(y, x))) continue;
        ++known;
        allowed += prior.Allows(x, y, pair.dx(y, x), pair.dy(y, x)) ? 1 : 0;
      }
    }
    EXPECT_GT(allowed, 0.999 * known);
  }
}

TEST(Ablations, EveryChangeIsAConfigThatRunsAndChangesSomething) {
  const SyntheticPair textured = ShiftedPair({160, 120}, -6, 1);
  const PairWithTruth pair{textured.left, textured.right, cv::Mat1f(120, 160, -6.0F),
                           cv::Mat1f(120, 160, 1.0F)};
  const std::vector<Ablation> all = Ablations();
  EXPECT_GT(all.size(), 15U);
  for (const Ablation& ablation : all) {
    EXPECT_TRUE(ablation.config.Validate().empty()) << ablation.change;
    if (ablation.with_prior) continue;  // of Motorcycle's cameras
    const AblationResult result = RunAblation(ablation, pair, {});
    EXPECT_GE(result.density, 0) << ablation.change;
    EXPECT_GT(result.ms, 0) << ablation.change;
  }
  EXPECT_GT(RunAblation(all[0], pair, {}).density, 0.8);
}

TEST(ComparePictures, HasARowForTheTruthAndForEachField) {
  const PairWithTruth pair = Pair();
  DisparityField field{pair.dx.clone(), pair.dy.clone(), {}, {}};
  field.dx(60, 40) = field.dy(60, 40) = NAN;
  field.dx.colRange(150, 200) = kDx + 5;
  const cv::Mat3b picture = ComparePictures(pair, {{"a", field}, {"b", field}}, 400);
  EXPECT_EQ(picture.size(), cv::Size(400, 3 * 120));
  EXPECT_EQ(picture(120 + 60, 40), cv::Vec3b(0, 0, 0)) << "invalid is black";
  EXPECT_EQ(picture(120 + 60, 200 + 100), cv::Vec3b(0, 0, 0)) << "no error is black";
  EXPECT_EQ(picture(120 + 60, 200 + 180), cv::Vec3b(255, 255, 255)) << "a large one white";
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
  MethodResult good{"v1:fast", {}, 100, {}}, poor{"dis:fast", {}, 10, {}};
  const MethodResult none{"bm:block_9", {}, 5, {}};
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
