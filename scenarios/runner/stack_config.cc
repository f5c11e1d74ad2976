// SPDX-License-Identifier: Apache-2.0
#include "scenarios/runner/stack_config.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "hardware/types/head_angles.h"
#include "vision/reconstruction/reconstruct.h"
#include "vision/regions/extract_regions.h"

namespace horopter::scenarios {
namespace {

using Json = nlohmann::ordered_json;

/// By how much a view may be older than it gets in the regular course before the robot stops.
constexpr double kViewAgeMargin = 1.25;

/// Room beside the robot, and before it, that a corridor and a stop leave.
constexpr double kSideRoom_m = 0.045;
constexpr double kFrontRoom_m = 0.185;

/// Room above the robot below which something is in its way.
constexpr double kHeadroom_m = 0.05;

/// JSON has no infinity.
Json Number(double value) { return std::isfinite(value) ? Json(value) : Json("inf"); }

// Each takes its struct apart, so that a field which is not recorded does not compile.

Json ToJson(const control::StripConfig& c) {
  const auto& [central_fraction, corridor_half_width_m, min_pixels, near_fraction, edges_count] = c;
  return {{"central_fraction", central_fraction},
          {"corridor_half_width_m", corridor_half_width_m},
          {"min_pixels", min_pixels},
          {"near_fraction", near_fraction},
          {"edges_count", edges_count}};
}

Json ToJson(const control::ObstacleMemoryConfig& c) {
  const auto& [cell_m, keep_s, min_pixels, max_range_m, clear_min_m, confirm_beyond_m] = c;
  return {{"cell_m", cell_m},           {"keep_s", Number(keep_s)},
          {"min_pixels", min_pixels},   {"max_range_m", max_range_m},
          {"clear_min_m", clear_min_m}, {"confirm_beyond_m", Number(confirm_beyond_m)}};
}

Json ToJson(const control::PidConfig& c) {
  const auto& [proportional, integral, derivative, output_limit] = c;
  return {{"proportional", proportional},
          {"integral", integral},
          {"derivative", derivative},
          {"output_limit", Number(output_limit)}};
}

Json ToJson(const control::WaypointControllerConfig& c) {
  const auto& [linear, angular, turn_in_place_rad, arrival_m, min_forward_m_s] = c;
  return {{"linear", ToJson(linear)},
          {"angular", ToJson(angular)},
          {"turn_in_place_rad", turn_in_place_rad},
          {"arrival_m", arrival_m},
          {"min_forward_m_s", min_forward_m_s}};
}

Json ToJson(const control::NavigatorConfig& c) {
  const auto& [obstacle_test, strips, obstacle_distance_m, avoid_angle_rad, avoid_fraction,
               avoid_min_m, avoid_max_m, waypoint_tolerance_m, goal_tolerance_m, avoid_directions,
               avoid_other_side_m, stop_distance_m, slow_distance_m, max_view_age_s,
               side_switch_ratio, side_hold_m, stuck_after_s, stuck_progress_m, memory, gaze_min_m,
               gaze_max_m, gaze_height_m, gaze_max_bearing_rad, controller] = c;
  const bool corridor = obstacle_test == control::ObstacleTest::kCorridor;
  return {{"obstacle_test", corridor ? "corridor" : "central_image"},
          {"strips", ToJson(strips)},
          {"obstacle_distance_m", obstacle_distance_m},
          {"avoid_angle_rad", avoid_angle_rad},
          {"avoid_fraction", avoid_fraction},
          {"avoid_min_m", avoid_min_m},
          {"avoid_max_m", avoid_max_m},
          {"waypoint_tolerance_m", waypoint_tolerance_m},
          {"goal_tolerance_m", goal_tolerance_m},
          {"avoid_directions", avoid_directions},
          {"avoid_other_side_m", Number(avoid_other_side_m)},
          {"stop_distance_m", stop_distance_m},
          {"slow_distance_m", slow_distance_m},
          {"max_view_age_s", Number(max_view_age_s)},
          {"side_switch_ratio", Number(side_switch_ratio)},
          {"side_hold_m", Number(side_hold_m)},
          {"stuck_after_s", Number(stuck_after_s)},
          {"stuck_progress_m", stuck_progress_m},
          {"memory", ToJson(memory)},
          {"gaze_min_m", gaze_min_m},
          {"gaze_max_m", gaze_max_m},
          {"gaze_height_m", gaze_height_m},
          {"gaze_max_bearing_rad", gaze_max_bearing_rad},
          {"controller", ToJson(controller)}};
}

Json ToJson(const control::ObstacleConfig& c) {
  const auto& [floor_m, pit_m, robot_height_m, min_range_m, max_range_m, max_residual_m, support_px,
               support_tolerance] = c;
  return {{"floor_m", floor_m},
          {"pit_m", pit_m},
          {"robot_height_m", robot_height_m},
          {"min_range_m", min_range_m},
          {"max_range_m", Number(max_range_m)},
          {"max_residual_m", Number(max_residual_m)},
          {"support_px", support_px},
          {"support_tolerance", support_tolerance}};
}

Json ToJson(const hardware::AxisLimits& axis) {
  const auto& [min_rad, max_rad, max_speed_rad_s, max_acceleration_rad_s2] = axis;
  return {{"min_rad", min_rad},
          {"max_rad", max_rad},
          {"max_speed_rad_s", max_speed_rad_s},
          {"max_acceleration_rad_s2", max_acceleration_rad_s2}};
}

Json ToJson(const hardware::HeadGeometry& g) {
  const auto& [X_BN, pan_to_tilt_m, tilt_to_eyes_m, baseline_m, axis_to_optical_centre_m,
               pan_to_tilt_forward_m] = g;
  Json rows = Json::array();
  for (int row = 0; row < 3; ++row) {
    rows.push_back({X_BN(row, 0), X_BN(row, 1), X_BN(row, 2), X_BN(row, 3)});
  }
  return {{"X_BN", std::move(rows)},
          {"pan_to_tilt_m", pan_to_tilt_m},
          {"tilt_to_eyes_m", tilt_to_eyes_m},
          {"baseline_m", baseline_m},
          {"axis_to_optical_centre_m", axis_to_optical_centre_m},
          {"pan_to_tilt_forward_m", pan_to_tilt_forward_m}};
}

Json ToJson(const RobotDescription& robot) {
  Json json = {{"name", robot.name},
               {"radius_m", robot.radius_m},
               {"height_m", robot.height_m},
               {"encoder_step_deg", robot.encoder_step_deg},
               {"head", ToJson(robot.head_geometry)}};
  for (int axis = 0; axis < hardware::kHeadAxisCount; ++axis) {
    json["limits"][std::string(hardware::kHeadAxisNames[axis])] = ToJson(robot.head_limits[axis]);
  }
  if (robot.wheels) {
    const auto& [properties, pulses_per_turn, max_acceleration_m_s2, deadman_s] = *robot.wheels;
    const auto& [metres_per_pulse, effective_track_m, max_wheel_speed_m_s] = properties;
    json["wheels"] = {
        {"metres_per_pulse", metres_per_pulse},           {"effective_track_m", effective_track_m},
        {"max_wheel_speed_m_s", max_wheel_speed_m_s},     {"pulses_per_turn", pulses_per_turn},
        {"max_acceleration_m_s2", max_acceleration_m_s2}, {"deadman_s", deadman_s}};
  }
  return json;
}

}  // namespace

control::NavigatorConfig NavigatorConfigOf(const Scenario& scenario,
                                           const RobotDescription& robot) {
  const NavigationSpec& spec = scenario.navigation;
  control::NavigatorConfig config =
      spec.rule == "paper" ? control::NavigatorConfig::Paper() : control::NavigatorConfig();
  config.obstacle_distance_m = spec.obstacle_limit_m;
  config.strips.corridor_half_width_m = robot.radius_m + kSideRoom_m;
  if (spec.rule != "paper") config.stop_distance_m = robot.radius_m + kFrontRoom_m;
  config.controller.linear.output_limit = spec.cruise_speed_m_s;
  // A view is oldest just before the next one arrives: its own latency, and the next one's cycle.
  const double cycle_s = std::max(scenario.vision.latency_s, 1 / scenario.vision.rate_hz);
  config.max_view_age_s = kViewAgeMargin * (scenario.vision.latency_s + cycle_s);
  return config;
}

control::ObstacleConfig ObstacleConfigOf(const RobotDescription& robot) {
  control::ObstacleConfig config;
  config.robot_height_m = robot.height_m + kHeadroom_m;
  return config;
}

std::string StackRecord(const Scenario& scenario, const RobotDescription& robot) {
  const vision::ReconstructionConfig reconstruction;
  const auto& [min_parallax_rad] = reconstruction;
  const vision::RegionConfig regions;
  const auto& [min_area_px, near_fraction] = regions;
  const VisionSpec& vision = scenario.vision;
  const Json record = {
      {"disparity",
       {{"method", vision.method}, {"preset", vision.preset}, {"scales", vision.scales}}},
      {"reconstruction", {{"min_parallax_rad", min_parallax_rad}}},
      {"segmentation", {{"median_px", vision.median_px}, {"threshold", vision.edge_threshold}}},
      {"regions", {{"min_area_px", min_area_px}, {"near_fraction", near_fraction}}},
      {"obstacles", ToJson(ObstacleConfigOf(robot))},
      {"navigator", ToJson(NavigatorConfigOf(scenario, robot))},
      {"robot", ToJson(robot)}};
  return record.dump(2) + "\n";
}

}  // namespace horopter::scenarios
