// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "hardware/interfaces/camera_pair.h"
#include "sim/faults/fault.h"
#include "sim/random/random_stream.h"

namespace horopter::sim {

/// A camera pair whose frames suffer the faults of sensors and cables: a dark eye, frozen and lost
/// frames, a swapped pair, in this order. Everything else is the inner pair's.
///
/// Whether a fault is there is asked at each image's time of capture; of the swap, at the left
/// one's.
class FaultyCameras final : public hardware::CameraPair {
 public:
  /// `inner` must outlive this. @pre Validate(faults) is empty
  FaultyCameras(hardware::CameraPair& inner, const std::vector<Fault>& faults, std::uint64_t seed);

  hardware::Lifecycle lifecycle() const override { return inner_.lifecycle(); }
  hardware::Result<void> Configure() override { return inner_.Configure(); }
  hardware::Result<void> Activate() override { return inner_.Activate(); }
  void Deactivate() override { inner_.Deactivate(); }
  hardware::CameraModel model(hardware::Eye eye) const override { return inner_.model(eye); }

  hardware::Result<hardware::StereoFrame> Grab() override;

 private:
  struct Loss {
    LostFrames what;
    TimeWindow when;
    RandomStream random;
  };

  void Darken(hardware::Eye eye, hardware::EyeImage& image) const;
  void Freeze(hardware::Eye eye, hardware::EyeImage& image);
  void Lose(hardware::Eye eye, hardware::EyeImage& image);

  hardware::CameraPair& inner_;
  std::vector<Fault> faults_;
  std::vector<Loss> losses_;
  hardware::PerEye<hardware::EyeImage> unfrozen_;   ///< last image before a freeze
  hardware::PerEye<hardware::EyeImage> delivered_;  ///< last image that was not lost
};

}  // namespace horopter::sim
