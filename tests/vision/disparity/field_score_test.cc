// SPDX-License-Identifier: Apache-2.0
#include "vision/disparity/field_score.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <opencv2/core.hpp>
#include <stdexcept>
#include <string>

namespace horopter::vision {
namespace {

using ::testing::ElementsAre;

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

std::string Complaint(const DisparityMaps& estimate, const DisparityMaps& truth,
                      const cv::Mat1b& mask = {}) {
  try {
    ScoreDisparity(estimate, truth, mask);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(FieldScore, CountsErrorsByHand) {
  // Errors 0, 0.75, 3, 5; one pixel without an estimate; one without truth.
  const cv::Mat1f truth = (cv::Mat1f(1, 6) << 10, 10, 10, 10, 10, kNaN);
  const cv::Mat1f estimate = (cv::Mat1f(1, 6) << 10, 10.75F, 7, 15, kNaN, 3);
  const FieldScores scores = ScoreDisparity({estimate, {}}, {truth, {}});
  const ErrorScore& dx = scores.dx;
  EXPECT_EQ(dx.known, 5);
  EXPECT_EQ(dx.estimated, 4);
  EXPECT_DOUBLE_EQ(dx.density, 0.8);
  EXPECT_DOUBLE_EQ(dx.mean_px, 8.75 / 4);
  EXPECT_DOUBLE_EQ(dx.median_px, (0.75 + 3) / 2);
  EXPECT_DOUBLE_EQ(dx.rms_px, std::sqrt((0.5625 + 9 + 25) / 4));
  EXPECT_EQ(dx.max_px, 5);
  EXPECT_EQ(dx.max_at, cv::Point(3, 0));
  EXPECT_THAT(dx.bad_estimated, ElementsAre(0.75, 0.5, 0.5, 0.25));
  EXPECT_THAT(dx.bad_known, ElementsAre(0.8, 0.6, 0.6, 0.4)) << "a missing estimate is a bad one";
  EXPECT_FALSE(scores.dy || scores.vector) << "nobody said anything of the vertical";
}

TEST(FieldScore, VectorIsTheLengthOfBothErrors) {
  const DisparityMaps truth{(cv::Mat1f(1, 2) << 1, 1), (cv::Mat1f(1, 2) << 2, kInfinity)};
  const DisparityMaps estimate{(cv::Mat1f(1, 2) << 4, 1), (cv::Mat1f(1, 2) << -2, 7)};
  const FieldScores scores = ScoreDisparity(estimate, truth);
  EXPECT_EQ(scores.dx.mean_px, 1.5);
  EXPECT_EQ(scores.dy->known, 1);
  EXPECT_EQ(scores.dy->mean_px, 4);
  EXPECT_EQ(scores.vector->known, 1) << "infinite is as unknown as NaN";
  EXPECT_EQ(scores.vector->mean_px, 5);
}

TEST(FieldScore, AnErrorAtALimitIsNotBeyondIt) {
  const auto scores =
      ScoreDisparity({(cv::Mat1f(1, 2) << 2, 2.25F), {}}, {cv::Mat1f::zeros(1, 2), {}});
  EXPECT_THAT(scores.dx.bad_estimated, ElementsAre(1, 1, 0.5, 0));
}

TEST(FieldScore, MaskSaysWhatCounts) {
  const cv::Mat1b mask = (cv::Mat1b(1, 3) << 255, 0, 1);
  const auto scores =
      ScoreDisparity({(cv::Mat1f(1, 3) << 1, 50, 2), {}}, {cv::Mat1f::zeros(1, 3), {}}, mask);
  EXPECT_EQ(scores.dx.known, 2);
  EXPECT_EQ(scores.dx.max_px, 2);
}

TEST(FieldScore, NothingEstimatedHasNoErrorsButAllBad) {
  const auto scores = ScoreDisparity({cv::Mat1f(1, 3, kNaN), {}}, {cv::Mat1f::zeros(1, 3), {}});
  EXPECT_EQ(scores.dx.density, 0);
  EXPECT_TRUE(std::isnan(scores.dx.median_px) && std::isnan(scores.dx.max_px));
  EXPECT_TRUE(std::isnan(scores.dx.bad_estimated[0]));
  EXPECT_THAT(scores.dx.bad_known, ElementsAre(1, 1, 1, 1));
}

TEST(FieldScore, RefusesOtherSizesAndUnknownTruth) {
  const DisparityMaps truth{cv::Mat1f::zeros(4, 6), {}};
  EXPECT_THAT(Complaint({cv::Mat1f::zeros(4, 7), {}}, truth),
              ::testing::HasSubstr("estimate is 7x4, truth is 6x4"));
  EXPECT_THAT(Complaint(truth, truth, cv::Mat1b::ones(3, 6)),
              ::testing::HasSubstr("mask is 6x3, truth is 6x4"));
  EXPECT_THAT(Complaint(truth, {cv::Mat1f(4, 6, kNaN), {}}),
              ::testing::HasSubstr("unknown everywhere"));
  EXPECT_THAT(Complaint(truth, truth, cv::Mat1b::zeros(4, 6)),
              ::testing::HasSubstr("wherever the mask counts"));
}

}  // namespace
}  // namespace horopter::vision
