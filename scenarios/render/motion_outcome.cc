// SPDX-License-Identifier: Apache-2.0
#include "scenarios/render/motion_outcome.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <variant>

namespace horopter::scenarios {
namespace {

using hardware::Pose2;

constexpr double kRadians = M_PI / 180;
constexpr double kWindow_s = 0.5;
constexpr double kGaitStarts_s = 1;

double Distance(const Pose2& a, const Pose2& b) { return std::hypot(a.x_m - b.x_m, a.y_m - b.y_m); }
double Turn(const Pose2& a, const Pose2& b) {
  return std::abs(std::remainder(a.heading_rad - b.heading_rad, 2 * M_PI));
}

/// What a command for a velocity asks for [m/s, rad/s]; nothing of one for a target.
struct Speed {
  double m_s = 0;
  double rad_s = 0;
};
Speed SpeedOf(const MotionCommand& command) {
  if (const auto* drive = std::get_if<DriveCommand>(&command.what)) {
    return {std::abs(drive->forward_m_s), std::abs(drive->turn_deg_s) * kRadians};
  }
  if (const auto* walk = std::get_if<WalkCommand>(&command.what)) {
    return {std::hypot(walk->forward_m_s, walk->left_m_s), std::abs(walk->turn_deg_s) * kRadians};
  }
  return {};
}

bool Reached(const WalkToCommand& target, const Pose2& from, const Pose2& end) {
  const double c = std::cos(from.heading_rad), s = std::sin(from.heading_rad);
  const Pose2 goal{from.x_m + c * target.x_m - s * target.y_m,
                   from.y_m + s * target.x_m + c * target.y_m,
                   from.heading_rad + target.turn_deg * kRadians};
  const double way = std::hypot(target.x_m, target.y_m);
  return Distance(goal, end) <= 0.05 + 0.05 * way &&
         Turn(goal, end) <= (5 + 0.1 * std::abs(target.turn_deg)) * kRadians;
}

}  // namespace

void MotionWatch::Told(const MotionCommand& command, const Pose2& base) {
  if (std::holds_alternative<SaccadeCommand>(command.what)) return;
  if (now_) done_.push_back(OutcomeOf(*now_, base));
  const bool walks = std::holds_alternative<WalkCommand>(command.what);
  now_ = Watched{command, base, false, command.at_s + (walks ? kGaitStarts_s : 0), base};
}

void MotionWatch::Step(double t_s, const Pose2& base) {
  if (!now_) return;
  Watched& w = *now_;
  if (t_s <= w.since_s) w.there = base;
  if (t_s < w.since_s + kWindow_s) return;
  const Speed told = SpeedOf(w.command);
  const bool moves = Distance(base, w.there) > 0.1 * told.m_s * kWindow_s ||
                     Turn(base, w.there) > 0.1 * told.rad_s * kWindow_s;
  w.stood = w.stood || ((told.m_s > 0 || told.rad_s > 0) && !moves);
  w.since_s = t_s;
  w.there = base;
}

CommandOutcome MotionWatch::OutcomeOf(const Watched& w, const Pose2& end) {
  if (const auto* target = std::get_if<WalkToCommand>(&w.command.what)) {
    return {w.command.at_s, "walk_to", Reached(*target, w.from, end), end};
  }
  const bool drives = std::holds_alternative<DriveCommand>(w.command.what);
  return {w.command.at_s, drives ? "drive" : "walk", !w.stood, end};
}

std::vector<CommandOutcome> MotionWatch::Outcomes(const Pose2& base) const {
  std::vector<CommandOutcome> outcomes = done_;
  if (now_) outcomes.push_back(OutcomeOf(*now_, base));
  return outcomes;
}

std::string EncodeOutcomes(const std::vector<CommandOutcome>& outcomes) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const CommandOutcome& o : outcomes) {
    list.push_back(
        {{"at_s", o.at_s},
         {"command", o.command},
         {"reached", o.reached},
         {"end_pose",
          {{"x_m", o.end.x_m}, {"y_m", o.end.y_m}, {"yaw_deg", o.end.heading_rad / kRadians}}}});
  }
  return list.dump();
}

std::string WhatWasNotReached(const std::vector<CommandOutcome>& outcomes) {
  std::string text;
  for (const CommandOutcome& o : outcomes) {
    if (o.reached) continue;
    text += fmt::format("{}{} at {:g} s: {}; the robot ended at x {:.2f} m, y {:.2f} m",
                        text.empty() ? "" : "; ", o.command, o.at_s,
                        o.command == "walk_to" ? "the target was not reached" : "it stood still",
                        o.end.x_m, o.end.y_m);
  }
  return text;
}

}  // namespace horopter::scenarios
