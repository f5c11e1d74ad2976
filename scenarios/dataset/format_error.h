// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>

namespace horopter::scenarios {

/// A file that is not what its format says. `what()` is one line: the file, what is wrong and where
/// in it, and what was expected.
class FormatError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace horopter::scenarios
