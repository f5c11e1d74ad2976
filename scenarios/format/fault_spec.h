// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <variant>

#include "scenarios/format/source_mark.h"

namespace horopter::scenarios {

/// What a scenario can break, in a user's units; what each does is said in sim/faults/fault.h. An
/// axis is one of hardware::kHeadAxisNames, an eye "left" or "right".

struct BacklashFault {
  std::string axis;
  double width_deg = 0;

  bool operator==(const BacklashFault&) const = default;
};

struct EncoderBiasFault {
  std::string axis;
  double bias_deg = 0;

  bool operator==(const EncoderBiasFault&) const = default;
};

struct EncoderNoiseFault {
  std::string axis;
  double std_deg = 0;

  bool operator==(const EncoderNoiseFault&) const = default;
};

struct StuckAxisFault {
  std::string axis;

  bool operator==(const StuckAxisFault&) const = default;
};

struct ZeroOffFault {
  std::string eye;
  double pan_deg = 0;
  double tilt_deg = 0;

  bool operator==(const ZeroOffFault&) const = default;
};

struct WrongBaselineFault {
  double error_m = 0;

  bool operator==(const WrongBaselineFault&) const = default;
};

struct MisalignedEyeFault {
  std::string eye;
  double pitch_deg = 0;
  double roll_deg = 0;

  bool operator==(const MisalignedEyeFault&) const = default;
};

struct SwappedPairFault {
  bool operator==(const SwappedPairFault&) const = default;
};

struct DarkEyeFault {
  std::string eye;
  double light = 0;

  bool operator==(const DarkEyeFault&) const = default;
};

struct FrozenFramesFault {
  std::string eye;

  bool operator==(const FrozenFramesFault&) const = default;
};

struct LostFramesFault {
  std::string eye;
  double share = 0;

  bool operator==(const LostFramesFault&) const = default;
};

using FaultKind = std::variant<BacklashFault, EncoderBiasFault, EncoderNoiseFault, StuckAxisFault,
                               ZeroOffFault, WrongBaselineFault, MisalignedEyeFault,
                               SwappedPairFault, DarkEyeFault, FrozenFramesFault, LostFramesFault>;

struct FaultSpec {
  /// No run lasts longer.
  static constexpr double kForEver_s = 3600;

  SourceMark mark;
  FaultKind kind;
  double from_s = 0;            ///< 0: there from before the start
  double until_s = kForEver_s;  ///< gone from then on

  bool operator==(const FaultSpec&) const = default;
};

}  // namespace horopter::scenarios
