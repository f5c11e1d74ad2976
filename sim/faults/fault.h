// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "hardware/types/config_error.h"
#include "hardware/types/eye.h"
#include "hardware/types/head_angles.h"
#include "sim/faults/time_window.h"

namespace horopter::sim {

/// What can be wrong with a stereo head. Nothing here reaches the stack but through what it senses:
/// limits, geometry and camera models stay those of a sound head.

/// Play between an axis' motor, which its encoder reads, and the eye: the eye stays behind the
/// motor by half the width, on the side it came from. The head's weight takes up no play.
struct Backlash {
  hardware::HeadAxis axis = hardware::HeadAxis::kLeftPan;
  double width_rad = 0;
};

/// An encoder that reads `bias_rad` too much.
struct EncoderBias {
  hardware::HeadAxis axis = hardware::HeadAxis::kLeftPan;
  double bias_rad = 0;
};

/// Gaussian noise on every reading of one encoder, before it is rounded to whole steps.
struct EncoderNoise {
  hardware::HeadAxis axis = hardware::HeadAxis::kLeftPan;
  double std_rad = 0;
};

/// An axis that stops where it is and ignores commands; released, it goes to the last one.
struct StuckAxis {
  hardware::HeadAxis axis = hardware::HeadAxis::kLeftPan;
};

/// An eye whose axes were zeroed in the wrong place: it stands this much further left (pan) and
/// down (tilt) than its encoders say and its commands ask.
struct ZeroOff {
  hardware::Eye eye = hardware::Eye::kLeft;
  double pan_rad = 0;
  double tilt_rad = 0;
};

/// Eyes that stand `error_m` further apart than the description says (nearer when negative), half
/// of it each.
struct WrongBaseline {
  double error_m = 0;
};

/// A camera that sits crooked in its eye: turned about its optical centre by pitch (down), then
/// roll (its right side down).
struct MisalignedEye {
  hardware::Eye eye = hardware::Eye::kLeft;
  double pitch_rad = 0;
  double roll_rad = 0;
};

/// Left and right image exchanged, as by crossed cables.
struct SwappedPair {};

/// An eye that gets only this share of the light; its sensor's noise stays.
struct DarkEye {
  hardware::Eye eye = hardware::Eye::kLeft;
  double light = 0;
};

/// An eye that delivers the last image from before the fault, as if it were new.
struct FrozenFrames {
  hardware::Eye eye = hardware::Eye::kLeft;
};

/// An eye whose frames are lost at random, each frame of the camera for itself, whether it is asked
/// for or not: the last one that came is delivered again, with the time at which it was taken. The
/// run's first frame always comes.
struct LostFrames {
  hardware::Eye eye = hardware::Eye::kLeft;
  double share = 0;
};

using FaultKind =
    std::variant<Backlash, EncoderBias, EncoderNoise, StuckAxis, ZeroOff, WrongBaseline,
                 MisalignedEye, SwappedPair, DarkEye, FrozenFrames, LostFrames>;

struct Fault {
  FaultKind kind;
  TimeWindow when{};
};

/// Every bad field, as "faults[2].width_rad".
std::vector<hardware::FieldError> Validate(const std::vector<Fault>& faults);

/// The name of a random stream for fault `index`, of which none depends on what other faults there
/// are, but for earlier ones of the same kind on the same axis or eye.
/// @pre the fault is EncoderNoise or LostFrames
std::string StreamName(const std::vector<Fault>& faults, std::size_t index);

}  // namespace horopter::sim
