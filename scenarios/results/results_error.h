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

}  // namespace horopter::scenarios
