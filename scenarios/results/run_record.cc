// SPDX-License-Identifier: Apache-2.0
#include "scenarios/results/run_record.h"

#include <cassert>

namespace horopter::scenarios {

std::string ToString(Outcome outcome) {
  switch (outcome) {
    case Outcome::kPassed:
      return "passed";
    case Outcome::kFailed:
      return "failed";
    case Outcome::kError:
      return "error";
    case Outcome::kIncomplete:
      return "incomplete";
  }
  assert(false);
  return "";
}

std::string ToString(ExpectationOutcome outcome) {
  switch (outcome) {
    case ExpectationOutcome::kPassed:
      return "passed";
    case ExpectationOutcome::kFailed:
      return "failed";
    case ExpectationOutcome::kNotApplicable:
      return "not_applicable";
  }
  assert(false);
  return "";
}

std::string DescribeMachine(const Machine& machine) {
  if (machine.processor.empty() && machine.cores == 0) return "unknown machine";
  const std::string processor = machine.processor.empty() ? "unknown processor" : machine.processor;
  return processor + (machine.cores == 0 ? "" : ", " + std::to_string(machine.cores) + " cores");
}

std::string DescribeBuild(const std::map<std::string, std::string>& versions) {
  const auto version = versions.find("horopter");
  if (version == versions.end()) return "an unknown build";
  const auto program = versions.find("program");
  return version->second + (program == versions.end() ? "" : ", program " + program->second);
}

}  // namespace horopter::scenarios
