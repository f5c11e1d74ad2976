// SPDX-License-Identifier: Apache-2.0
#include "scenarios/format/fault_fields.h"

#include <sstream>
#include <utility>

#include "hardware/types/eye.h"
#include "hardware/types/head_angles.h"
#include "scenarios/format/field_parser.h"
#include "scenarios/format/field_writer.h"
#include "scenarios/format/read_text.h"

namespace horopter::scenarios {
namespace {

constexpr Range kAngle{-45, 45};
constexpr Range kWidth{0, 10};
constexpr Range kNoise{0, 10};
constexpr Range kBaselineError{-0.2, 0.2};
constexpr Range kShare{0, 1};
constexpr Range kFrom{0, FaultSpec::kForEver_s};
constexpr Range kUntil{0, FaultSpec::kForEver_s, true};

void VisitAxis(FieldVisitor& v, std::string& axis) {
  const auto& names = hardware::kHeadAxisNames;
  v.Choice({"axis", "", "Which axis of the head.", true}, {names.begin(), names.end()}, axis);
}

void VisitEye(FieldVisitor& v, std::string& eye) {
  v.Choice({"eye", "", "Which eye.", true},
           {ToString(hardware::Eye::kLeft), ToString(hardware::Eye::kRight)}, eye);
}

void Visit(FieldVisitor& v, BacklashFault& f) {
  VisitAxis(v, f.axis);
  v.Number({"width_deg", "deg", "Play between motor and eye, from stop to stop.", true}, kWidth,
           f.width_deg);
}

void Visit(FieldVisitor& v, EncoderBiasFault& f) {
  VisitAxis(v, f.axis);
  v.Number({"bias_deg", "deg", "How much too much the encoder reads.", true}, kAngle, f.bias_deg);
}

void Visit(FieldVisitor& v, EncoderNoiseFault& f) {
  VisitAxis(v, f.axis);
  v.Number({"std_deg", "deg", "Standard deviation of the noise on every reading.", true}, kNoise,
           f.std_deg);
}

void Visit(FieldVisitor& v, StuckAxisFault& f) { VisitAxis(v, f.axis); }

void Visit(FieldVisitor& v, ZeroOffFault& f) {
  VisitEye(v, f.eye);
  v.Number({"pan_deg", "deg", "How far left of its reading the eye stands."}, kAngle, f.pan_deg);
  v.Number({"tilt_deg", "deg", "How far below its reading the eye stands."}, kAngle, f.tilt_deg);
}

void Visit(FieldVisitor& v, WrongBaselineFault& f) {
  v.Number({"error_m", "m",
            "How much further apart the eyes stand than the robot's description "
            "says.",
            true},
           kBaselineError, f.error_m);
}

void Visit(FieldVisitor& v, MisalignedEyeFault& f) {
  VisitEye(v, f.eye);
  v.Number({"pitch_deg", "deg", "How far down the camera is turned in its eye."}, kAngle,
           f.pitch_deg);
  v.Number({"roll_deg", "deg", "How far its right side is turned down."}, kAngle, f.roll_deg);
}

void Visit(FieldVisitor&, SwappedPairFault&) {}

void Visit(FieldVisitor& v, DarkEyeFault& f) {
  VisitEye(v, f.eye);
  v.Number({"light", "", "Share of the light that the eye still gets."}, kShare, f.light);
}

void Visit(FieldVisitor& v, FrozenFramesFault& f) { VisitEye(v, f.eye); }

void Visit(FieldVisitor& v, LostFramesFault& f) {
  VisitEye(v, f.eye);
  v.Number({"share", "", "Share of the eye's frames that is lost.", true}, kShare, f.share);
}

/// The alternative that makes `fault` a `Kind`, keeping what it has when it is one.
template <typename Kind>
Alternative KindOf(const char* key, const char* doc, FaultSpec& fault) {
  return {{key, "", doc}, std::holds_alternative<Kind>(fault.kind), [&fault](FieldVisitor& v) {
            if (!std::holds_alternative<Kind>(fault.kind)) fault.kind = Kind{};
            Visit(v, std::get<Kind>(fault.kind));
            v.Number({"from_s", "s", "When it begins; 0: before the start."}, kFrom, fault.from_s);
            v.Number({"until_s", "s", "When it is over."}, kUntil, fault.until_s);
          }};
}

std::vector<Alternative> Kinds(FaultSpec& fault) {
  return {
      KindOf<BacklashFault>("backlash", "Play between an axis' motor and its eye.", fault),
      KindOf<EncoderBiasFault>("encoder_bias", "An encoder that reads too much.", fault),
      KindOf<EncoderNoiseFault>("encoder_noise", "An encoder that reads noise.", fault),
      KindOf<StuckAxisFault>("stuck_axis", "An axis that does not move.", fault),
      KindOf<ZeroOffFault>("zero_off", "An eye zeroed in the wrong place.", fault),
      KindOf<WrongBaselineFault>("wrong_baseline", "Eyes at another distance than described.",
                                 fault),
      KindOf<MisalignedEyeFault>("misaligned_eye", "A camera that sits crooked in its eye.", fault),
      KindOf<SwappedPairFault>("swapped_pair", "Left and right image exchanged.", fault),
      KindOf<DarkEyeFault>("dark_eye", "An eye that gets little light, or none.", fault),
      KindOf<FrozenFramesFault>("frozen_frames", "An eye that repeats its last image as if new.",
                                fault),
      KindOf<LostFramesFault>("lost_frames", "An eye that loses frames at random.", fault)};
}

}  // namespace

AlternativeList FaultList(std::vector<FaultSpec>& faults) {
  return {{"faults", "", "What is wrong with head and cameras, unknown to what drives them."},
          faults.size(),
          [&faults](std::size_t index, const SourceMark& mark) {
            if (index == faults.size()) faults.push_back({mark, BacklashFault{}});
            return Kinds(faults[index]);
          }};
}

std::vector<FaultSpec> ReadFaultsFile(const std::filesystem::path& path) {
  std::vector<FaultSpec> faults;
  ParseReport report;
  ParseFields(
      ParseYaml(ReadText(path), path.string()),
      [&faults](FieldVisitor& v) { v.Alternatives(FaultList(faults)); }, report);
  ThrowIfAny(std::move(report.diagnostics));
  return faults;
}

std::string DescribeFault(const FaultSpec& fault) {
  FaultSpec copy = fault;  // the writer reads through the same non-const table as the parser
  for (const Alternative& kind : Kinds(copy)) {
    if (!kind.chosen) continue;
    std::string text = kind.spec.key + ":";
    std::istringstream lines(WriteFields(kind.table));
    const char* before = " ";
    for (std::string line; std::getline(lines, line); before = ", ") {
      std::erase(line, '"');
      std::erase(line, ':');
      text += before + line;
    }
    return text;
  }
  return "";
}

}  // namespace horopter::scenarios
