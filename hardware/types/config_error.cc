// SPDX-License-Identifier: Apache-2.0
#include "hardware/types/config_error.h"

#include <utility>

namespace horopter::hardware {
namespace {

std::string Join(const std::vector<FieldError>& errors) {
  std::string text;
  for (const FieldError& error : errors) {
    if (!text.empty()) text += '\n';
    text += error.ToString();
  }
  return text;
}

}  // namespace

ConfigError::ConfigError(std::vector<FieldError> errors)
    : std::invalid_argument(Join(errors)), errors_(std::move(errors)) {}

void ThrowIfAny(std::vector<FieldError> errors) {
  if (!errors.empty()) throw ConfigError(std::move(errors));
}

}  // namespace horopter::hardware
