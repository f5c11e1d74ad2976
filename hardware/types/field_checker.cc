// SPDX-License-Identifier: Apache-2.0
#include "hardware/types/field_checker.h"

#include <cmath>
#include <sstream>
#include <utility>

namespace horopter::hardware {

void FieldChecker::Require(bool good, const std::string& field, double value, const char* rule) {
  if (good) return;
  std::ostringstream text;
  text << value;
  errors_.push_back({prefix_ + field, text.str(), rule});
}

void FieldChecker::Positive(const std::string& field, double value) {
  Require(std::isfinite(value) && value > 0, field, value, "must be finite and positive");
}

void FieldChecker::NotNegative(const std::string& field, double value) {
  Require(std::isfinite(value) && value >= 0, field, value, "must be finite and not negative");
}

void FieldChecker::Part(std::vector<FieldError> errors) {
  for (FieldError& e : errors) {
    errors_.push_back({prefix_ + e.field, std::move(e.value), std::move(e.constraint)});
  }
}

}  // namespace horopter::hardware
