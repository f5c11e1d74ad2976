// SPDX-License-Identifier: Apache-2.0
#include "control/base/pid.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "hardware/types/field_checker.h"

namespace horopter::control {

std::vector<hardware::FieldError> PidConfig::Validate(const std::string& prefix) const {
  hardware::FieldChecker check(prefix + ".");
  check.NotNegative("proportional", proportional);
  check.NotNegative("integral", integral);
  check.NotNegative("derivative", derivative);
  check.Positive("output_limit", output_limit);
  return check.Take();
}

Pid::Pid(const PidConfig& config) : config_(config) {
  hardware::ThrowIfAny(config.Validate("pid"));
}

double Pid::Update(double error, double dt_s) {
  if (!std::isfinite(error) || !(dt_s >= 0)) {
    throw std::invalid_argument("pid: error " + std::to_string(error) + ", dt " +
                                std::to_string(dt_s) +
                                ": the error must be finite and the interval not negative");
  }
  double derivative = 0;
  if (last_error_ && dt_s > 0) derivative = config_.derivative * (error - *last_error_) / dt_s;
  last_error_ = error;

  const double limit = config_.output_limit;
  const double without_integral = config_.proportional * error + derivative;
  const double grown = integral_ + config_.integral * error * dt_s;
  const bool winds_up = std::abs(without_integral + grown) > limit &&
                        std::abs(without_integral + grown) > std::abs(without_integral + integral_);
  if (!winds_up) integral_ = std::clamp(grown, -limit, limit);
  return std::clamp(without_integral + integral_, -limit, limit);
}

void Pid::Reset() {
  integral_ = 0;
  last_error_.reset();
}

}  // namespace horopter::control
