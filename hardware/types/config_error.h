// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace horopter::hardware {

/// One bad field of a configuration: "matcher.block_px = 4: must be odd and at least 3".
struct FieldError {
  std::string field;
  std::string value;
  std::string constraint;

  std::string ToString() const { return field + " = " + value + ": " + constraint; }
};

/// Thrown when a configuration does not hold; `what()` lists every bad field, one per line.
class ConfigError : public std::invalid_argument {
 public:
  /// @pre !errors.empty()
  explicit ConfigError(std::vector<FieldError> errors);

  const std::vector<FieldError>& errors() const { return errors_; }

 private:
  std::vector<FieldError> errors_;
};

/// Throws ConfigError when `errors` is not empty: `ThrowIfAny(config.Validate())`.
void ThrowIfAny(std::vector<FieldError> errors);

}  // namespace horopter::hardware
