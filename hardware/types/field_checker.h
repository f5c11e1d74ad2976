// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "hardware/types/config_error.h"

namespace horopter::hardware {

/// Collects what is wrong with a configuration, one call per rule; Take() ends a Validate().
class FieldChecker {
 public:
  /// @param prefix of every field's name, with its dot ("strips.")
  explicit FieldChecker(std::string prefix = "") : prefix_(std::move(prefix)) {}

  /// @param rule what must hold: "must be at least 1"
  void Require(bool good, const std::string& field, double value, const char* rule);
  void Positive(const std::string& field, double value);     ///< finite and above 0
  void NotNegative(const std::string& field, double value);  ///< finite and at least 0
  /// What a part of the configuration has found, under this one's prefix.
  void Part(std::vector<FieldError> errors);

  std::vector<FieldError> Take() { return std::move(errors_); }

 private:
  std::string prefix_;
  std::vector<FieldError> errors_;
};

}  // namespace horopter::hardware
