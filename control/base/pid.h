// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "hardware/types/config_error.h"

namespace horopter::control {

/// Gains and limits of one PID controller. The unit of the output per unit of the error.
struct PidConfig {
  double proportional = 1;
  double integral = 0;      ///< per second
  double derivative = 0;    ///< seconds
  double output_limit = 1;  ///< the output stays in [-output_limit, output_limit]

  /// Every bad field, named under `prefix` ("linear" gives "linear.proportional").
  std::vector<hardware::FieldError> Validate(const std::string& prefix) const;
};

/// Textbook PID on an error signal, sampled at any interval.
///
/// - The derivative acts on the error. The controllers here follow errors of position, whose set
///   point does not jump between two calls but through Reset(); the first update after it has no
///   derivative, so there is no kick.
/// - Anti-windup by conditional integration: the integral does not grow while the output is
///   saturated and the error would drive it further out.
class Pid {
 public:
  /// @throws hardware::ConfigError
  explicit Pid(const PidConfig& config);

  /// @param error set point minus measurement
  /// @param dt_s time since the last update; at 0 neither integral nor derivative act
  /// @return output within the limit
  /// @throws std::invalid_argument when the error is not finite or dt_s is negative
  double Update(double error, double dt_s);

  /// Forgets integral and last error: the set point has jumped.
  void Reset();

  double integral() const { return integral_; }

 private:
  PidConfig config_;
  double integral_ = 0;  ///< the integral term's output
  std::optional<double> last_error_;
};

}  // namespace horopter::control
