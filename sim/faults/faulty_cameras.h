// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "hardware/interfaces/camera_pair.h"
#include "sim/faults/fault.h"

namespace horopter::sim {

/// A camera pair whose frames suffer the faults of drivers and cables: frozen frames and a swapped
/// pair, in this order. Everything else is the inner pair's, dark eyes and lost frames
/// (FrameFaults) among it.
///
/// Whether a fault is there is asked at each image's time of capture; of the swap, at the left
/// one's.
class FaultyCameras final : public hardware::CameraPair {
 public:
  /// `inner` must outlive this. @pre Validate(faults) is empty
  FaultyCameras(hardware::CameraPair& inner, const std::vector<Fault>& faults);

  hardware::Lifecycle lifecycle() const override { return inner_.lifecycle(); }
  hardware::Result<void> Configure() override { return inner_.Configure(); }
  hardware::Result<void> Activate() override { return inner_.Activate(); }
  void Deactivate() override { inner_.Deactivate(); }
  hardware::CameraModel model(hardware::Eye eye) const override { return inner_.model(eye); }

  hardware::Result<hardware::StereoFrame> Grab() override;

 private:
  void Freeze(hardware::Eye eye, hardware::EyeImage& image);

  hardware::CameraPair& inner_;
  std::vector<Fault> faults_;
  hardware::PerEye<hardware::EyeImage> unfrozen_;  ///< last image before a freeze
};

}  // namespace horopter::sim
