// SPDX-License-Identifier: Apache-2.0
#include "scenarios/runner/expected_time.h"

#include <Eigen/Core>
#include <algorithm>
#include <variant>

namespace horopter::scenarios {
namespace {

/// A saccade of 25 degrees and its settling, as the axes of the shipped heads take it.
constexpr double kTurn_s = 0.3;

/// Time over that of the straight way at cruise speed, about what the shipped goto scenarios take:
/// obstacles to go round, and views to wait for.
constexpr double kDetour = 2;

/// Adds up the steps, remembering where the last goal was.
struct Sum {
  double cruise_speed_m_s;
  Eigen::Vector2d p_O = Eigen::Vector2d::Zero();

  double operator()(const GotoStep& step) {
    const double way_m = (step.goal_m - p_O).norm();
    p_O = step.goal_m;
    return std::min(step.timeout_s, kDetour * way_m / cruise_speed_m_s);
  }
  double operator()(const WaitStep& step) { return step.duration_s; }
  template <typename Gaze>
  double operator()(const Gaze& step) {
    return kTurn_s + step.hold_s;
  }
};

}  // namespace

double ExpectedSimSeconds(const Scenario& scenario) {
  Sum sum{scenario.navigation.cruise_speed_m_s};
  double total_s = 0;
  for (const Step& step : scenario.steps) total_s += std::visit(sum, step.action);
  return std::min(total_s, scenario.time_limit_s);
}

void ExpectedTimes::Learn(const RunSummary& run) {
  if (!run.sim_s) return;
  Sum& sum = by_scenario_[run.scenario];
  sum.sim_s += *run.sim_s;
  ++sum.runs;
}

double ExpectedTimes::Of(const Scenario& scenario) const {
  const auto known = by_scenario_.find(scenario.name);
  if (known == by_scenario_.end()) return ExpectedSimSeconds(scenario);
  return known->second.sim_s / known->second.runs;
}

}  // namespace horopter::scenarios
