// SPDX-License-Identifier: Apache-2.0
#include "scenarios/format/fault_config.h"

#include <algorithm>
#include <cmath>

namespace horopter::scenarios {
namespace {

constexpr double kRadians = M_PI / 180;

hardware::HeadAxis AxisOf(const std::string& name) {
  const auto& names = hardware::kHeadAxisNames;
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) {
    throw hardware::ConfigError({{"faults.axis", name, "must be an axis of a head"}});
  }
  return static_cast<hardware::HeadAxis>(found - names.begin());
}

hardware::Eye EyeOf(const std::string& name) {
  for (const hardware::Eye eye : hardware::kBothEyes) {
    if (name == ToString(eye)) return eye;
  }
  throw hardware::ConfigError({{"faults.eye", name, "must be left or right"}});
}

struct Converter {
  sim::FaultKind operator()(const BacklashFault& f) {
    return sim::Backlash{AxisOf(f.axis), f.width_deg * kRadians};
  }
  sim::FaultKind operator()(const EncoderBiasFault& f) {
    return sim::EncoderBias{AxisOf(f.axis), f.bias_deg * kRadians};
  }
  sim::FaultKind operator()(const EncoderNoiseFault& f) {
    return sim::EncoderNoise{AxisOf(f.axis), f.std_deg * kRadians};
  }
  sim::FaultKind operator()(const StuckAxisFault& f) { return sim::StuckAxis{AxisOf(f.axis)}; }
  sim::FaultKind operator()(const ZeroOffFault& f) {
    return sim::ZeroOff{EyeOf(f.eye), f.pan_deg * kRadians, f.tilt_deg * kRadians};
  }
  sim::FaultKind operator()(const WrongBaselineFault& f) { return sim::WrongBaseline{f.error_m}; }
  sim::FaultKind operator()(const MisalignedEyeFault& f) {
    return sim::MisalignedEye{EyeOf(f.eye), f.pitch_deg * kRadians, f.roll_deg * kRadians};
  }
  sim::FaultKind operator()(const SwappedPairFault&) { return sim::SwappedPair{}; }
  sim::FaultKind operator()(const DarkEyeFault& f) { return sim::DarkEye{EyeOf(f.eye), f.light}; }
  sim::FaultKind operator()(const FrozenFramesFault& f) { return sim::FrozenFrames{EyeOf(f.eye)}; }
  sim::FaultKind operator()(const LostFramesFault& f) {
    return sim::LostFrames{EyeOf(f.eye), f.share};
  }
};

}  // namespace

std::vector<sim::Fault> FaultsOf(const std::vector<FaultSpec>& specs) {
  std::vector<sim::Fault> faults;
  for (const FaultSpec& spec : specs) {
    const sim::TimeWindow when{hardware::Time(hardware::FromSeconds(spec.from_s)),
                               spec.until_s >= FaultSpec::kForEver_s
                                   ? hardware::Time::max()
                                   : hardware::Time(hardware::FromSeconds(spec.until_s))};
    faults.push_back({std::visit(Converter{}, spec.kind), when});
  }
  return faults;
}

}  // namespace horopter::scenarios
