// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace horopter::scenarios {

/// Where a thing of the scenario file was written, for messages: "file:line:column".
struct SourceMark {
  std::string file;
  int line = 0;    ///< from 1; 0 = not from a file
  int column = 0;  ///< from 1

  std::string ToString() const;
  bool operator==(const SourceMark&) const = default;
};

/// What a seed changes (DESIGN: obstacles, heading, textures). Everything else follows the seed
/// through its own stream (sensor noise).
struct VariationSpec {
  double obstacles_m = 0.15;
  double heading_deg = 5;
  bool textures = true;

  bool operator==(const VariationSpec&) const = default;
};

/// Pose given to a movable body of the scene, in the robot's starting frame: where the robot is
/// told that it is, whatever the seed did to its heading.
struct BodyPlacement {
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();
  double yaw_deg = 0;

  bool operator==(const BodyPlacement&) const = default;
};

/// Stands for a number that the file leaves to robot.yaml (FillFromRobot); outside every range.
inline constexpr double kRobotsOwn = -1;

/// Pixels, optics and sensor of both eyes.
struct CameraSpec {
  int width = 320;
  int height = 240;
  double horizontal_fov_deg = kRobotsOwn;
  std::string sensor = "webcam_vga";  ///< a profile of sim/camera: ideal, webcam_vga

  bool operator==(const CameraSpec&) const = default;
};

struct HeadSpec {
  double encoder_step_deg = kRobotsOwn;
  double encoder_noise_deg = 0;

  bool operator==(const HeadSpec&) const = default;
};

struct VisionSpec {
  std::string method = "v1";
  std::string preset = "cautious";
  int scales = 5;
  double rate_hz = 2.5;     ///< vision cycles per simulated second, if latency allows
  double latency_s = 0.40;  ///< modelled: from capture to result; the next cycle starts after it
  int median_px = 11;       ///< segmentation, Chessa et al. 2014
  int edge_threshold = 21;  ///< likewise

  bool operator==(const VisionSpec&) const = default;
};

struct NavigationSpec {
  std::string rule = "corridor";  ///< "paper": the paper's alone; "corridor": made safe for a robot
                                  ///< with a width and a narrow view
  double obstacle_limit_m = 1.2;
  double cruise_speed_m_s = 0.2;

  bool operator==(const NavigationSpec&) const = default;
};

struct GotoStep {
  Eigen::Vector2d goal_m = Eigen::Vector2d::Zero();  ///< in the robot's starting frame
  double tolerance_m = 0.10;                         ///< the robot's own, by odometry
  double timeout_s = 60;

  bool operator==(const GotoStep&) const = default;
};

/// Both optical axes meet in the target and stay there for hold_s.
struct FixateStep {
  Eigen::Vector3d target_m = Eigen::Vector3d::Zero();  ///< in the robot's starting frame (B at t=0)
  double hold_s = 1;

  bool operator==(const FixateStep&) const = default;
};

/// Both optical axes point the target's way, parallel.
struct LookAtStep {
  Eigen::Vector3d target_m = Eigen::Vector3d::Zero();
  double hold_s = 0.5;

  bool operator==(const LookAtStep&) const = default;
};

/// Commanded angles, as fast as the axes allow. Pan positive left, tilt positive down; vergence is
/// the angle between the optical axes, positive when they converge.
struct SaccadeStep {
  double pan_deg = 0;
  double tilt_deg = 0;
  double vergence_deg = 0;
  double hold_s = 0.5;

  bool operator==(const SaccadeStep&) const = default;
};

struct WaitStep {
  double duration_s = 1;

  bool operator==(const WaitStep&) const = default;
};

using StepAction = std::variant<GotoStep, FixateStep, LookAtStep, SaccadeStep, WaitStep>;

struct Step {
  SourceMark mark;
  StepAction action;

  bool operator==(const Step&) const = default;
};

enum class Comparison { kAtMost, kAtLeast, kLess, kGreater, kEqual };

/// One expectation, from a sentence such as
///   reached within 0.15 m before 60 s
///   contacts 0
///   clearance >= 0.05 m
///   depth.abs_rel.median <= 0.03
struct Expectation {
  SourceMark mark;
  std::string text;    ///< as written, white space folded: its name in every report
  std::string metric;  ///< e.g. "clearance"; "reached" for the first form
  Comparison comparison = Comparison::kAtMost;
  double limit = 0;                ///< in `unit`; for "reached": the distance
  std::string unit;                ///< "" when the metric has none
  std::optional<double> before_s;  ///< "reached" only

  bool operator==(const Expectation&) const = default;
};

/// A scenario file, parsed and checked, all defaults filled in.
struct Scenario {
  std::filesystem::path file;
  std::string name;  ///< default: the file's stem
  std::string description;
  std::vector<std::string> tags;
  std::string scene;  ///< MJCF below scenes/, e.g. koala/room.xml
  std::string robot = "koala";
  std::string backend = "sim";
  std::uint64_t seed = 1;
  double time_limit_s = 120;  ///< simulated; a run that has not ended by then fails
  VariationSpec variation;
  std::map<std::string, BodyPlacement> bodies;
  CameraSpec camera;
  HeadSpec head;
  VisionSpec vision;
  NavigationSpec navigation;
  std::vector<Step> steps;
  std::vector<Expectation> expect;

  bool operator==(const Scenario&) const = default;
};

}  // namespace horopter::scenarios
