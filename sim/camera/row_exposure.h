// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sim/camera/camera_profile.h"

namespace horopter::sim {

/// When each row of an image is exposed, in seconds from the middle of the whole image's exposure.
class RowExposure {
 public:
  /// @pre rows >= 1
  RowExposure(const ShutterProfile& shutter, const ExposureProfile& exposure, int rows)
      : kind_(shutter.kind),
        rows_(rows),
        readout_s_(kind_ == Shutter::kGlobal ? 0 : shutter.readout_s),
        time_s_(exposure.time_s) {}

  /// Middle of a row's exposure.
  double Middle(int row) const {
    switch (kind_) {
      case Shutter::kGlobal:
        return 0;
      case Shutter::kRolling:
        return rows_ > 1 ? readout_s_ * (row / (rows_ - 1.0) - 0.5) : 0;
      case Shutter::kInterlaced:
        return readout_s_ * (row % 2 == 0 ? -0.5 : 0.5);
    }
    return 0;
  }

  Shutter kind() const { return kind_; }
  double time_s() const { return time_s_; }
  /// From the beginning of the first row's exposure to the end of the last row's.
  double window_s() const { return readout_s_ + time_s_; }

 private:
  Shutter kind_;
  int rows_;
  double readout_s_;
  double time_s_;
};

}  // namespace horopter::sim
