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
void EvaluateReached(const Expectation& expectation, const ScoreBook& book,
                     ExpectationResult& result) {
  result.outcome = ExpectationOutcome::kPassed;
  result.value = WorstGoalDistance(book.gotos());
  for (const GotoOutcome& g : book.gotos()) {
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

DepthScore ScoreBook::AddFrame(const cv::Mat1f& depth_m, const FrameTruth& truth, bool fixating) {
  const bool on_board = fixating && !truth.board.empty();
  std::vector<double> abs_rel;
  double bias_sum_m = 0;
  std::size_t estimated = 0;
  for (int y = 0; y < depth_m.rows; ++y) {
    for (int x = 0; x < depth_m.cols; ++x) {
      const double estimate_m = depth_m(y, x), true_m = truth.depth_m(y, x);
      const bool board_here = on_board && truth.board(y, x) != 0;
      if (board_here) ++board_expected_;
      if (!std::isfinite(estimate_m)) continue;
      ++estimated;
      if (!std::isfinite(true_m) || true_m <= 0) continue;
      const double error_m = estimate_m - true_m;
      abs_rel.push_back(std::abs(error_m) / true_m);
      bias_sum_m += error_m;
      if (abs_rel.size() % kStride == 0) abs_rel_.push_back(static_cast<float>(abs_rel.back()));
      if (!board_here) continue;
      board_sum_m_ += error_m;
      board_square_m2_ += error_m * error_m;
      ++board_pixels_;
    }
  }
  DepthScore score;
  score.density = static_cast<double>(estimated) / static_cast<double>(depth_m.total());
  densities_.push_back(score.density);
  if (abs_rel.empty()) return score;
  score.bias_m = bias_sum_m / static_cast<double>(abs_rel.size());
  biases_m_.push_back(*score.bias_m);
  score.abs_rel_mean = Mean(abs_rel);
  score.abs_rel_median = Median(std::move(abs_rel));
  return score;
}

bool ScoreBook::BeganEveryGoto() const {
  return !gotos_.empty() && static_cast<int>(gotos_.size()) >= planned_gotos_;
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
  if (BeganEveryGoto()) {
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
  if (board_expected_ > 0) {
    metrics["board.density"] =
        static_cast<double>(board_pixels_) / static_cast<double>(board_expected_);
  }
  if (board_pixels_ > 0) {
    const double n = static_cast<double>(board_pixels_);
    const double mean = board_sum_m_ / n;
    metrics["board.depth_error.mean"] = std::abs(mean);
    metrics["board.depth_error.std"] = std::sqrt(std::max(0.0, board_square_m2_ / n - mean * mean));
  }

  AddFixation(metrics);
  return metrics;
}

/// Nothing when an error was not a number: a fixation that cannot be judged is no good one.
void ScoreBook::AddFixation(std::map<std::string, double>& metrics) const {
  const std::vector<double>& errors_deg = fixation_errors_deg_;
  const bool judged =
      std::none_of(errors_deg.begin(), errors_deg.end(), [](double e) { return std::isnan(e); });
  if (errors_deg.empty() || !judged) return;
  metrics["fixation.error_deg.mean"] = Mean(errors_deg).value();
  metrics["fixation.error_deg.median"] = Median(errors_deg).value();
  metrics["fixation.error_deg.p95"] = Percentile95(errors_deg).value();
  metrics["fixation.error_deg.max"] = *std::max_element(errors_deg.begin(), errors_deg.end());
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
  if (expectation.metric == "reached" && !book.BeganEveryGoto()) {
    result.outcome = ExpectationOutcome::kFailed;
    result.detail = book.gotos().empty() ? "no goto step was begun" : "a goto step was never begun";
    return result;
  }
  if (expectation.metric == "reached" && expectation.before_s) {
    EvaluateReached(expectation, book, result);
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
