// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hardware/interfaces/device.h"
#include "hardware/types/camera_model.h"
#include "hardware/types/stereo_frame.h"

namespace horopter::hardware {

/// Two cameras that are read together.
///
/// Contract (besides Device's):
/// - Grab() is allowed when active. It returns the newest pair: 8-bit BGR images of the size that
///   model() states, capture times no later than delivery, sequence numbers that increase.
/// - In simulation both images are of one physics state unless skew is injected.
/// - The frame owns its pixels: a later Grab() does not change it.
class CameraPair : public Device {
 public:
  virtual CameraModel model(Eye eye) const = 0;
  virtual Result<StereoFrame> Grab() = 0;
};

}  // namespace horopter::hardware
