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

}  // namespace horopter::scenarios
