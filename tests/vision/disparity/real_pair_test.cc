// SPDX-License-Identifier: Apache-2.0
// Quality on a real verged pair with published ground truth, occluded pixels included.
#include "real_pair.h"

#include <gtest/gtest.h>

#include <opencv2/core.hpp>

#include "vision/disparity/disparity_factory.h"

namespace horopter::vision {
namespace {

using testing::FieldScore;
using testing::PairWithTruth;

class VergedMotorcycle : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto folder = testing::DataFolder();
    if (!folder) GTEST_SKIP() << testing::kDataRemedy;
    pair_ = testing::VergedMotorcycle(*folder, {2, 0.3, 0.5});
  }

  FieldScore ScoreOf(const V1Config& config) {
    const auto field = CreateDisparityEstimator(config)->Estimate(pair_.left, pair_.right);
    const FieldScore score = testing::Score(field, pair_.dx, pair_.dy);
    RecordProperty("density", std::to_string(score.density));
    RecordProperty("median_error_px", std::to_string(score.median_error_px));
    RecordProperty("bad2", std::to_string(score.bad2));
    return score;
  }

  PairWithTruth pair_;
};

TEST_F(VergedMotorcycle, TruthSpansBothComponents) {
  double low = 0, high = 0;
  const cv::Mat known = pair_.dx == pair_.dx;
  cv::minMaxLoc(pair_.dx, &low, &high, nullptr, nullptr, known);
  EXPECT_NEAR(low, -24, 1);
  EXPECT_NEAR(high, 32, 1);
  cv::minMaxLoc(pair_.dy, &low, &high, nullptr, nullptr, known);
  EXPECT_NEAR(low, -11, 1);
  EXPECT_NEAR(high, 1.4, 1);
}

TEST_F(VergedMotorcycle, AccurateBeatsOpticalFlowThreefold) {
  // DIS, both ways and checked: median 0.36 px, 10 % beyond 2 px.
  const FieldScore score = ScoreOf(V1Config::Preset("accurate"));
  EXPECT_GE(score.density, 0.80);
  EXPECT_LE(score.median_error_px, 0.17);
  EXPECT_LE(score.bad2, 0.040);
}

TEST_F(VergedMotorcycle, FastIsNearlyAsGood) {
  const FieldScore score = ScoreOf(V1Config::Preset("fast"));
  EXPECT_GE(score.density, 0.80);
  EXPECT_LE(score.median_error_px, 0.18);
  EXPECT_LE(score.bad2, 0.050);
}

TEST_F(VergedMotorcycle, DenseHasEveryPixel) {
  const FieldScore score = ScoreOf(V1Config::Preset("dense"));
  EXPECT_EQ(score.density, 1);
  EXPECT_LE(score.bad2, 0.14);
}

// The limits are those measured for the 2009 model with a median, without and with the left-right
// check, by an implementation of its own.
TEST_F(VergedMotorcycle, OneDirectionIsNoWorseThanThePublishedModel) {
  V1Config config = V1Config::Preset("checked");
  config.left_right_px = 0;
  config.min_correlation = -1;
  const FieldScore score = ScoreOf(config);
  EXPECT_GE(score.density, 0.90);
  EXPECT_LE(score.median_error_px, 0.43);
  EXPECT_LE(score.bad2, 0.32);
}

TEST_F(VergedMotorcycle, CheckedIsNoWorseThanThePublishedModel) {
  const FieldScore score = ScoreOf(V1Config::Preset("checked"));
  EXPECT_GE(score.density, 0.71);
  EXPECT_LE(score.median_error_px, 0.28);
  EXPECT_LE(score.bad2, 0.18);
}

TEST_F(VergedMotorcycle, PublishedModelWithMedianAndCheckFindsMostOfTheScene) {
  V1Config config = V1Config::Preset("paper_2009");
  config.median_px = 5;
  config.left_right_px = 1;
  const FieldScore score = ScoreOf(config);
  EXPECT_GE(score.density, 0.71);
  EXPECT_LE(score.median_error_px, 0.33);
  EXPECT_LE(score.bad2, 0.20);
}

}  // namespace
}  // namespace horopter::vision
