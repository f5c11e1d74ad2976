// SPDX-License-Identifier: Apache-2.0
#include "scenarios/runner/score_book.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

#include "scenarios/format/metric_registry.h"
#include "scenarios/results/statistics.h"

namespace horopter::scenarios {
namespace {

/// Every so-manieth scored pixel enters the run's quantiles; a prime, so that it walks over
/// columns.
constexpr int kStride = 7;

std::optional<double> Mean(const std::vector<double>& sample) {
  if (sample.empty()) return std::nullopt;
  return std::accumulate(sample.begin(), sample.end(), 0.0) / static_cast<double>(sample.size());
}

double AbsRel(double depth_m, double true_depth_m) {
  return std::abs(depth_m - true_depth_m) / true_depth_m;
}

/// Calls `score(y, x, depth, true depth)` for every pixel that has both depths, row by row.
template <typename Score>
void ForEachScored(const cv::Mat1f& depth_m, const cv::Mat1f& true_depth_m, Score score) {
  for (int y = 0; y < depth_m.rows; ++y) {
    for (int x = 0; x < depth_m.cols; ++x) {
      const double estimate = depth_m(y, x), truth = true_depth_m(y, x);
      if (std::isfinite(estimate) && std::isfinite(truth) && truth > 0) {
        score(y, x, estimate, truth);
      }
    }
  }
}

bool Holds(double value, Comparison comparison, double limit) {
  switch (comparison) {
    case Comparison::kAtMost:
      return value <= limit;
    case Comparison::kAtLeast:
      return value >= limit;
    case Comparison::kLess:
      return value < limit;
    case Comparison::kGreater:
      return value > limit;
    case Comparison::kEqual:
      return value == limit;
  }
  return false;
}

std::string HowItEnded(const GotoOutcome& g) {
  const std::string end =
      fmt::format("{} after {:.1f} s", g.reached ? "said it had arrived" : "gave up", g.duration_s);
  return g.true_distance_m ? fmt::format("{}, {:.3f} m from the goal", end, *g.true_distance_m)
                           : end;
}

/// "reached within D before T": every goal, in the robot's own opinion and in truth.
void EvaluateReached(const Expectation& expectation, const std::vector<GotoOutcome>& gotos,
                     ExpectationResult& result) {
  result.outcome = ExpectationOutcome::kFailed;
  if (gotos.empty()) {
    result.detail = "no goto step was begun";
    return;
  }
  result.outcome = ExpectationOutcome::kPassed;
  result.value = WorstGoalDistance(gotos);
  for (const GotoOutcome& g : gotos) {
    const bool near = g.true_distance_m && *g.true_distance_m <= result.limit;
    const bool in_time = !expectation.before_s || g.duration_s <= *expectation.before_s;
    if (g.reached && near && in_time) continue;
    result.outcome = ExpectationOutcome::kFailed;
    if (result.detail.empty()) result.detail = HowItEnded(g);
  }
}

}  // namespace

std::optional<double> WorstGoalDistance(const std::vector<GotoOutcome>& gotos) {
  std::optional<double> worst_m;
  for (const GotoOutcome& g : gotos) {
    if (g.true_distance_m) worst_m = std::max(worst_m.value_or(0), *g.true_distance_m);
  }
  return worst_m;
}

DepthScore ScoreDepth(const cv::Mat1f& depth_m, const cv::Mat1f& true_depth_m) {
  DepthScore score;
  std::vector<double> abs_rel;
  double bias = 0;
  ForEachScored(depth_m, true_depth_m, [&](int, int, double estimate, double truth) {
    abs_rel.push_back(AbsRel(estimate, truth));
    bias += estimate - truth;
  });
  const auto estimated = std::count_if(depth_m.begin(), depth_m.end(),
                                       [](float estimate) { return std::isfinite(estimate); });
  score.density = static_cast<double>(estimated) / static_cast<double>(depth_m.total());
  if (!abs_rel.empty()) {
    score.bias_m = bias / static_cast<double>(abs_rel.size());
    score.abs_rel_mean = Mean(abs_rel);
    score.abs_rel_median = Median(std::move(abs_rel));
  }
  return score;
}

void ScoreBook::AddTick(const Tick& tick) {
  if (tick.clearance_m) {
    clearance_m_ = std::min(clearance_m_.value_or(*tick.clearance_m), *tick.clearance_m);
  }
  if (tick.contacts) contacts_ = tick.contacts;
  if (tick.fixation_error_deg) fixation_errors_deg_.push_back(*tick.fixation_error_deg);
  if (!tick.true_pose) return;
  if (last_true_) {
    path_m_ +=
        std::hypot(tick.true_pose->x_m - last_true_->x_m, tick.true_pose->y_m - last_true_->y_m);
  }
  last_true_ = tick.true_pose;
  odometry_error_m_ =
      std::hypot(tick.true_pose->x_m - tick.odometry.x_m, tick.true_pose->y_m - tick.odometry.y_m);
}

void ScoreBook::AddFrame(const DepthScore& score, const cv::Mat1f& depth_m, const FrameTruth& truth,
                         bool fixating) {
  densities_.push_back(score.density);
  if (score.bias_m) biases_m_.push_back(*score.bias_m);
  int count = 0;
  ForEachScored(depth_m, truth.depth_m, [&](int, int, double estimate, double true_m) {
    if (++count % kStride == 0) abs_rel_.push_back(static_cast<float>(AbsRel(estimate, true_m)));
  });
  if (fixating && !truth.board.empty()) AddBoard(depth_m, truth);
}

void ScoreBook::AddBoard(const cv::Mat1f& depth_m, const FrameTruth& truth) {
  ForEachScored(depth_m, truth.depth_m, [&](int y, int x, double estimate, double true_m) {
    if (truth.board(y, x) == 0) return;
    const double error = estimate - true_m;
    board_sum_m_ += error;
    board_square_m2_ += error * error;
    ++board_pixels_;
  });
}

std::map<std::string, double> ScoreBook::Metrics() const {
  std::map<std::string, double> metrics;
  const auto add = [&metrics](const char* name, std::optional<double> value) {
    if (value) metrics[name] = *value;
  };
  add("clearance", clearance_m_);
  if (contacts_) metrics["contacts"] = *contacts_;
  if (last_true_) metrics["path_length"] = path_m_;
  add("odometry.error", odometry_error_m_);
  if (!gotos_.empty()) {
    add("reached", WorstGoalDistance(gotos_));
    double total_s = 0;
    bool all = true;
    for (const GotoOutcome& g : gotos_) {
      total_s += g.duration_s;
      all = all && g.reached;
    }
    if (all) metrics["time_to_goal"] = total_s;
  }

  const std::vector<double> abs_rel(abs_rel_.begin(), abs_rel_.end());
  add("depth.abs_rel.median", Median(abs_rel));
  add("depth.abs_rel.mean", Mean(abs_rel));
  add("depth.abs_rel.p95", Percentile95(abs_rel));
  add("depth.density", Mean(densities_));
  add("depth.bias", Mean(biases_m_));
  if (board_pixels_ > 0) {
    const double n = static_cast<double>(board_pixels_);
    const double mean = board_sum_m_ / n;
    metrics["board.depth_error.mean"] = std::abs(mean);
    metrics["board.depth_error.std"] = std::sqrt(std::max(0.0, board_square_m2_ / n - mean * mean));
  }

  add("fixation.error_deg.mean", Mean(fixation_errors_deg_));
  add("fixation.error_deg.median", Median(fixation_errors_deg_));
  add("fixation.error_deg.p95", Percentile95(fixation_errors_deg_));
  if (!fixation_errors_deg_.empty()) {
    metrics["fixation.error_deg.max"] =
        *std::max_element(fixation_errors_deg_.begin(), fixation_errors_deg_.end());
  }
  return metrics;
}

ExpectationResult Evaluate(const Expectation& expectation, const ScoreBook& book,
                           const std::map<std::string, double>& metrics, bool has_truth) {
  ExpectationResult result;
  result.name = expectation.text;
  result.metric = expectation.metric;
  const Metric* metric = FindMetric(expectation.metric);
  assert(metric != nullptr);  // the parser refuses unknown metrics and units
  result.unit = metric->unit;
  result.limit = ToMetricUnit(expectation.limit, expectation.unit, *metric).value();
  if (metric->needs_truth && !has_truth) {
    result.detail = "this backend has no truth to hold it against";
    return result;
  }
  if (expectation.metric == "reached" && expectation.before_s) {
    EvaluateReached(expectation, book.gotos(), result);
    return result;
  }
  const auto found = metrics.find(expectation.metric);
  if (found == metrics.end()) {
    result.outcome = ExpectationOutcome::kFailed;
    result.detail = "nothing was measured";
    return result;
  }
  result.value = found->second;
  const bool holds = Holds(found->second, expectation.comparison, result.limit);
  result.outcome = holds ? ExpectationOutcome::kPassed : ExpectationOutcome::kFailed;
  return result;
}

}  // namespace horopter::scenarios
