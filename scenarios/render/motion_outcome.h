// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "hardware/types/pose.h"
#include "scenarios/render/motion.h"

namespace horopter::scenarios {

/// What came of one command to legs or wheels, by the truth.
struct CommandOutcome {
  double at_s = 0;
  std::string command;   ///< its key in a motion's file
  bool reached = false;  ///< a target; of a velocity: the robot never stood while told to move
  hardware::Pose2 end;   ///< in the robot's starting frame, when the next one came or the motion
                         ///< ended
};

/// Watches whether a robot comes where it is told to.
///
/// A target counts as reached within 0.05 m and 5 % of the way to it, and 5 deg and 10 % of the
/// turn, for which feet may slip. A robot stands when, over half a second, it moves and turns by
/// less than a tenth of what it is told; a gait's first second is not counted.
class MotionWatch {
 public:
  /// @param base in the robot's starting frame
  void Told(const MotionCommand& command, const hardware::Pose2& base);
  /// @pre t_s later than before
  void Step(double t_s, const hardware::Pose2& base);
  /// Of all commands so far. @param base at the end
  std::vector<CommandOutcome> Outcomes(const hardware::Pose2& base) const;

 private:
  struct Watched {
    MotionCommand command;
    hardware::Pose2 from;
    bool stood = false;
    double since_s = 0;  ///< of the half second under way
    hardware::Pose2 there;
  };
  static CommandOutcome OutcomeOf(const Watched& watched, const hardware::Pose2& end);

  std::vector<CommandOutcome> done_;
  std::optional<Watched> now_;
};

/// For a manifest.
std::string EncodeOutcomes(const std::vector<CommandOutcome>& outcomes);

/// A line for people, empty when all was reached.
std::string WhatWasNotReached(const std::vector<CommandOutcome>& outcomes);

}  // namespace horopter::scenarios
