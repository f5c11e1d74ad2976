// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string_view>

#include "hardware/types/eye.h"
#include "hardware/types/time.h"
#include "sim/camera/camera_profile.h"

namespace horopter::sim {

/// When one frame of a pair of cameras is taken and when it arrives.
struct FrameTimes {
  hardware::PerEye<hardware::Time> t_capture;  ///< middle of the exposure; whole physics steps
  hardware::Time t_delivered{};
  bool dropped = false;   ///< never arrives
  bool repeated = false;  ///< arrives, but shows the frame before it again
};

/// The frames of a pair of cameras that run freely at a rate, as a function of the frame's number
/// alone: what one frame does depends on no other, and each random property has its own stream.
///
/// The cameras have run since before time zero: frame 0 is taken so early that it is there at time
/// zero, without jitter, and is never dropped or repeated.
class FrameTiming {
 public:
  /// @param timing with a positive rate
  /// @param window from the first row's exposure to the end of the last row's
  /// @param step of the physics, to which capture instants are rounded
  /// @param camera names the streams
  /// @throws hardware::ConfigError when the rate is not positive
  FrameTiming(const TimingProfile& timing, hardware::Duration window, hardware::Duration step,
              std::uint64_t seed, std::string_view camera);

  FrameTimes At(std::uint64_t frame) const;

  /// The newest frame that has been delivered by `now`. @pre now >= time zero
  std::uint64_t NewestDelivered(hardware::Time now) const;

  /// The frame whose exposure `frame` shows: itself, unless it repeats an earlier one.
  std::uint64_t ShownBy(std::uint64_t frame) const;

 private:
  hardware::Time Snap(hardware::Time t) const;

  TimingProfile timing_;
  hardware::Duration half_window_;
  hardware::Duration step_;
  hardware::Time start_{};  ///< capture of frame 0 by the left eye
  std::uint64_t capture_jitter_;
  std::uint64_t delivery_jitter_;
  std::uint64_t drop_;
  std::uint64_t repeat_;
};

}  // namespace horopter::sim
