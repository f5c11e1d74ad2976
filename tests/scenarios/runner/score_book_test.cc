// SPDX-License-Identifier: Apache-2.0
#include "scenarios/runner/score_book.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "scenarios/format/metric_registry.h"

namespace horopter::scenarios {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInf = std::numeric_limits<float>::infinity();

Expectation Expect(const std::string& metric, Comparison comparison, double limit,
                   const std::string& unit = "") {
  Expectation e;
  e.text = metric;
  e.metric = metric;
  e.comparison = comparison;
  e.limit = limit;
  e.unit = unit;
  return e;
}

Expectation ReachedWithin(double distance_m, double before_s) {
  Expectation e = Expect("reached", Comparison::kAtMost, distance_m, "m");
  e.before_s = before_s;
  return e;
}

ExpectationResult Evaluate(const Expectation& e, const ScoreBook& book, bool has_truth = true) {
  return scenarios::Evaluate(e, book, book.Metrics(), has_truth);
}

/// Of one frame alone.
DepthScore ScoreDepth(const cv::Mat1f& depth_m, const cv::Mat1f& true_depth_m) {
  return ScoreBook().AddFrame(depth_m, {true_depth_m, {}}, /*fixating=*/false);
}

TEST(ScoreDepth, CountsOnlyPixelsWithBothDepths) {
  const cv::Mat1f truth = (cv::Mat1f(1, 4) << 2, 2, kInf, 4);
  const cv::Mat1f estimate = (cv::Mat1f(1, 4) << 2.2f, kNan, 1, 3.8f);
  const DepthScore score = ScoreDepth(estimate, truth);
  EXPECT_DOUBLE_EQ(score.density, 0.75);
  ASSERT_TRUE(score.abs_rel_median && score.bias_m && score.abs_rel_mean);
  EXPECT_NEAR(*score.abs_rel_median, (0.1 + 0.05) / 2, 1e-6);
  EXPECT_NEAR(*score.abs_rel_mean, (0.1 + 0.05) / 2, 1e-6);
  EXPECT_NEAR(*score.bias_m, 0, 1e-6);
}

TEST(ScoreDepth, NothingEstimatedGivesNoNumbers) {
  const DepthScore score = ScoreDepth(cv::Mat1f(2, 2, kNan), cv::Mat1f(2, 2, 1.0f));
  EXPECT_EQ(score.density, 0);
  EXPECT_FALSE(score.abs_rel_median || score.abs_rel_mean || score.bias_m);
}

TEST(ScoreBook, EmptyBookHasNoMetrics) { EXPECT_TRUE(ScoreBook().Metrics().empty()); }

TEST(ScoreBook, ARunWithEverythingInItHasEveryRegisteredMetric) {
  ScoreBook book;
  ScoreBook::Tick tick;
  tick.true_pose = hardware::Pose2{0.1, 0, 0};
  tick.clearance_m = 0.4;
  tick.contacts = 0;
  tick.fixation_error_deg = 0.2;
  book.AddTick(tick);
  const FrameTruth truth{cv::Mat1f(4, 4, 1.0f), cv::Mat1b(4, 4, uchar{255})};
  const cv::Mat1f depth(4, 4, 1.1f);
  book.AddFrame(depth, truth, /*fixating=*/true);
  book.AddGoto({true, 10, 0.05});
  std::vector<std::string> measured;
  for (const auto& [name, value] : book.Metrics()) {
    EXPECT_TRUE(std::isfinite(value)) << name;
    measured.push_back(name);
  }
  EXPECT_THAT(measured, testing::UnorderedElementsAreArray(MetricNames()));
}

TEST(ScoreBook, ReachedIsTheWorstGoalAndTimeTheSumOfAll) {
  ScoreBook book;
  book.AddGoto({true, 10, 0.20});
  book.AddGoto({true, 15, 0.05});
  EXPECT_DOUBLE_EQ(book.Metrics().at("reached"), 0.20);
  EXPECT_DOUBLE_EQ(book.Metrics().at("time_to_goal"), 25);
  book.AddGoto({false, 60, 1.5});
  EXPECT_DOUBLE_EQ(book.Metrics().at("reached"), 1.5);
  EXPECT_EQ(book.Metrics().count("time_to_goal"), 0u);
}

TEST(ScoreBook, QuantilesOverTheRunAreThoseOfItsPixels) {
  const FrameTruth truth{cv::Mat1f(70, 10, 2.0f), {}};
  cv::Mat1f depth(70, 10, 2.2f);
  depth.rowRange(0, 20) = kNan;
  ScoreBook book;
  const DepthScore score = book.AddFrame(depth, truth, /*fixating=*/false);
  EXPECT_NEAR(book.Metrics().at("depth.abs_rel.median"), 0.1, 1e-6);
  EXPECT_NEAR(book.Metrics().at("depth.abs_rel.p95"), 0.1, 1e-6);
  EXPECT_NEAR(*score.abs_rel_median, 0.1, 1e-6);
  EXPECT_NEAR(book.Metrics().at("depth.bias"), 0.2, 1e-6);
}

TEST(ScoreBook, ClearanceIsTheSmallestAndPathTheSumOfTrueMotion) {
  ScoreBook book;
  book.AddTick({{0, 0, 0}, hardware::Pose2{0, 0, 0}, 0.4, 0, {}});
  book.AddTick({{1, 0, 0}, hardware::Pose2{1.1, 0, 0}, 0.1, 0, {}});
  book.AddTick({{1, 1, 0}, hardware::Pose2{1.1, 1, 0}, 0.3, 2, {}});
  const auto metrics = book.Metrics();
  EXPECT_DOUBLE_EQ(metrics.at("clearance"), 0.1);
  EXPECT_DOUBLE_EQ(metrics.at("path_length"), 2.1);
  EXPECT_DOUBLE_EQ(metrics.at("contacts"), 2);
  EXPECT_NEAR(metrics.at("odometry.error"), 0.1, 1e-12);
}

TEST(ScoreBook, BoardErrorIsTakenOverTheBoardAlone) {
  FrameTruth truth;
  truth.depth_m = cv::Mat1f(10, 10, 1.0f);
  truth.board = cv::Mat1b(10, 10, uchar{0});
  truth.board(cv::Rect(0, 0, 10, 2)) = 255;
  cv::Mat1f depth(10, 10, 2.0f);
  depth.row(0) = 0.97f;
  depth.row(1) = 0.99f;
  ScoreBook book;
  book.AddFrame(depth, truth, /*fixating=*/true);
  const auto metrics = book.Metrics();
  EXPECT_NEAR(metrics.at("board.depth_error.mean"), 0.02, 1e-6);
  EXPECT_NEAR(metrics.at("board.depth_error.std"), 0.01, 1e-6);
}

TEST(ScoreBook, BoardDensityIsTheShareOfTheBoardWithADepth) {
  FrameTruth truth{cv::Mat1f(10, 10, 1.0f), cv::Mat1b(10, 10, uchar{0})};
  truth.board(cv::Rect(0, 0, 10, 4)) = 255;
  cv::Mat1f depth(10, 10, std::numeric_limits<float>::quiet_NaN());
  depth.row(0) = 1.0f;  // a quarter of the board, perfectly
  depth.row(9) = 1.0f;  // not on it
  ScoreBook book;
  book.AddFrame(depth, truth, /*fixating=*/true);
  EXPECT_DOUBLE_EQ(book.Metrics().at("board.density"), 0.25);
  EXPECT_NEAR(book.Metrics().at("board.depth_error.mean"), 0, 1e-6);
  book.AddFrame(cv::Mat1f(10, 10, std::numeric_limits<float>::quiet_NaN()), truth, true);
  EXPECT_DOUBLE_EQ(book.Metrics().at("board.density"), 0.125);
}

TEST(ScoreBook, BoardCountsOnlyWhileFixating) {
  FrameTruth truth{cv::Mat1f(4, 4, 1.0f), cv::Mat1b(4, 4, uchar{255})};
  ScoreBook book;
  book.AddFrame(cv::Mat1f(4, 4, 1.0f), truth, /*fixating=*/false);
  EXPECT_EQ(book.Metrics().count("board.depth_error.mean"), 0u);
}

TEST(Evaluate, ComparesInTheMetricsOwnUnit) {
  ScoreBook book;
  book.AddTick({{}, {}, 0.04, {}, {}});
  EXPECT_EQ(Evaluate(Expect("clearance", Comparison::kAtLeast, 0.03, "m"), book).outcome,
            ExpectationOutcome::kPassed);
  EXPECT_EQ(Evaluate(Expect("clearance", Comparison::kAtLeast, 5, "cm"), book).outcome,
            ExpectationOutcome::kFailed);
  EXPECT_EQ(Evaluate(Expect("clearance", Comparison::kAtLeast, 3, "cm"), book).outcome,
            ExpectationOutcome::kPassed);
}

TEST(Evaluate, WithoutTruthNothingThatNeedsItPasses) {
  ScoreBook book;
  book.AddTick({{}, {}, 1.0, 0, {}});
  const auto result = Evaluate(Expect("clearance", Comparison::kAtLeast, 0.05, "m"), book, false);
  EXPECT_EQ(result.outcome, ExpectationOutcome::kNotApplicable);
  EXPECT_FALSE(result.value.has_value());
}

TEST(Evaluate, WhatWasNeverMeasuredFails) {
  const auto result = Evaluate(Expect("clearance", Comparison::kAtLeast, 0.05, "m"), ScoreBook());
  EXPECT_EQ(result.outcome, ExpectationOutcome::kFailed);
  EXPECT_FALSE(result.value.has_value());
  EXPECT_THAT(result.detail, testing::HasSubstr("measured"));
}

TEST(Evaluate, ReachedNeedsOpinionDistanceAndTime) {
  const auto outcome = [](GotoOutcome g) {
    ScoreBook book;
    book.AddGoto(g);
    return Evaluate(ReachedWithin(0.15, 60), book).outcome;
  };
  EXPECT_EQ(outcome({true, 30, 0.10}), ExpectationOutcome::kPassed);
  EXPECT_EQ(outcome({false, 30, 0.10}), ExpectationOutcome::kFailed);
  EXPECT_EQ(outcome({true, 61, 0.10}), ExpectationOutcome::kFailed);
  EXPECT_EQ(outcome({true, 30, 0.16}), ExpectationOutcome::kFailed);
}

TEST(Evaluate, ResultNamesTheMetricItJudges) {
  ScoreBook book;
  book.AddTick({{}, {}, 0.04, {}, {}});
  book.AddGoto({true, 30, 0.10});
  EXPECT_EQ(Evaluate(Expect("clearance", Comparison::kAtLeast, 0.03, "m"), book).metric,
            "clearance");
  EXPECT_EQ(Evaluate(ReachedWithin(0.15, 60), book).metric, "reached");
  EXPECT_EQ(Evaluate(ReachedWithin(0.15, 60), book, /*has_truth=*/false).metric, "reached");
}

TEST(Evaluate, ReachedHasOneValueInBothItsForms) {
  ScoreBook book;
  book.AddGoto({true, 10, 0.20});
  book.AddGoto({true, 10, 0.05});
  EXPECT_EQ(Evaluate(ReachedWithin(0.15, 60), book).value,
            Evaluate(Expect("reached", Comparison::kAtMost, 0.15, "m"), book).value);
}

TEST(Evaluate, EveryGoalMustBeReached) {
  ScoreBook book;
  book.AddGoto({true, 10, 0.20});
  book.AddGoto({true, 10, 0.05});
  const auto result = Evaluate(ReachedWithin(0.15, 60), book);
  EXPECT_EQ(result.outcome, ExpectationOutcome::kFailed);
  EXPECT_DOUBLE_EQ(result.value.value(), 0.20);
}

TEST(Evaluate, NoGoalBegunIsNotReached) {
  EXPECT_EQ(Evaluate(ReachedWithin(0.15, 60), ScoreBook()).outcome, ExpectationOutcome::kFailed);
}

TEST(Evaluate, GoalsThatWereNeverBegunAreNotReached) {
  ScoreBook book(/*planned_gotos=*/2);
  book.AddGoto({true, 10, 0.05});
  for (const Expectation& e :
       {ReachedWithin(0.15, 60), Expect("reached", Comparison::kAtMost, 0.15, "m")}) {
    const auto result = Evaluate(e, book);
    EXPECT_EQ(result.outcome, ExpectationOutcome::kFailed);
    EXPECT_THAT(result.detail, testing::HasSubstr("never begun"));
  }
  EXPECT_EQ(book.Metrics().count("reached"), 0u);
  EXPECT_EQ(book.Metrics().count("time_to_goal"), 0u);
  book.AddGoto({true, 10, 0.05});
  EXPECT_EQ(Evaluate(ReachedWithin(0.15, 60), book).outcome, ExpectationOutcome::kPassed);
}

TEST(Evaluate, FixationThatHasNoErrorAtATickHasNoneAtAll) {
  ScoreBook book;
  book.AddTick({{}, {}, {}, {}, 0.1});
  book.AddTick({{}, {}, {}, {}, std::nan("")});
  for (const char* metric : {"fixation.error_deg.p95", "fixation.error_deg.max"}) {
    EXPECT_EQ(Evaluate(Expect(metric, Comparison::kAtMost, 1, "deg"), book).outcome,
              ExpectationOutcome::kFailed)
        << metric;
  }
}

}  // namespace
}  // namespace horopter::scenarios
