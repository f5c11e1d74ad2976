// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>

namespace horopter::scenarios {

/// Results that cannot be written or read back. `what()` is one line: the file or folder, the
/// system's reason, and what to do about it.
class ResultsError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Results that a person named and that cannot be used: not there, not a summary, or ambiguous. Bad
/// input, where a ResultsError of any other kind is the machine's fault.
class UnusableResults : public ResultsError {
 public:
  using ResultsError::ResultsError;
};

}  // namespace horopter::scenarios
