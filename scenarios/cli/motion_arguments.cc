// SPDX-License-Identifier: Apache-2.0
#include "scenarios/cli/motion_arguments.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "hardware/types/head_angles.h"
#include "scenarios/cli/option_text.h"
#include "scenarios/format/suggest.h"

namespace horopter::scenarios {
namespace {

/// "TEXT@SECONDS" in its two halves; without the second it is at the start.
std::pair<std::string, double> Timed(const std::string& option, const std::string& text) {
  const std::size_t at = text.find('@');
  if (at == std::string::npos) return {text, 0};
  const auto seconds = Numbers(std::string_view(text).substr(at + 1));
  if (seconds.size() != 1 || seconds[0] < 0) {
    RefuseOption(option, text, "must end in @SECONDS, from the start on, e.g. @0.2");
  }
  return {text.substr(0, at), seconds[0]};
}

/// Where a saccade keeps an angle of this name; null when it is none.
std::optional<double>* AngleNamed(const std::string& name, SaccadeCommand& saccade) {
  for (std::size_t i = 0; i < saccade.gaze_deg.size(); ++i) {
    if (name + "_deg" == SaccadeCommand::kGazeKeys[i]) return &saccade.gaze_deg[i];
  }
  for (std::size_t i = 0; i < saccade.axis_deg.size(); ++i) {
    if (name == hardware::kHeadAxisNames[i]) return &saccade.axis_deg[i];
  }
  return nullptr;
}

MotionCommand SaccadeOf(const std::string& text) {
  const std::string form = "NAME=DEG,...[@SECONDS], e.g. pan=10,tilt=-5@0.2";
  const auto [angles, at_s] = Timed("--saccade", text);
  SaccadeCommand saccade;
  for (std::size_t begin = 0; begin <= angles.size();) {
    const std::size_t end = std::min(angles.find(',', begin), angles.size());
    const auto [name, values] = NamedNumbers("--saccade", angles.substr(begin, end - begin), form);
    std::optional<double>* angle = AngleNamed(name, saccade);
    if (angle == nullptr) {
      std::vector<std::string> known = {"pan", "tilt", "vergence"};
      known.insert(known.end(), hardware::kHeadAxisNames.begin(), hardware::kHeadAxisNames.end());
      RefuseOption("--saccade", name, "is no axis of a head" + DidYouMean(name, known));
    }
    if (angle->has_value()) RefuseOption("--saccade", name, "stands twice: keep one");
    *angle = values[0];
    begin = end + 1;
  }
  return {at_s, saccade};
}

MotionCommand WalkOf(const std::string& text) {
  const auto [target, at_s] = Timed("--walk", text);
  const auto numbers = Numbers(target);
  if (numbers.size() != 3) {
    RefuseOption("--walk", text, "must be X,Y,TURN[@SECONDS] in m and deg, e.g. 0.3,0,20");
  }
  return {at_s, WalkToCommand{numbers[0], numbers[1], numbers[2]}};
}

MotionCommand DriveOf(const std::string& text) {
  const auto [speeds, at_s] = Timed("--drive", text);
  const auto numbers = Numbers(speeds);
  if (numbers.size() != 2) {
    RefuseOption("--drive", text, "must be SPEED,TURN[@SECONDS] in m/s and deg/s, e.g. 0.2,10");
  }
  return {at_s, DriveCommand{numbers[0], numbers[1]}};
}

}  // namespace

std::optional<Motion> MotionOf(const RenderArguments& a) {
  if (!a.motion.empty()) return ReadMotionFile(a.motion);
  Motion motion;
  for (const std::string& text : a.saccades) motion.commands.push_back(SaccadeOf(text));
  for (const std::string& text : a.walks) motion.commands.push_back(WalkOf(text));
  for (const std::string& text : a.drives) motion.commands.push_back(DriveOf(text));
  if (motion.commands.empty() && !a.duration_s) {
    if (!a.rate_hz) return std::nullopt;
    RefuseOption("--rate", fmt::format("{:g}", *a.rate_hz),
                 "is a motion's: give --motion, --saccade, --walk, --drive or --duration as well");
  }
  motion.duration_s = a.duration_s.value_or(motion.duration_s);
  return motion;
}

void SetRate(const RenderArguments& a, sim::CameraProfile& profile) {
  constexpr double kUsual_hz = 25;
  if (a.rate_hz) profile.timing.rate_hz = *a.rate_hz;
  if (profile.timing.rate_hz <= 0) profile.timing.rate_hz = kUsual_hz;
}

}  // namespace horopter::scenarios
