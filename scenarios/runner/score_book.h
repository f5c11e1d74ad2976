// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <string>
#include <vector>

#include "hardware/types/pose.h"
#include "hardware/types/time.h"
#include "scenarios/format/scenario.h"
#include "scenarios/results/run_record.h"
#include "scenarios/runner/truth_probe.h"

namespace horopter::scenarios {

/// How a goto step ended.
struct GotoOutcome {
  bool reached = false;                   ///< in the robot's own opinion
  double duration_s = 0;                  ///< from the step's start
  std::optional<double> true_distance_m;  ///< from the goal, where there is truth
};

/// The largest true distance from a goal over all goto steps that were begun, each at its end [m];
/// nothing when there was none, or none with truth.
std::optional<double> WorstGoalDistance(const std::vector<GotoOutcome>& gotos);

/// Collects what happens in a run and turns it into the metrics that expectations name
/// (scenarios/format/metric_registry.h).
class ScoreBook {
 public:
  struct Tick {
    hardware::Pose2 odometry;
    std::optional<hardware::Pose2> true_pose;
    std::optional<double> clearance_m;
    std::optional<int> contacts;
    std::optional<double> fixation_error_deg;
  };

  /// @param planned_gotos goto steps of the scenario: one that is never begun is not reached
  explicit ScoreBook(int planned_gotos = 0) : planned_gotos_(planned_gotos) {}

  void AddTick(const Tick& tick);

  /// Holds estimated depth against the true one over the pixels where both exist.
  /// @param depth_m estimated; NaN = none
  /// @param fixating the frame also counts for the board, where the truth has one
  DepthScore AddFrame(const cv::Mat1f& depth_m, const FrameTruth& truth, bool fixating);

  void AddGoto(const GotoOutcome& outcome) { gotos_.push_back(outcome); }

  /// Every metric that has a value, by its registered name and in its registered unit.
  std::map<std::string, double> Metrics() const;

  const std::vector<GotoOutcome>& gotos() const { return gotos_; }

  /// Whether every planned goto step was begun, and there was one.
  bool BeganEveryGoto() const;

 private:
  void AddFixation(std::map<std::string, double>& metrics) const;

  int planned_gotos_;
  std::optional<double> clearance_m_;
  std::optional<int> contacts_;
  std::optional<hardware::Pose2> last_true_;
  double path_m_ = 0;
  std::optional<double> odometry_error_m_;
  std::vector<double> fixation_errors_deg_;
  std::vector<double> densities_;
  std::vector<double> biases_m_;
  std::vector<float> abs_rel_;                    ///< one in kStride of all scored pixels
  double board_sum_m_ = 0, board_square_m2_ = 0;  ///< of the errors of depth on the board
  long board_pixels_ = 0;                         ///< on the board, with a depth
  long board_expected_ = 0;                       ///< on the board
  std::vector<GotoOutcome> gotos_;
};

/// Holds an expectation against the metrics.
/// @param has_truth false: expectations that need truth are not applicable, never passed
ExpectationResult Evaluate(const Expectation& expectation, const ScoreBook& book,
                           const std::map<std::string, double>& metrics, bool has_truth);

}  // namespace horopter::scenarios
