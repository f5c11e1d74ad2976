// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hardware/types/camera_model.h"
#include "hardware/types/head_geometry.h"

namespace horopter::sim {

/// The two configurations of the webcams on NAO's front plate.
enum class NaoLens {
  kWide,   ///< f = 561 px: 59.4 deg across
  kNarrow  ///< f = 1250 px: 28.7 deg across
};

/// Either camera of the pair, without its lens' distortion: square pixels and a centred principal
/// point. 640 x 480 is the size that the paper crops 600 x 440 from (Nefti-Meziani et al. 2015,
/// section 4.2). @throws hardware::ConfigError when the size is not positive
inline hardware::CameraModel NaoCamera(NaoLens lens, int width = 640, int height = 480) {
  const double focal_px = (lens == NaoLens::kWide ? 561.0 : 1250.0) * width / 640;
  return hardware::CameraModel(
      {width, height, focal_px, focal_px, (width - 1) / 2.0, (height - 1) / 2.0});
}

/// Where the head's axes and the optical centres are in the base frame of scenes/nao/nao.xml.
inline hardware::HeadGeometry NaoHeadGeometry() {
  hardware::HeadGeometry geometry;
  geometry.X_BN.translation().z() = 0.31719 + 0.1265;
  geometry.tilt_to_eyes_m = 0.064;
  geometry.baseline_m = 0.06;
  geometry.axis_to_optical_centre_m = 0.080;
  return geometry;
}

}  // namespace horopter::sim
