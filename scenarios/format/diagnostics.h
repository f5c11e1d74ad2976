// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "scenarios/format/scenario.h"

namespace horopter::scenarios {

/// One thing that is wrong with a file, where, and what to do about it.
struct Diagnostic {
  SourceMark mark;
  std::string message;

  /// "file:line:column: message", always a single line.
  std::string ToString() const;
};

/// Everything that is wrong with one file. `what()` has a line per diagnostic, in file order.
class ScenarioError : public std::runtime_error {
 public:
  /// @pre !diagnostics.empty()
  explicit ScenarioError(std::vector<Diagnostic> diagnostics);

  const std::vector<Diagnostic>& diagnostics() const { return diagnostics_; }

 private:
  std::vector<Diagnostic> diagnostics_;
};

/// Throws a ScenarioError with a single diagnostic.
[[noreturn]] void Fail(SourceMark mark, std::string message);

/// Throws ScenarioError when there are diagnostics.
void ThrowIfAny(std::vector<Diagnostic> diagnostics);

/// Text of a user as it appears in a message: on one line, without control characters, shortened
/// to 60 bytes.
std::string Excerpt(const std::string& text);

}  // namespace horopter::scenarios
