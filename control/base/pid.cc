// SPDX-License-Identifier: Apache-2.0
#include "control/base/pid.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace horopter::control {

std::vector<hardware::FieldError> PidConfig::Validate(const std::string& prefix) const {
  std::vector<hardware::FieldError> errors;
  const auto gain = [&](const char* field, double value) {
    if (!(std::isfinite(value) && value >= 0)) {
      errors.push_back({prefix + field, std::to_string(value), "must be finite and not negative"});
    }
  };
  gain(".proportional", proportional);
  gain(".integral", integral);
  gain(".derivative", derivative);
  if (!(std::isfinite(output_limit) && output_limit > 0)) {
    errors.push_back(
        {prefix + ".output_limit", std::to_string(output_limit), "must be finite and positive"});
  }
  return errors;
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
