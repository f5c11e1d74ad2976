// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "hardware/types/head_angles.h"
#include "hardware/types/pose.h"
#include "hardware/types/time.h"

namespace horopter::scenarios {

enum class Outcome { kPassed, kFailed, kError, kIncomplete };
enum class ExpectationOutcome { kPassed, kFailed, kNotApplicable };

std::string ToString(Outcome outcome);             ///< passed, failed, error, incomplete
std::string ToString(ExpectationOutcome outcome);  ///< passed, failed, not_applicable

struct ExpectationResult {
  std::string name;             ///< the sentence of the scenario
  std::optional<double> value;  ///< nothing when the metric never had one
  double limit = 0;
  std::string unit;
  ExpectationOutcome outcome = ExpectationOutcome::kNotApplicable;
  std::string metric;  ///< what it judges, e.g. "clearance"; its limit is drawn into that chart
  std::string detail;  ///< one sentence when it did not pass
};

/// What the passes through one stage took. Times are absent for a stage that never ran.
struct StageTiming {
  std::optional<double> median_ms;
  std::optional<double> p95_ms;
  int n = 0;
  std::optional<double> modelled_ms = {};  ///< what the simulation lets it take, where it does
};

/// Depth against truth over one frame's valid pixels. Fields are absent where nothing was valid.
struct DepthScore {
  double density = 0;                    ///< valid pixels / all pixels
  std::optional<double> abs_rel_median;  ///< |Z - Z*| / Z*
  std::optional<double> abs_rel_mean;
  std::optional<double> bias_m;  ///< mean Z - Z*
};

/// One vision cycle as it is reported. Everything "true" comes from scoring, never from the stack.
struct FrameRecord {
  std::uint64_t index = 0;  ///< from 0, counts vision cycles
  hardware::Time t_capture{};
  hardware::Pose2 odometry;                  ///< frame: the robot's start
  std::optional<hardware::Pose2> true_pose;  ///< same frame
  hardware::HeadAngles angles;               ///< as read
  std::string step;                          ///< the step under way, e.g. "goto"
  std::string decision;                      ///< the navigator's state and why, one line
  std::optional<DepthScore> depth;
  std::optional<double> fixation_error_deg;
  std::optional<double> clearance_m;
  double disparity_density = 0;
  int regions = 0;
};

/// What the ends of a picture's colour scale stand for. One set for a whole run, so that its frames
/// can be compared by eye.
struct ColourScales {
  double near_m = 0.3;           ///< depth, estimated and true; logarithmic in between
  double far_m = 5.0;            ///< likewise; nearer and farther take the end's colour
  double disparity_px = 30;      ///< horizontal disparity, from minus to plus this
  double relative_error = 0.25;  ///< (Z - Z*) / Z*, from minus to plus this
};

/// Pictures of one frame, all of one size except where stated. Empty mats are left out.
/// MakeFrameImages() in frame_pictures.h colours them all by one set of scales.
struct FrameImages {
  cv::Mat left_bgr;
  cv::Mat right_bgr;
  cv::Mat disparity_bgr;    ///< coloured
  cv::Mat depth_bgr;        ///< estimated depth, coloured
  cv::Mat true_depth_bgr;   ///< same colour scale
  cv::Mat depth_error_bgr;  ///< signed relative error, coloured
  cv::Mat regions_bgr;      ///< blobs with their depth, as in Figure 5
  ColourScales scales;      ///< that the pictures above were coloured with, for their legends
};

/// A thing drawn on the plan of the room, in the robot's starting frame.
struct PlanShape {
  std::string name;
  std::string kind;                                  ///< wall, furniture, obstacle, board
  std::vector<std::pair<double, double>> outline_m;  ///< closed polygon
};

struct PathPoint {
  double t_s = 0;
  hardware::Pose2 odometry;
  std::optional<hardware::Pose2> true_pose;
};

/// What the plan of the room shows.
struct PlanRecord {
  std::vector<PlanShape> shapes;
  std::vector<PathPoint> path;
  std::vector<std::pair<double, double>> goals_m;
  std::vector<std::pair<double, double>> waypoints_m;  ///< intermediate ones
  double robot_radius_m = 0;
};

/// What a run was played on.
struct Machine {
  std::string processor;       ///< "" when unknown
  unsigned cores = 0;          ///< that the run could use; 0 when unknown
  std::optional<double> load;  ///< mean number of busy processes in the minute before it began

  bool operator==(const Machine&) const = default;
};

/// A run as summary.json has it.
struct RunSummary {
  std::string scenario;
  std::string description;
  std::string file;  ///< as given on the command line
  std::uint64_t seed = 0;
  std::string backend;
  std::vector<std::string> faults;  ///< injected on purpose; a line each, as the scenario has them
  Outcome outcome = Outcome::kIncomplete;
  std::string error;  ///< why the run did not come to its end; empty when it did
  std::vector<ExpectationResult> expectations;
  std::map<std::string, double> metrics;  ///< every metric that has a value, by its name
  std::string image_hash;                 ///< over all images the stack saw; hex
  std::string decision_hash;              ///< over all decisions and commands; hex
  std::map<std::string, StageTiming> timing_ms;
  std::optional<double> sim_s;   ///< nothing until the run has ended
  std::optional<double> wall_s;  ///< likewise
  std::string gl_renderer;
  Machine machine;
  std::map<std::string, std::string> versions;
  std::string directory;  ///< the run's folder, relative to the suite's
};

/// "Intel Xeon, 2 cores", without its load; "unknown machine".
std::string DescribeMachine(const Machine& machine);

/// "0.1.0 (3308bf3-dirty), program bbe066b61e81" of a run's versions; "an unknown build" without.
std::string DescribeBuild(const std::map<std::string, std::string>& versions);

}  // namespace horopter::scenarios
