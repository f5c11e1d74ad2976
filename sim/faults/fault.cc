// SPDX-License-Identifier: Apache-2.0
#include "sim/faults/fault.h"

#include <fmt/format.h>

#include <cassert>
#include <cmath>

namespace horopter::sim {
namespace {

/// Appends what is wrong with one fault.
class Judge {
 public:
  Judge(std::size_t index, std::vector<hardware::FieldError>& errors)
      : place_(fmt::format("faults[{}]", index)), errors_(errors) {}

  void operator()(const Backlash& f) { NotNegative("width_rad", f.width_rad); }
  void operator()(const EncoderBias& f) { Finite("bias_rad", f.bias_rad); }
  void operator()(const EncoderNoise& f) { NotNegative("std_rad", f.std_rad); }
  void operator()(const StuckAxis&) {}
  void operator()(const ZeroOff& f) {
    Finite("pan_rad", f.pan_rad);
    Finite("tilt_rad", f.tilt_rad);
  }
  void operator()(const WrongBaseline& f) { Finite("error_m", f.error_m); }
  void operator()(const MisalignedEye& f) {
    Finite("pitch_rad", f.pitch_rad);
    Finite("roll_rad", f.roll_rad);
  }
  void operator()(const SwappedPair&) {}
  void operator()(const DarkEye& f) { Share("light", f.light); }
  void operator()(const FrozenFrames&) {}
  void operator()(const LostFrames& f) { Share("share", f.share); }

  void Window(const TimeWindow& when) {
    if (when.until > when.from) return;
    Add("until_s", hardware::ToSeconds(when.until),
        fmt::format("must be later than from_s = {:g}", hardware::ToSeconds(when.from)));
  }

 private:
  void Add(const char* field, double value, std::string constraint) {
    errors_.push_back({place_ + "." + field, fmt::format("{:g}", value), std::move(constraint)});
  }
  void Finite(const char* field, double value) {
    if (!std::isfinite(value)) Add(field, value, "must be finite");
  }
  void NotNegative(const char* field, double value) {
    if (!std::isfinite(value) || value < 0) Add(field, value, "must be finite and not negative");
  }
  void Share(const char* field, double value) {
    if (!(value >= 0 && value <= 1)) Add(field, value, "must be from 0 to 1");
  }

  std::string place_;
  std::vector<hardware::FieldError>& errors_;
};

std::string BaseName(const Fault& fault) {
  if (const auto* noise = std::get_if<EncoderNoise>(&fault.kind)) {
    const auto axis = static_cast<std::size_t>(noise->axis);
    return fmt::format("fault.encoder_noise.{}", hardware::kHeadAxisNames[axis]);
  }
  if (const auto* lost = std::get_if<LostFrames>(&fault.kind)) {
    return fmt::format("fault.lost_frames.{}", ToString(lost->eye));
  }
  return "";
}

}  // namespace

std::vector<hardware::FieldError> Validate(const std::vector<Fault>& faults) {
  std::vector<hardware::FieldError> errors;
  for (std::size_t i = 0; i < faults.size(); ++i) {
    Judge judge(i, errors);
    std::visit(judge, faults[i].kind);
    judge.Window(faults[i].when);
  }
  return errors;
}

std::string StreamName(const std::vector<Fault>& faults, std::size_t index) {
  const std::string name = BaseName(faults[index]);
  assert(!name.empty());
  int before = 0;
  for (std::size_t i = 0; i < index; ++i) before += BaseName(faults[i]) == name;
  return before == 0 ? name : fmt::format("{}.{}", name, before + 1);
}

}  // namespace horopter::sim
